#!/usr/bin/env python3
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs ours beside ITK, VTK and CGAL on the same inputs, in turn, and tells the medians and their ratios.

compare.py BUILD [--csv FILE] [--runs N] [--size N] [--sides N] [--quick]
"""
import argparse
import csv
import json
import os
import platform
import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path


class Run:
    """One program, run once: CPU seconds and peak memory of the process, and what it says itself."""

    def __init__(self, command, cwd):
        process = subprocess.Popen([str(c) for c in command], stdout=subprocess.PIPE, cwd=cwd)
        output = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))}: exit code {process.returncode}")
        self.whole = usage.ru_utime + usage.ru_stime
        self.peak = usage.ru_maxrss * 1024
        text = output.decode()
        self.told = json.loads(text) if text.startswith("{") else {}
        self.seconds = self.told.get("seconds", self.whole)


class Comparison:
    def __init__(self, arguments, folder):
        self.folder, self.runs = folder, arguments.runs
        build = Path(arguments.build).resolve()
        self.programs = build / "benchmark/comparison"
        self.extremal_mesh = build / "src/tool/extremal_mesh"
        self.rows = []
        print(f"{'':58} {'ours':>9} {'theirs':>9} {'ratio':>7}  {'must':>5} {'aim':>5}   peak MB")

    def has(self, program):
        return (self.programs / program).exists()

    def run(self, command):
        program = command[0] if command[0] == self.extremal_mesh else self.programs / command[0]
        return Run([program, *command[1:]], self.folder)

    def add(self, what, ours, theirs, unit, ratio, must, aim, peak=(0, 0)):
        self.rows.append({"what": what, "ours": ours, "theirs": theirs, "unit": unit, "ratio": ratio, "must": must,
                          "aim": aim, "our peak bytes": peak[0], "their peak bytes": peak[1]})
        memory = f"{peak[0] / 1e6:6.0f} {peak[1] / 1e6:6.0f}" if peak[0] else ""
        print(f"{what:58} {ours:9.4g} {theirs:9.4g} {ratio:7.3g}  {must:>5} {aim:>5}   {memory}", flush=True)

    def against(self, theirs, rows):
        """compares times, ours and theirs in turn, after a run of each of ours that is not counted.

        rows: (what, ours, must, aim, whole, faster); whole: of whole processes, not of what they say themselves; faster: the
        ratio says how many times faster ours is, else how much of their time it takes."""
        if not self.has(theirs[0]):
            return
        for _, ours, *_ in rows:
            self.run(ours)
        rounds = [(self.run(theirs), [self.run(row[1]) for row in rows]) for _ in range(self.runs)]
        for i, (what, _, must, aim, whole, faster) in enumerate(rows):
            time = (lambda run: run.whole) if whole else (lambda run: run.seconds)
            pairs = [(time(ours[i]), time(their)) for their, ours in rounds]
            ratio = statistics.median(b / a if faster else a / b for a, b in pairs)
            self.add(what, *(statistics.median(pair[j] for pair in pairs) for j in (0, 1)), "s", ratio, must, aim,
                     (rounds[0][1][i].peak, rounds[0][0].peak))

    def told(self, what, key, ours, theirs, must, aim):
        """compares what programs find out rather than their times."""
        if self.has(theirs[0]):
            a, b = (self.run(command).told[key] for command in (ours, theirs))
            self.add(what, a, b, "", b / a, must, aim)

    def alone(self, what, ours, unit, value, must="", aim="", runs=1):
        """something of one program: memory, or how its time grows."""
        value = statistics.median(value(self.run(ours)) for _ in range(runs))
        self.rows.append({"what": what, "ours": value, "unit": unit, "must": must, "aim": aim})
        print(f"{what:58} {value:9.4g} {unit:17}  {must:>5} {aim:>5}", flush=True)
        return value

    def ratio(self, what, value, must, aim=""):
        self.rows.append({"what": what, "ratio": value, "must": must, "aim": aim})
        print(f"{what:58} {'':19} {value:7.3g}  {must:>5} {aim:>5}", flush=True)


def images(c, size):
    c.run(["make_inputs", "volume", size, 0, "clean.mha"])
    c.run(["make_inputs", "volume", size, 50, "noisy.mha"])
    floats = size**3 * 4
    extract = [c.extremal_mesh, "extract", "--threads", 1, "--quiet", "--iso", 500, "--sigma", 1.5]
    for name in ("clean", "noisy"):
        file, volume = f"{name}.mha", f"{name} {size}³"
        c.against(["with_itk", "derivatives", file],
                  [(f"{volume}: k, t, e, Φ at vertices / ITK's 20 volumes", ["ours", "shapes", file], "30", "70",
                    False, True),
                   (f"{volume}: whole process, file to GraphML / the same", [*extract, file, "-o", "out.graphml"], "20", "50",
                    True, True)])
        c.alone(f"{volume}: peak memory, in float volumes", ["ours", "shapes", file], "",
                lambda run: run.peak / floats, "≤ 3", "≤ 2.3")
        c.alone(f"{volume}: the same of the whole process", [*extract, file, "-o", "out.graphml"], "",
                lambda run: run.peak / floats, "≤ 3", "≤ 2.3")
    c.against(["with_vtk", "marching_cubes", "clean.mha"],
              [(f"clean {size}³: extremal mesh / MarchingCubes, normals", ["ours", "mesh", "clean.mha"], "≤ 2", "≤ 0.6",
                False, False)])
    c.against(["with_vtk", "flying_edges", "clean.mha"],
              [(f"clean {size}³: polygonal cells / FlyingEdges3D", ["ours", "cells", "clean.mha"], "≤ 1.2", "≤ 0.5",
                False, False)])
    c.told("error of third derivatives / ITK's, linear between nodes", "error", ["ours", "accuracy"],
           ["with_itk", "accuracy"], "10", "30")


def meshes(c, sides):
    vertices = 10 * sides**2 + 2
    c.run(["make_inputs", "mesh", sides, "mesh.off"])
    name = f"mesh of {vertices}"
    for rings, points, must, aim in ((2, 19, "60", "120"), (6, 127, "40", "80")):
        c.against(["with_cgal", "jets", rings, "mesh.off"],
                  [(f"{name}: jets of {points} points / CGAL's", ["ours", "jets", rings, "mesh.off"], must, aim, False,
                    True)])
    for what in ("k", "e"):
        c.told(f"{name}: error of {what}, 19 points / CGAL's", f"error of {what}", ["ours", "fit", "mesh.off"],
               ["with_cgal", "fit", "mesh.off"], "1", "")
    extract = [c.extremal_mesh, "extract", "--threads", 1, "--quiet", "--rings", 2, "mesh.off", "-o", "out.graphml"]
    c.against(["with_cgal", "ridges", "mesh.off"],
              [(f"{name}: whole process / jets, ridges, umbilics", extract, "40", "80", True, True)])
    c.alone(f"{name}: bytes a vertex, jets", ["ours", "jets", 2, "mesh.off"], "bytes", lambda run: run.peak / vertices,
            "≤ 350", "≤ 220")
    if c.has("with_cgal"):
        c.alone(f"{name}: the same of CGAL", ["with_cgal", "jets", 2, "mesh.off"], "bytes",
                lambda run: run.peak / vertices)


def growth(c, sizes, sides):
    for size in sizes:
        c.run(["make_inputs", "volume", size, 0, "grown.mha"])
        c.alone(f"clean {size}³: smoothing, cells, shapes", ["ours", "shapes", "grown.mha"], "s",
                lambda run: run.seconds)
    for n in sides:
        c.run(["make_inputs", "mesh", n, "grown.off"])
        c.alone(f"mesh of {10 * n**2 + 2}: jets of 19 points", ["ours", "jets", 2, "grown.off"], "s",
                lambda run: run.seconds)


def graphs(c, vertices):
    c.run([c.extremal_mesh, "extract", "--quiet", "--iso", 500, "--sigma", 1.5, "noisy.mha", "-o", "noisy.graphml"])
    c.alone(f"writing GraphML of {vertices} vertices", ["ours", "write", vertices, "noisy.graphml", "many.graphml"], "s",
            lambda run: run.seconds)
    c.alone("reading it", ["ours", "read", "many.graphml"], "s", lambda run: run.seconds)


def threads(c):
    wall = []
    for n in (1, 2):
        times = []
        for _ in range(c.runs):
            start = os.times().elapsed
            c.run(["ours", "mesh", "clean.mha", n])
            times.append(os.times().elapsed - start)
        wall.append(statistics.median(times))
    c.ratio("two threads: extremal mesh of the clean volume, reading too", wall[0] / wall[1], "1.6", "1.85")


def formula(c, resolutions):
    text = "x^2/9 + y^2/4 + z^2 - 1 + 0.1*(sin(3*x+1)*sin(4*y)+sin(5*z)*sin(2*x))"
    times = [c.alone(f"formula at resolution {r}", [c.extremal_mesh, "extract", "--threads", 1, "--quiet", "--formula", text,
                                                     "--box", -4, -3, -2, 4, 3, 2, "--resolution", r, "-o", "out.graphml"],
                     "s", lambda run: run.whole, runs=c.runs) for r in resolutions]
    c.ratio(f"resolution {resolutions[1]} / {resolutions[0]}", times[1] / times[0], "≤ 4.5")


def machine():
    model = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return f"{model[1] if model else platform.processor()}, {os.cpu_count()} cores, {memory:.0f} GB"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", help="the folder in which the preset 'benchmark' was built")
    parser.add_argument("--csv", help="a file for the table")
    parser.add_argument("--runs", type=int, default=5, help="pairs of runs of which the median is taken")
    parser.add_argument("--size", type=int, default=256, help="voxels on a side of the volumes")
    parser.add_argument("--sides", type=int, default=100, help="of the mesh, which has 10 N² + 2 vertices")
    parser.add_argument("--quick", action="store_true", help="leave out what is large")
    arguments = parser.parse_args()
    print(f"{machine()}. CPU seconds, medians of {arguments.runs} pairs of runs.")
    with tempfile.TemporaryDirectory() as folder:
        c = Comparison(arguments, folder)
        images(c, arguments.size)
        meshes(c, arguments.sides)
        threads(c)
        formula(c, (128, 256) if arguments.quick else (512, 1024))
        if not arguments.quick:
            graphs(c, 500000)
            growth(c, (128, 256, 384, 512, 768), (32, 100, 316))
    if arguments.csv:
        with open(arguments.csv, "w", newline="", encoding="utf-8") as file:
            fields = ["what", "ours", "theirs", "unit", "ratio", "must", "aim", "our peak bytes", "their peak bytes"]
            table = csv.DictWriter(file, fields)
            table.writeheader()
            table.writerows(c.rows)


if __name__ == "__main__":
    main()
