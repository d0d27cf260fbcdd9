#!/usr/bin/python3
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""move_image.py IN.nrrd OUT.nrrd [--turn DEGREES] [--move X Y Z] [--noise SHARE]

Makes a second scan of what is in an image: turned about the vertical axis through its centre, moved by so many mm, sampled anew by cubic
convolution on voxels of another size, with Gaussian noise of a share of the range of its values. For gallery and tutorials; needs numpy.
"""
import argparse
import gzip

import numpy as np


def read_nrrd(file):
    """voxels [i, j, k] and spacings of a gzipped NRRD of little-endian floats that tells nothing else of where it is"""
    with open(file, "rb") as stream:
        header, data = stream.read().split(b"\n\n", 1)
    fields = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line)
    if (fields["type"], fields["encoding"], fields["endian"]) != ("float", "gzip", "little"):
        raise SystemExit(f"{file}: not a gzipped NRRD of little-endian floats")
    sizes = [int(n) for n in fields["sizes"].split()]
    spacings = np.array([float(x) for x in fields["spacings"].split()])
    voxels = np.frombuffer(gzip.decompress(data), "<f4").reshape(sizes, order="F")
    return voxels, spacings


def write_nrrd(file, voxels, spacings, origin):
    lines = ["NRRD0004", "type: float", "dimension: 3", "space: left-posterior-superior",
             "sizes: " + " ".join(str(n) for n in voxels.shape),
             "space directions: " + " ".join(f"({','.join(repr(float(x)) for x in axis)})" for axis in np.diag(spacings)),
             "encoding: gzip", "endian: little", f"space origin: ({','.join(repr(float(x)) for x in origin)})"]
    with open(file, "wb") as stream:
        stream.write("\n".join(lines).encode() + b"\n\n")
        stream.write(gzip.compress(voxels.astype("<f4").tobytes(order="F"), mtime=0))


def weights(t):
    """of the four nodes around, by Keys' cubic convolution"""
    return [((-0.5 * t + 1) * t - 0.5) * t, (1.5 * t - 2.5) * t * t + 1, ((-1.5 * t + 2) * t + 0.5) * t, (0.5 * t - 0.5) * t * t]


def sample(voxels, at):
    """values at fractional indices (3, n); beyond the border the nearest voxel's"""
    base = np.floor(at).astype(int)
    share = [weights(t) for t in at - base]
    index = [[np.clip(base[a] + d, 0, voxels.shape[a] - 1) for d in (-1, 0, 1, 2)] for a in range(3)]
    result = np.zeros(at.shape[1])
    for i in range(4):
        for j in range(4):
            for k in range(4):
                result += share[0][i] * share[1][j] * share[2][k] * voxels[index[0][i], index[1][j], index[2][k]]
    return result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("input")
    parser.add_argument("output")
    parser.add_argument("--turn", type=float, default=0)
    parser.add_argument("--move", type=float, nargs=3, default=[0, 0, 0])
    parser.add_argument("--noise", type=float, default=0)
    options = parser.parse_args()

    voxels, spacings = read_nrrd(options.input)
    centre = spacings * (np.array(voxels.shape) - 1) / 2
    c, s = np.cos(np.radians(options.turn)), np.sin(np.radians(options.turn))
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])

    # a box that holds the turned image, with voxels of 0.95 of the size
    step = 0.95 * spacings
    half = np.abs(turn) @ (spacings * np.array(voxels.shape) / 2)
    sizes = np.ceil(2 * half / step).astype(int)
    new_centre = centre + options.move
    new_origin = new_centre - step * (sizes - 1) / 2
    nodes = np.stack(np.meshgrid(*[new_origin[a] + step[a] * np.arange(sizes[a]) for a in range(3)], indexing="ij"), 0).reshape(3, -1)
    back = turn.T @ (nodes - new_centre[:, None]) + centre[:, None]
    moved = sample(voxels, back / spacings[:, None]).reshape(sizes)
    moved += options.noise * np.ptp(voxels) * np.random.default_rng(1).standard_normal(moved.shape)
    write_nrrd(options.output, moved, step, new_origin)


if __name__ == "__main__":
    main()
