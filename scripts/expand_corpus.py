#!/usr/bin/env python3
"""Expand scenes and see whether they are still the same.

usage: expand_corpus.py --corpus DIR [--binary PATH] [--only SUBSTRING ...] [--bits] [--povray] [--golden]

--bits    renders each scene directly and as `whitted expand` writes it, and compares the pixels to the bit; expands the
          expanded text, too, which must be the same text again
--povray  renders the expanded text with POV-Ray and judges the picture against POV-Ray's own of the scene
--golden  takes the scenes below golden/ and examples/, not those of POV-Ray's package

DIR is the folder of the sample scenes' table, reference pictures and judge.py. Needs: pip install numpy OpenEXR
"""
import argparse
import glob
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = "/usr/share/doc/povray/examples"
INCLUDE = "/usr/share/povray-3.7/include"


def run(command, folder, timeout):
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=timeout,
                              stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return 1, "timeout"
    said = done.stderr.strip().splitlines()
    return done.returncode, next((line for line in said if "rror" in line), said[-1] if said else "")


def ours(args, folder, scene, image):
    return run([args.binary, "render", scene, "--output", image, "--width", str(args.width), "--height",
                str(args.width * 3 // 4), "--antialias", "off", "--threads", "1", "--include", INCLUDE, "--allow-read", SCENES], folder, args.timeout)


def same_bits(a, b):
    import numpy
    import OpenEXR
    pixels = [{name: channel.pixels for name, channel in OpenEXR.File(path).channels().items()} for path in (a, b)]
    return pixels[0].keys() == pixels[1].keys() and all(
        numpy.array_equal(pixels[0][name].view(numpy.uint8), pixels[1][name].view(numpy.uint8)) for name in pixels[0])


def expand(args, folder, scene, text):
    return run([args.binary, "expand", scene, "-o", text, "-W", str(args.width), "-H", str(args.width * 3 // 4),
                "--include", INCLUDE, "--allow-read", SCENES], folder, args.timeout)


def check(args, source, reference, work):
    """What there is to say about a scene: a word for each check."""
    folder, name = os.path.split(source)
    text, again = os.path.join(work, "scene.pov"), os.path.join(work, "again.pov")
    code, why = expand(args, folder, name, text)
    if code:
        return ["unread", why]
    size = os.path.getsize(text)
    found = [f"{size}"]
    if args.bits:
        first, second = os.path.join(work, "a.exr"), os.path.join(work, "b.exr")
        code, why = ours(args, folder, name, first)
        if code:
            return ["unrendered", why]
        code, why = ours(args, work, text, second)
        found.append(f"refused: {why}" if code else "bits" if same_bits(first, second) else "OTHER BITS")
        if not code:
            expand(args, work, text, again)
            with open(text) as one, open(again) as two:
                found.append("text" if one.read() == two.read() else "OTHER TEXT")
    if args.povray and reference:
        image = os.path.join(work, "povray.exr")
        code, why = run(["povray", f"+I{text}", f"+O{image}", "+FE", "+W160", "+H120", "-A", "-D", "-P", "+WT1",
                         f"+L{INCLUDE}", f"+L{folder}"], folder, args.timeout)
        if code:
            found.append(f"povray: {why}")
        else:
            sys.path.insert(0, args.corpus)
            from judge import judge
            found.append(judge(reference, image)[0])
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--corpus", required=True)
    parser.add_argument("--binary", default="target/release/whitted")
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--core", action="store_true", help="scenes without media, radiosity, photons and the like")
    parser.add_argument("--width", type=int, default=160, help="of our pictures; POV-Ray's are always 160 x 120")
    parser.add_argument("--timeout", type=float, default=300)
    for flag in ("bits", "povray", "golden"):
        parser.add_argument(f"--{flag}", action="store_true")
    args = parser.parse_args()
    args.binary = os.path.abspath(args.binary)
    if args.golden:
        root = os.path.dirname(HERE)
        todo = sorted(glob.glob(f"{root}/golden/**/*.pov", recursive=True) + glob.glob(f"{root}/examples/*.pov"))
        todo = [(scene, scene, None) for scene in todo]
    else:
        with open(os.path.join(args.corpus, "scenes.tsv")) as table:
            rows = [line.rstrip("\n").split("\t") for line in table if not line.startswith("#")]
        picture = lambda scene: os.path.join(args.corpus, "reference", scene[:-4].replace("/", "_") + ".exr")
        todo = [(row[0], os.path.join(SCENES, row[0]), picture(row[0])) for row in rows if not args.core or row[1] == "core"]
    counts = {}
    for scene, source, reference in todo:
        if args.only and not any(part in scene for part in args.only):
            continue
        with tempfile.TemporaryDirectory() as work:
            found = check(args, source, reference, work)
        print("\t".join([scene, *found]), flush=True)
        for word in found:
            if not word.isdigit():
                word = word.split(":")[0]
                counts[word] = counts.get(word, 0) + 1
    print(counts)


if __name__ == "__main__":
    main()
