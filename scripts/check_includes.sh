#!/usr/bin/env bash
# Compares our embedded include files with the installed ones, both used by POV-Ray itself.
#
#   scripts/check_includes.sh             all of tests/includes
#   scripts/check_includes.sh colors      only tests/includes/colors.pov
#
# POV-Ray looks for an include file in the current folder before its library: run in an empty folder a test scene gets
# the installed file, run in src/include it gets ours. The lines that a scene prints with a leading @ must be equal, and
# its picture must be the same to the last byte.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/empty"

run() { # folder name scene
  (cd "$1" && povray "+I$3" "+O$work/$2.ppm" +FP16 -D -P -A +WT1 +W128 +H96 > /dev/null 2> "$work/$2.log" < /dev/null)
  local code=$?
  grep -a '^@' "$work/$2.log" > "$work/$2.txt"
  if [ $code -ne 0 ]; then
    grep -aE -A2 'Error' "$work/$2.log" | head -5
    return 1
  fi
}

# The pixels of a picture; its header holds the time.
pixels() { tail -c $((128 * 96 * 6)) "$work/$1.ppm"; }

failed=0
for name in "${@:-}"; do
  for scene in "$root"/tests/includes/${name:-*}.pov; do
    label=$(basename "$scene" .pov)
    problem=""
    run "$work/empty" theirs "$scene" || problem="fails with the installed file"
    run "$root/src/include" ours "$scene" || problem="${problem:-fails with ours}"
    if [ -z "$problem" ] && ! diff "$work/theirs.txt" "$work/ours.txt" > "$work/difference"; then
      problem="prints other values"
      head -"${LINES_SHOWN:-12}" "$work/difference"
    fi
    if [ -z "$problem" ] && ! cmp -s <(pixels theirs) <(pixels ours); then
      problem="has another picture"
      [ -n "${KEEP:-}" ] && cp "$work/theirs.ppm" "$KEEP/theirs_$label.ppm" && cp "$work/ours.ppm" "$KEEP/ours_$label.ppm"
    fi
    if [ -z "$problem" ]; then
      echo "same    $label ($(wc -l < "$work/ours.txt") values)"
    else
      echo "DIFFERS $label: $problem"
      failed=1
    fi
  done
done
exit $failed
