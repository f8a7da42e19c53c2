"""Asks POV-Ray for numbers: the one way our probe scripts talk to it.

POV-Ray is used as a black box: a scene writes the values of SDL expressions through `#debug`, a one-pixel picture is
rendered, and the values are read back from the message stream. Nothing else of POV-Ray is looked at.
"""

import subprocess
import tempfile
from pathlib import Path


def run(scene: str) -> str:
    """Runs POV-Ray on the text of a scene and returns its messages; raises when POV-Ray refuses the scene."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "probe.pov"
        path.write_text(scene)
        command = ["povray", f"+I{path}", "-D", "-F", "+W1", "+H1", "+WT1", "-A"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace")
    if done.returncode != 0:
        raise RuntimeError(done.stderr[-3000:])
    return done.stderr


def values(expressions: list[str], setup: str = "") -> list[float]:
    """Returns the value of each float expression, printed with 17 decimals, evaluated after the statements `setup`."""
    lines = ["#version 3.7; global_settings { assumed_gamma 1 }", setup]
    lines += [f'#debug concat("@", str({expression}, 0, 17), "\\n")' for expression in expressions]
    found = [float(line[1:]) for line in run("\n".join(lines)).splitlines() if line.startswith("@")]
    assert len(found) == len(expressions), f"asked {len(expressions)}, got {len(found)}"
    return found
