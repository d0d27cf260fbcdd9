# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Extracts from every mesh and volume of a folder at two settings, and compares what comes out with a summary in the tree.

usage: summarize.py PROGRAM FOLDER SUMMARY [--renew] [--only NAME]

A line tells a file, a setting, the counts of vertices by kind, edges, cells, uncertain cells, and which checks fail, or the error.
With --renew the summary, or with --only the lines of some files, are written anew: a commit that does so tells why.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

parser = argparse.ArgumentParser()
parser.add_argument("program", type=pathlib.Path)
parser.add_argument("folder", type=pathlib.Path)
parser.add_argument("summary", type=pathlib.Path)
parser.add_argument("--renew", action="store_true")
parser.add_argument("--only", default="", help="files whose name has this in it")
options = parser.parse_args()

MESHES = (".off", ".obj", ".ply", ".stl", ".om")
# the surface and two widths of the Gaussian in mm
VOLUMES = {
    "skull_2.9.nrrd": (2.9, (5, 10)),
    "cranium_ct.nrrd": (300, (3, 6)),
    "cranium_ct_half.nii.gz": (300, (3, 6)),
    "C57BL6_J_.nii.gz": (35, (0.3, 0.6)),
    "ch2.nii.gz": (35, (3, 6)),
    "engine.nii.gz": (180, (2, 4)),
    "headsq_uint8.nrrd": (31.25, (5, 10)),
    "headsq": (500, (5, 10)),  # the other formats
}
IMAGES = (".nrrd", ".nhdr", ".mha", ".mhd", ".nii", ".nii.gz", ".vtk")


def settings(name):
    if name.lower().endswith(MESHES):
        return [[], ["--rings", "4"]]
    iso, sigmas = next((v for k, v in VOLUMES.items() if name.startswith(k)), (100, (0, 0)))
    return [["--iso", str(iso), "--sigma", str(sigma)] for sigma in sigmas]


def line(file, setting):
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        command = [options.program, "extract", file, *setting, "--report", report, "--quiet"]
        result = subprocess.run(command, capture_output=True, text=True)
        head = " ".join([file.name, *setting]) + ": "
        if result.returncode != 0:
            errors = result.stderr.strip().removeprefix("extremal_mesh: ").replace(str(file.parent) + "/", "")
            return f"{head}code {result.returncode}, {errors}"
        j = json.loads(report.read_text())
    kinds = ", ".join(f"{n} {kind}" for kind, n in j["vertices"].items() if n)
    failed = [name for name, holds in j["checks"].items() if holds is False]
    return (f"{head}{kinds}, {j['edges']} edges, {j['cells']} cells, {j['report']['uncertain_cells']} uncertain, "
            f"χ {j['euler_characteristic']}, {'checks hold' if not failed else 'FAILED: ' + ' '.join(failed)}")


files = sorted(f for f in options.folder.rglob("*") if f.name.lower().endswith(MESHES + IMAGES) and options.only in f.name)
lines = []
for file in files:
    for setting in settings(file.name):
        lines.append(line(file, setting))
        print(lines[-1], flush=True)
known = options.summary.read_text().splitlines() if options.summary.exists() else []
expected = [l for l in known if options.only in l.split(" ")[0].rstrip(":")]
if options.renew:
    options.summary.write_text("\n".join(sorted(set(known) - set(expected) | set(lines))) + "\n")
    sys.exit(0)
changed = [f"- {l}" for l in expected if l not in lines] + [f"+ {l}" for l in lines if l not in expected]
if not changed:
    print(f"{len(lines)} results as before")
    sys.exit(0)
print("\nwhat changed:", *changed, "If that is meant, renew the summary (--renew), and tell why in the commit.", sep="\n")
sys.exit(1)
