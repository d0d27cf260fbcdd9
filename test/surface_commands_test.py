# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""surface_commands_test.py PROGRAM WORK_FOLDER

What 'segment', 'reduce' and 'flatten' write, read here by itself; and what they refuse.
"""
import json
import math
import pathlib
import shutil
import struct
import subprocess
import sys

program, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)


def call(*arguments):
    return subprocess.run([program, *map(str, arguments)], cwd=work, text=True, capture_output=True, check=False)


def run(*arguments):
    outcome = call(*arguments)
    assert outcome.returncode == 0 and outcome.stderr == "", outcome
    return outcome.stdout


def refused(code, said, *arguments):
    """it ends with this code and one sentence that holds `said`, and leaves no file behind"""
    before = sorted(work.iterdir())
    outcome = call(*arguments)
    assert outcome.returncode == code, (arguments, outcome)
    assert said in outcome.stderr and outcome.stderr.count("\n") == 1 and outcome.stdout == "", (arguments, outcome)
    assert sorted(work.iterdir()) == before, arguments


def read_ply(name):
    """points, faces, the cells of the faces"""
    data = (work / name).read_bytes()
    at = data.index(b"end_header\n") + len("end_header\n")
    header = data[:at].decode()
    assert "format binary_little_endian 1.0" in header
    code = {"double": "d", "float": "f", "int": "i", "uint": "I", "uchar": "B", "short": "h", "char": "b", "ushort": "H"}

    def value(kind):
        nonlocal at
        (result,) = struct.unpack_from("<" + code[kind], data, at)
        at += struct.calcsize(code[kind])
        return result

    def entry(properties):
        return {words[-1]: [value(words[2]) for _ in range(value(words[1]))] if words[0] == "list" else value(words[0])
                for words in properties}

    elements = {}
    for line in header.splitlines():
        kind, *words = line.split()
        if kind == "element":
            elements[words[0]] = (int(words[1]), [])
        elif kind == "property":
            elements[list(elements)[-1]][1].append(words)
    read = {name: [entry(properties) for _ in range(count)] for name, (count, properties) in elements.items()}
    assert at == len(data)
    return ([(v["x"], v["y"], v["z"]) for v in read["vertex"]], [f["vertex_indices"] for f in read["face"]], [f["cell"] for f in read["face"]])


def euler(points, faces):
    edges = {frozenset(pair) for face in faces for pair in zip(face, face[1:] + face[:1])}
    return len({v for face in faces for v in face}) - len(edges) + len(faces)


axes = (3, 2, 1)
surface = ["--formula", "x^2/9 + y^2/4 + z^2 = 1", "--box", -4, -3, -2, 4, 3, 2, "--resolution", 32]
run("extract", *surface, "-o", "g.graphml", "--cells", "cells.ply", "--quiet")
run("extract", "--formula", "x^2/9 + y^2/4 + z^2 + 0.02*x*y*z = 1", *surface[2:], "-o", "other.graphml", "--cells", "other.ply", "--quiet")

# segment: the cells of an ellipsoid are its octants, on faces that know nothing of them
points = [tuple(a * c for a, c in zip(axes, (math.cos(p) * math.cos(t), math.cos(p) * math.sin(t), math.sin(p))))
          for p in (math.pi * (i / 31 - 0.5) for i in range(1, 31)) for t in (2 * math.pi * j / 60 for j in range(60))]
faces = [[i * 60 + j, i * 60 + (j + 1) % 60, (i + 1) * 60 + (j + 1) % 60, (i + 1) * 60 + j] for i in range(29) for j in range(60)]
(work / "plain.off").write_text(f"OFF\n{len(points)} {len(faces)} 0\n" + "".join("%.17g %.17g %.17g\n" % p for p in points)
                                + "".join("4 %d %d %d %d\n" % tuple(f) for f in faces))
run("segment", "g.graphml", "plain.off", "--surface", "cells.ply", "-o", "labelled.ply", "--quiet")
labelled, labelled_faces, cells = read_ply("labelled.ply")
assert len(labelled_faces) == len(faces)
octants = {}
for face, cell in zip(labelled_faces, cells):
    middle = [sum(labelled[v][a] for v in face) / len(face) for a in range(3)]
    if min(abs(x) / a for x, a in zip(middle, axes)) > 0.06:  # no line runs through it
        octants.setdefault(tuple(x > 0 for x in middle), set()).add(cell)
assert len(octants) == 8 and all(len(c) == 1 for c in octants.values()) and len(set().union(*octants.values())) == 8, octants
refused(1, "plain.off", "segment", "g.graphml", "plain.off", "--surface", "cells.ply", "--tolerance", 1e-9, "-o", "no.ply", "--quiet")

# reduce: as many triangles as were asked for, of the same topology, each with a cell, on the ellipsoid
said = json.loads(run("reduce", "g.graphml", "--surface", "cells.ply", "--faces", 500, "-o", "reduced.ply", "--json"))
points, faces, cells = read_ply("reduced.ply")
assert len(faces) == said["faces"] <= 500 and all(len(face) == 3 for face in faces) and euler(points, faces) == 2
assert set(cells) == set(range(8))
value = [sum((x / a) ** 2 for x, a in zip(p, axes)) for p in points]
assert max(abs(v - 1) for v in value) < 0.05, (min(value), max(value))  # chords of length 0.5 are 0.05 off where k = 3
refused(2, "--faces", "reduce", "g.graphml", "--surface", "cells.ply", "--faces", -5, "-o", "no.ply")

# flatten: each cell a group, of four corners: a unit square, filled once
run("flatten", "g.graphml", "--surface", "cells.ply", "-o", "flat.obj", "--quiet")
places, area, flipped = [], {}, 0
for line in (work / "flat.obj").read_text().splitlines():
    word, *rest = line.split()
    if word == "vt":
        places.append(tuple(map(float, rest)))
    elif word == "g":
        group = rest[0]
        area[group] = 0.0
    elif word == "f":
        (ax, ay), (bx, by), (cx, cy) = (places[int(corner.split("/")[1]) - 1] for corner in rest)
        twice = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        flipped += twice <= 0
        area[group] += twice / 2
assert flipped == 0 and len(area) == 8 and all(abs(a - 1) < 1e-6 for a in area.values()), (flipped, area)
assert all(-1e-12 <= x <= 1 + 1e-12 for place in places for x in place)

# what does not fit together, or is not there, is told in a sentence
for command in ("segment", "reduce", "flatten"):
    output = "no.obj" if command == "flatten" else "no.ply"
    refused(1, "other.ply", command, "g.graphml", "--surface", "other.ply", "-o", output, "--quiet")
    refused(1, "absent.ply", command, "g.graphml", "--surface", "absent.ply", "-o", output, "--quiet")
    refused(1, "absent.graphml", command, "absent.graphml", "--surface", "cells.ply", "-o", output, "--quiet")
    refused(2, "--surface", command, "g.graphml", "-o", output, "--quiet")
    refused(2, "no.xyz", command, "g.graphml", "--surface", "cells.ply", "-o", "no.xyz", "--quiet")
print("segment, reduce and flatten work")
