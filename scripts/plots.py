#!/usr/bin/env python3
"""Pictures of the first plot of reports, for docs/accuracy.md.

usage: plots.py FOLDER ... --out docs/plots

Each folder is one that `whitted report SCENE -o FOLDER` wrote; the picture has the folder's name. Needs: chromium.
"""
import argparse
import os
import re
import subprocess
import tempfile

PAGE = """<!doctype html><html><head>{style}<style>body {{ margin: 0; padding: 8px; background: #fff }}
svg.plot {{ width: 520px; height: 380px }} figure {{ margin: 0 }} .plots {{ display: block }}</style></head>
<body><main><div class="plots"><figure>{plot}</figure></div>{legend}</main></body></html>"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--out", required=True)
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)
    for folder in args.folders:
        with open(os.path.join(folder, "report.html")) as file:
            report = file.read()
        first = lambda pattern: re.search(pattern, report, re.DOTALL)[0]
        page = PAGE.format(style=first(r"<style>.*?</style>"), plot=first(r'<svg class="plot".*?</svg>'),
                           legend=first(r'<ul class="legend">.*?</ul>'))
        with tempfile.NamedTemporaryFile("w", suffix=".html") as file:
            file.write(page)
            file.flush()
            picture = os.path.join(args.out, os.path.basename(os.path.normpath(folder)) + ".png")
            subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                            "--blink-settings=preferredColorScheme=1", f"--screenshot={picture}",
                            "--window-size=560,590", f"file://{file.name}"], check=True, capture_output=True)


if __name__ == "__main__":
    main()
