# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""meshlab_test.py PROGRAM WORK_FOLDER

MeshLab reads the meshes that the program writes, whole, and the program what MeshLab writes. Exit code 77: MeshLab or Xvfb, without which it
does not start, is missing.
"""
import pathlib
import re
import shutil
import subprocess
import sys

program, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
for tool, package in (("meshlabserver", "meshlab"), ("xvfb-run", "xvfb"), ("xauth", "xauth")):
    if not shutil.which(tool):
        print(f"skipped: there is no {tool}; the package {package} brings it")
        sys.exit(77)
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)


def run(*arguments):
    return subprocess.run([program, *arguments], cwd=work, text=True, capture_output=True, check=True).stdout


def meshlab(source, target):
    """has MeshLab read a file and write another one. \return how many vertices and triangles it has read, those counted that are flat in its single
    precision, which it drops"""
    outcome = subprocess.run(["xvfb-run", "-a", "meshlabserver", "-i", source, "-o", target], cwd=work, text=True,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False)
    loaded = re.search(r"loaded has (\d+) vn (\d+) fn", outcome.stdout)
    assert loaded and (work / target).exists(), f"{source}:\n{outcome.stdout[-1000:]}"
    flat = re.search(r"contains (\d+) degenerate faces", outcome.stdout)
    return int(loaded[1]), int(loaded[2]) + int(flat[1] if flat else 0)


def off_triangles(file):
    """vertices of an OFF file, and triangles that its faces make"""
    lines = (work / file).read_text().splitlines()
    vertices, faces, _ = map(int, lines[1].split())
    return vertices, sum(int(line.split()[0]) - 2 for line in lines[2 + vertices:2 + vertices + faces])


ellipsoid = ["--formula", "x^2/9 + y^2/4 + z^2 + 0.02*sin(3*x)*cos(2*y + 1) = 1", "--box", "-4", "-3", "-2", "4", "3", "2", "--resolution", "32"]
run("extract", *ellipsoid, "-o", "g.graphml", "--cells", "cells.ply", "-o", "lines.obj", "-o", "lines.ply", "--lines", "tubes.off", "--quiet")
run("extract", *ellipsoid, "-o", "g.graphml", "--cells", "cells.off", "--surface", "surface.off", "--quiet")

for file in ("cells.off", "tubes.off", "surface.off"):
    assert meshlab(file, "again.ply") == off_triangles(file), file
assert meshlab("cells.ply", "again.ply") == off_triangles("cells.off")  # the same polygons
points = sum(line.startswith("v ") for line in (work / "lines.obj").read_text().splitlines())
assert meshlab("lines.obj", "again.obj")[0] == points  # MeshLab shows the points of polylines
assert meshlab("lines.ply", "again.obj")[0] == points

# what comes back from MeshLab is a mesh like any other
assert meshlab("surface.off", "back.ply")[1] > 1000
text = run("extract", "back.ply", "--radius", "0.6", "-o", "back.graphml")
assert re.search(r"closed surface, 1 component, Euler characteristic 2", text) and "all hold" in text, text
print("MeshLab reads all")
