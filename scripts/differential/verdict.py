"""How different two pictures are, as an eye sees it and as numbers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import OpenEXR

LEVELS = ["same", "slight", "close", "alike", "differs"]


@dataclass
class Verdict:
    """What a comparison says.

    `level` is one of `LEVELS`; `count` says how many pixels show a difference; `pixel` is the clearest
    one (column, row) with its linear values in both pictures; `where` marks all of them.
    """

    level: str
    count: int = 0
    mean: float = 0.0
    pixel: tuple[int, int] = (0, 0)
    theirs: tuple[float, ...] = ()
    ours: tuple[float, ...] = ()
    why: str = ""
    where: np.ndarray | None = None

    def overlaps(self, other: Verdict) -> bool:
        """Returns whether this difference lies where another one does, at least for a good part.

        Used while reducing, so that one difference does not turn into another.
        """
        if self.where is None or other.where is None or self.where.shape != other.where.shape:
            return self.why[:10] == other.why[:10]
        both = int((self.where & other.where).sum())
        return both >= 0.3 * self.count and both >= min(8, 0.3 * other.count)

    def line(self) -> str:
        """Returns the verdict in a line."""
        if self.why:
            return f"{self.level}: {self.why}"
        show = lambda values: " ".join(f"{v:.5g}" for v in values)
        return (f"{self.level}: {self.count} pixels, mean {self.mean:.2f}; at {self.pixel[0]},{self.pixel[1]}"
                f" POV-Ray {show(self.theirs)}, ours {show(self.ours)}")


def load(path) -> np.ndarray:
    """Returns the picture as linear values, height x width x 3 or 4 (with alpha)."""
    channels = OpenEXR.File(str(path)).channels()
    for name in ("RGBA", "RGB"):
        if name in channels:
            return channels[name].pixels.astype(np.float64)
    return np.stack([channels[c].pixels for c in "RGBA" if c in channels], axis=-1).astype(np.float64)


def shown(linear: np.ndarray) -> np.ndarray:
    """Returns display values between 0 and 255: clamped and encoded as sRGB."""
    v = np.clip(np.nan_to_num(linear, nan=0.0), 0.0, 1.0)
    return 255.0 * np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


def solid(mask: np.ndarray) -> np.ndarray:
    """Returns where a pixel and its eight neighbours are all in the mask: no lone pixels, no edges of rounding."""
    inner = mask.copy()
    inner[[0, -1], :] = False
    inner[:, [0, -1]] = False
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            inner &= np.roll(mask, (dy, dx), (0, 1))
    return inner


def compare(theirs_path, ours_path) -> Verdict:
    """Compares two EXR files."""
    return judge(load(theirs_path), load(ours_path))


def judge(theirs: np.ndarray, ours: np.ndarray) -> Verdict:
    """Compares two pictures.

    Alpha counts as a fourth display channel. Beside the levels of display values there is *slight*: the eye sees
    nothing, but one pixel in fifty, or a whole patch of 3 x 3, is off by more than files in half precision explain,
    or lies above white. Pixels that are not finite in POV-Ray's picture are not judged.
    """
    if theirs.shape != ours.shape:
        return Verdict("differs", why=f"size {ours.shape} instead of {theirs.shape}")
    void = ~np.isfinite(theirs).all(-1)
    theirs, ours = np.where(void[..., None], 0, theirs), np.where(void[..., None], 0, ours)
    strange = ~np.isfinite(ours).all(-1)
    if strange.any():
        y, x = np.argwhere(strange)[0]
        return Verdict("differs", int(strange.sum()), why=f"not finite at {x},{y}, POV-Ray {theirs[y, x]}")
    difference, error = distances(theirs, ours)
    level = shown_level(difference)
    where = off(theirs, ours)
    if level == "same" and (where.mean() > 0.02 or solid(where).any()):
        level = "slight"
    score = np.where(solid(where), difference + np.minimum(error, 9) + 1000, difference + np.minimum(error, 9))
    y, x = np.unravel_index(np.argmax(score), score.shape)
    return Verdict(level, int(where.sum()), float(difference.mean()), (int(x), int(y)), tuple(theirs[y, x]), tuple(ours[y, x]), where=where)


def distances(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns for each pixel how far two pictures are apart in display values, and relative to the brighter one."""
    a, b = np.nan_to_num(a, posinf=6e4, neginf=-6e4), np.nan_to_num(b, posinf=6e4, neginf=-6e4)
    return np.abs(shown(a) - shown(b)).max(-1), (np.abs(a - b) / (0.003 + np.maximum(np.abs(a), np.abs(b)))).max(-1)


def off(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns which pixels of two pictures show a difference."""
    difference, error = distances(a, b)
    return (difference > 2) | (error > 0.02)


def shown_level(difference: np.ndarray) -> str:
    """Returns the level of display differences: shares of pixels within 2, 8 and 24 of 255, and their mean."""
    for level, within, share, mean in (("same", 2, 0.995, 0.25), ("close", 8, 0.98, 1.0), ("alike", 24, 0.9, 6.0)):
        if (difference <= within).mean() >= share and difference.mean() <= mean:
            return level
    return "differs"
