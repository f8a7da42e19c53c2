"""Reads three EXR files of one scene with OpenEXR: plain, with all layers, and a part; fails where they disagree.

The scene and the calls stand in exr.rs beside this file.
"""

import json
import sys

import numpy as np
import OpenEXR

TERMS = ["emission", "direct", "reflection", "refraction", "background", "atmosphere"]


def read(path):
    """The channels of a file by name, and its header."""
    file = OpenEXR.File(path, separate_channels=True)
    return {name: np.asarray(channel.pixels) for name, channel in file.channels().items()}, file.header()


def three(channels, layer, names="RGB"):
    """A layer as height x width x 3."""
    return np.stack([channels[f"{layer}.{name}"] for name in names], -1).astype(float)


plain, _ = read(sys.argv[1])
channels, header = read(sys.argv[2])
part, part_header = read(sys.argv[3])

# The colours are the same bits with layers and without, and the terms of light add up to them.
for name in "RGB":
    assert np.array_equal(plain[name], channels[name]), name
beauty = np.stack([channels[name] for name in "RGB"], -1)
assert np.abs(sum(three(channels, term) for term in TERMS) - beauty).max() < 3e-6

# Depth is the way along the view from <0, 2, -6> towards <0, 0.5, 0>.
forward = np.array([0, -1.5, 6]) / np.hypot(1.5, 6)
seen = channels["Z"] < 1e9
depth = (three(channels, "P", "XYZ") - [0, 2, -6]) @ forward
assert np.abs(depth - channels["Z"])[seen].max() < 1e-4
assert seen.mean() > 0.5 and not seen.all()

# Normals are unit vectors where one sample was enough, and look at the viewer.
single = seen & (channels["samples.Y"] == 1)
for layer in ("N", "Ng"):
    normal = three(channels, layer, "XYZ")
    assert np.abs(np.linalg.norm(normal, axis=-1) - 1)[single].max() < 1e-5, layer
to_viewer = np.array([0, 2, -6]) - three(channels, "P", "XYZ")
assert (np.sum(three(channels, "Ng", "XYZ") * to_viewer, -1)[single] > 0).all()

# Cryptomatte: the manifest knows every id, and shares are those of samples.
prefix = next(key for key in header if key.startswith("cryptomatte/") and header[key] == "CryptoObject")[:-4]
assert header[prefix + "hash"] == "MurmurHash3_32" and header[prefix + "conversion"] == "uint32_to_float32"
manifest = {name: int(number, 16) for name, number in json.loads(header[prefix + "manifest"]).items()}
assert set(manifest) == {"plane", "Ball", "Ball.001", "Glass", "sphere"}, manifest
total = np.zeros(seen.shape)
for layer in range(3):
    for number, share in ("RG", "BA"):
        ids = channels[f"CryptoObject{layer:02}.{number}"]
        shares = channels[f"CryptoObject{layer:02}.{share}"]
        assert ids.dtype == np.float32
        assert set(ids[shares > 0].view(np.uint32)) <= set(manifest.values())
        total += shares
assert np.abs(total[single] - 1).max() < 1e-6 and total.max() < 1 + 1e-5
assert (np.abs(total[~seen]) == 0).all()

# A part lies in its place and has the whole picture's values.
low, high = part_header["dataWindow"]
assert (tuple(low), tuple(high)) == ((10, 20), (49, 44)), part_header["dataWindow"]
assert tuple(part_header["displayWindow"][1]) == (79, 59)
for name in part:
    assert np.array_equal(part[name], channels[name][20:45, 10:50]), name
assert set(part) == {"R", "G", "B", "Z", "N.X", "N.Y", "N.Z"}
