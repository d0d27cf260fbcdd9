# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a GraphML file as users do: networkx_test.py FILE VERTICES EDGES CELLS COPY"""
import json
import sys

import networkx as nx

file, vertices, edges, cells, copy = sys.argv[1:]
graph = nx.read_graphml(file, force_multigraph=True)
assert graph.number_of_nodes() == int(vertices), graph
assert graph.number_of_edges() == int(edges), graph
assert len(json.loads(graph.graph["cells"])) == int(cells)
assert isinstance(graph.graph["euler_characteristic"], int)
assert isinstance(graph.graph["closed"], bool)
for node, data in graph.nodes(data=True):
    assert isinstance(data["x"], float) and isinstance(data["kind"], str)
    assert data["degree"] == graph.degree(node), node
for source, target, edge in graph.edges(data=True):
    polyline = [float(word) for word in edge["polyline"].split()]
    points = len(polyline) // 3
    assert len(edge["segment_types"].split()) == points - 1
    assert len(edge["k_max_along"].split()) == points
    assert edge["family"] in (1, 2)
    ends = [[graph.nodes[v][axis] for axis in "xyz"] for v in (source, target)]
    assert polyline[:3] in ends and polyline[-3:] in ends
    edge["my_weight"] = 1.5
nx.write_graphml(graph, copy)
