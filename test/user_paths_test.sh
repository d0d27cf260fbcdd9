#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# user_paths_test.sh PROGRAM DATA_FOLDER WORK_FOLDER
# What three people do on their first day. A fourth one, who programs with CGAL, is in install_test.sh; who works in Python, also in
# python_test.sh.
set -euo pipefail
program=$1 data=$2 work=$3
rm -rf "$work"
mkdir -p "$work"
cd "$work"
extremal_mesh() { "$program" "$@"; }
python=/usr/bin/python3

echo "A radiologist, with 3D Slicer and ParaView"
extremal_mesh extract "$data/headsq.nii.gz" --iso 500 --sigma 6 -o skin.graphml -o skin.vtp -o skin.mrk.json --cells skin.ply --quiet
extremal_mesh check skin.graphml >/dev/null
extremal_mesh landmarks skin.graphml --most 20 -o landmarks.mrk.json >/dev/null
"$python" - <<'P'
import json
for name, types in (("landmarks.mrk.json", {"Fiducial"}), ("skin.mrk.json", {"Fiducial", "Curve", "ClosedCurve"})):
    markups = json.load(open(name))["markups"]
    assert {m["type"] for m in markups} <= types and all(m["coordinateSystem"] == "LPS" for m in markups), name
assert len(json.load(open("landmarks.mrk.json"))["markups"][0]["controlPoints"]) == 20
P
if "$python" -c 'import vtkmodules' 2>/dev/null; then
  "$python" - <<'P'
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
reader = vtkXMLPolyDataReader()
reader.SetFileName("skin.vtp")
reader.Update()
data = reader.GetOutput()
assert data.GetNumberOfLines() > 0 and data.GetNumberOfPolys() > 1000
bounds = data.GetBounds()
assert all(100 < bounds[2 * a + 1] - bounds[2 * a] < 300 for a in range(3)), bounds  # a head, in mm
P
fi

echo "A CAD engineer, with MeshLab"
extremal_mesh extract "$data/femur.off" --radius 0.1 -o femur.graphml -o femur.obj --cells femur.ply --lines femur.lines.off --quiet
extremal_mesh query femur.graphml --strongest 3 >strongest.json
extremal_mesh simplify femur.graphml --cells 40 --surface femur.ply --patches simple.ply -o simple.obj --quiet
[[ $(head -1 femur.lines.off) == OFF && $(head -1 simple.ply) == ply ]]
[[ $(grep -c '^l ' simple.obj) -lt $(grep -c '^l ' femur.obj) && $(grep -c '^l ' simple.obj) -gt 0 ]]
"$python" -c 'import json; assert json.load(open("strongest.json"))'

echo "Somebody with Python, and the browser"
extremal_mesh view femur.graphml --surface femur.ply -o femur.html --quiet
[[ $(tail -1 femur.html) == "</html>" ]]
extremal_mesh convert femur.graphml -o femur.edges.csv -o femur.json --quiet
"$python" - <<'P'
import csv, json
whole = json.load(open("femur.json"))
table = list(csv.DictReader(open("femur.edges.csv")))
assert len(table) == len(whole["edges"]) > 0
assert [float(row["strength"]) for row in table] == [edge["strength"] for edge in whole["edges"]]
P
echo "all reached what they wanted"
