#!/usr/bin/env bash
# Makes the reference pictures of the golden scenes with POV-Ray 3.7: only POV-Ray makes these.
#
#   golden/render_references.sh                  renders the scenes that have no picture yet, or an older one
#   golden/render_references.sh --all            renders every scene again
#   golden/render_references.sh golden/a.pov …   renders the scenes named
#
# Size and options stand in the scene's .toml. No display, no antialiasing, one thread; EXR holds half floats.
set -euo pipefail
cd "$(dirname "$0")"
here=$PWD

case "${1:-}" in
  --all) mapfile -t scenes < <(find . -name '*.pov' | sort) ;;
  "") mapfile -t scenes < <(find . -name '*.pov' | sort | while read -r scene; do
        if [ ! "${scene%.pov}.exr" -nt "$scene" ] || [ ! "${scene%.pov}.exr" -nt "${scene%.pov}.toml" ]; then
          echo "$scene"
        fi
      done) ;;
  *) scenes=(); for scene in "$@"; do scenes+=("${scene#golden/}"); done ;;
esac

field() { sed -n "s/^$2 = //p" "$1"; }

failed=0
for scene in "${scenes[@]}"; do
  toml=${scene%.pov}.toml
  mapfile -t options < <(field "$toml" options | tr -d '[]" ' | tr ',' '\n' | sed '/^$/d')
  command=(povray "+I$(basename "$scene")" "+O$(basename "${scene%.pov}").exr" +FE -D -P -A +WT1
    "+W$(field "$toml" width)" "+H$(field "$toml" height)" "${options[@]}")
  if log=$(cd "$here/$(dirname "$scene")" && "${command[@]}" 2>&1 < /dev/null); then
    echo "rendered $scene"
  else
    failed=1
    echo "FAILED $scene" >&2
    grep -aiE 'error|fatal' <<< "$log" >&2 || true
  fi
  # Warnings are shown: a golden scene should not need them.
  grep -aE '(Parse|Render) Warning' <<< "$log" | sed "s|^|  $scene: |" || true
done
find . -name '*.pov-state' -delete
exit $failed
