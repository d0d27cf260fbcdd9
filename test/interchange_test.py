# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""interchange_test.py PROGRAM WORK_FOLDER

Reads what 'extremal_mesh convert' writes with the programs that it is for, and compares with the GraphML that NetworkX reads.
Exit code 77: igraph, NetworkX or VTK is missing.
"""
import csv
import json
import math
import pathlib
import shutil
import subprocess
import sys

try:
    import igraph
    import networkx
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOGeometry import vtkOBJReader
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOImport import vtkGLTFImporter
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
    from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataReader
    from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow
    import vtkmodules.vtkRenderingOpenGL2  # the importer needs it
except ImportError as error:
    print(f"skipped: {error}; python3-igraph, python3-networkx and python3-vtk9 bring it")
    sys.exit(77)

program, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)


def run(*arguments, **options):
    return subprocess.run([program, *arguments], cwd=work, text=True, capture_output=True, **options)


kinds = ["extremal_point", "umbilic", "non_generic", "boundary", "anchor"]
types = ["max_largest", "min_largest", "max_second", "min_second"]
names = ["m.obj", "m.ply", "m.vtp", "m.glb", "m.gltf", "m.vertices.csv", "m.edges.csv", "m.cells.csv", "m.json", "m.mrk.json"]
# bumps on an ellipsoid: all types and several kinds
run("extract", "--formula", "x^2/9 + y^2/4 + z^2 + 0.02*sin(3*x)*cos(2*y + 1) = 1", "--box", "-4", "-3", "-2", "4", "3", "2",
    "--resolution", "32", "-o", "g.graphml", "--cells", "g.ply", "--quiet", check=True)
outputs = [word for name in names for word in ("-o", name)]
outcome = run("convert", "g.graphml", "--surface", "g.ply", *outputs, check=True)
assert outcome.stdout.split() == names, outcome.stdout
before = {name: (work / name).read_bytes() for name in names}
run("convert", "g.graphml", "--surface", "g.ply", *outputs, check=True)
assert before == {name: (work / name).read_bytes() for name in names}, "another run gives other bytes"

graph = networkx.read_graphml(work / "g.graphml", force_multigraph=True)
node = [data for _, data in sorted(graph.nodes(data=True), key=lambda item: int(item[0][1:]))]
points = [(d["x"], d["y"], d["z"]) for d in node]
edge = [data | {"ends": {int(u[1:]), int(v[1:])}} for u, v, _, data in
        sorted(graph.edges(keys=True, data=True), key=lambda item: int(item[2][1:]) if isinstance(item[2], str) else int(item[3]["id"][1:]))]
cells = json.loads(graph.graph["cells"])
polyline = [list(zip(*[iter(map(float, e["polyline"].split()))] * 3)) for e in edge]
segments = sum(len(p) - 1 for p in polyline)
inner = sum(len(p) - 2 for p in polyline)
assert len(node) > 10 and len(edge) > 16 and len({e["type"] for e in edge}) == 4

# igraph reads the same graph
other = igraph.Graph.Read_GraphML(str(work / "g.graphml"))
assert (other.vcount(), other.ecount()) == (len(node), len(edge)) and other.is_connected() == networkx.is_connected(graph)
assert [(v["x"], v["y"], v["z"]) for v in other.vs] == points and other.vs["kind"] == [d["kind"] for d in node]
assert [set(e.tuple) for e in other.es] == [e["ends"] for e in edge] and other.es["strength"] == [e["strength"] for e in edge]
assert other.degree() == [int(d) for d in other.vs["degree"]]

# OBJ: VTK has all lines, with the points to the last bit (VTK's are floats)
reader = vtkOBJReader()
reader.SetFileName(str(work / "m.obj"))
reader.Update()
obj = reader.GetOutput()
assert obj.GetNumberOfPoints() == len(node) + inner and obj.GetNumberOfLines() == len(edge)
assert max(math.dist(obj.GetPoint(v), points[v]) for v in range(len(node))) < 1e-6  # half an ulp of a float at 4 is 2.4e-7

# PLY: the header says what there is; points are those of GraphML
lines = (work / "m.ply").read_text().splitlines()
assert f"element vertex {len(node) + inner}" in lines and f"element edge {segments}" in lines
start = lines.index("end_header") + 1
assert [tuple(map(float, row.split()[:3])) for row in lines[start:start + len(node)]] == points
rows = [list(map(int, row.split())) for row in lines[start + len(node) + inner:]]
assert len(rows) == segments and {row[7] for row in rows} == set(range(len(edge)))
assert [types[row[5]] for row in rows] == [t for e in edge for t in e["segment_types"].split()]
reader = vtkPLYReader()  # which passes over the edges
reader.SetFileName(str(work / "m.ply"))
reader.Update()
assert reader.GetOutput().GetNumberOfPoints() == len(node) + inner

# VTP: vertices, lines, polygons with their attributes, doubles to the last bit
reader = vtkXMLPolyDataReader()
reader.SetFileName(str(work / "m.vtp"))
reader.Update()
data = reader.GetOutput()
reader = vtkPLYReader()
reader.SetFileName(str(work / "g.ply"))
reader.Update()
faces = reader.GetOutput().GetNumberOfPolys()
assert (data.GetNumberOfVerts(), data.GetNumberOfLines(), data.GetNumberOfPolys()) == (len(node), len(edge), faces)
assert [data.GetPoint(v) for v in range(len(node))] == points
column = {data.GetCellData().GetArrayName(i): vtk_to_numpy(data.GetCellData().GetArray(i))
          for i in range(data.GetCellData().GetNumberOfArrays())}
assert [kinds[k] for k in column["kind"][:len(node)]] == [d["kind"] for d in node]
at = slice(len(node), len(node) + len(edge))
assert [types[t] for t in column["type"][at]] == [e["type"] for e in edge]
for name in ("length", "strength", "sharpness", "family", "left_cell", "right_cell"):
    assert list(column[name][at]) == [e[name] for e in edge], name
assert set(column["cell"][at.stop:]) == set(range(len(cells)))
assert all(cells[c]["sign"] == s for c, s in zip(column["cell"][at.stop:], column["sign"][at.stop:]))
assert list(vtk_to_numpy(data.GetPointData().GetArray("k_max"))[:len(node)]) == [d["k_max"] for d in node]
for e in (0, len(edge) - 1):
    ids = data.GetCell(len(node) + e).GetPointIds()
    assert [data.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())] == polyline[e]

# glTF: VTK's importer finds the lines, points and triangles
for name in ("m.glb", "m.gltf"):
    importer, window, renderer = vtkGLTFImporter(), vtkRenderWindow(), vtkRenderer()
    window.SetOffScreenRendering(True)
    window.AddRenderer(renderer)
    importer.SetFileName(str(work / name))
    importer.SetRenderWindow(window)
    importer.Read()
    actors = renderer.GetActors()
    actors.InitTraversal()
    counts = {"lines": 0, "verts": 0, "polys": 0}
    for _ in range(actors.GetNumberOfItems()):
        part = actors.GetNextActor().GetMapper().GetInput()
        counts["lines"] += part.GetNumberOfLines()
        counts["verts"] += part.GetNumberOfVerts()
        counts["polys"] += part.GetNumberOfPolys()
    assert counts["lines"] == segments and counts["verts"] == len(node), (name, counts, segments)
    assert counts["polys"] >= faces, (name, counts)

# tables
table = {name: list(csv.DictReader(open(work / f"m.{name}.csv"))) for name in ("vertices", "edges", "cells")}
assert [(r["kind"], float(r["x"]), float(r["k_min"])) for r in table["vertices"]] == [(d["kind"], d["x"], d["k_min"]) for d in node]
assert [(r["type"], float(r["strength"]), int(r["left_cell"])) for r in table["edges"]] == \
    [(e["type"], e["strength"], e["left_cell"]) for e in edge]
assert [{int(r["source"]), int(r["target"])} for r in table["edges"]] == [e["ends"] for e in edge]
assert [(int(r["sign"]), float(r["area"])) for r in table["cells"]] == [(c["sign"], c["area"]) for c in cells]

# JSON
whole = json.loads((work / "m.json").read_text())
assert [tuple(v["point"]) for v in whole["vertices"]] == points
assert [[tuple(p) for p in e["polyline"]] for e in whole["edges"]] == polyline
assert [c["boundary"] for c in whole["cells"]] == [c["boundary"] for c in cells]

# markups: the form that Slicer's schema asks for; every crest edge is in one curve
markups = json.loads((work / "m.mrk.json").read_text())["markups"]
assert [m["type"] for m in markups[:2]] == ["Fiducial", "Fiducial"]
assert all(m["type"] in ("Curve", "ClosedCurve") and m["coordinateSystem"] == "LPS" for m in markups[2:])
assert [tuple(p["position"]) for p in markups[0]["controlPoints"]] == [p for p, d in zip(points, node) if d["kind"] == "extremal_point"]
crest = [p for p, e in zip(polyline, edge) if e["type"] == "max_largest"]
pairs = sum(len(m["controlPoints"]) - (m["type"] == "Curve") for m in markups[2:])
assert crest and pairs == sum(len(p) - 1 for p in crest)

# without a surface; and what is refused
run("convert", "g.graphml", "alone.vtp", check=True)
reader = vtkXMLPolyDataReader()
reader.SetFileName(str(work / "alone.vtp"))
reader.Update()
assert (reader.GetOutput().GetNumberOfLines(), reader.GetOutput().GetNumberOfPolys()) == (len(edge), 0)
for arguments in (["g.graphml"], ["g.graphml", "x.csv"], ["g.graphml", "x.stl"]):
    refused = run("convert", *arguments)
    assert refused.returncode == 2 and refused.stderr.count("\n") == 1, refused

# images that VTK writes
source, written = vtkRTAnalyticSource(), {}
for name in ("ascii", "binary", "appended"):
    for compressor in ("None", "ZLib"):
        writer = vtkXMLImageDataWriter()
        writer.SetInputConnection(source.GetOutputPort())
        writer.SetDataMode({"ascii": writer.Ascii, "binary": writer.Binary, "appended": writer.Appended}[name])
        getattr(writer, "SetCompressorTypeTo" + compressor)()
        writer.SetFileName(str(work / "image.vti"))
        writer.Write()
        run("extract", "image.vti", "--iso", "150", "--sigma", "1.5", "--quiet", "-o", "image.graphml", check=True)
        written[name, compressor] = (work / "image.graphml").read_text()
assert written.pop(("ascii", "None")).count("<node") > 10
assert len(set(written.values())) == 1  # as text numbers are rounded
print("all files are read")
