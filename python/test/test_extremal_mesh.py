# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import pathlib

import numpy as np
import pytest

import extremal_mesh as em

box = (-4, -3, -2, 4, 3, 2)
text = "x^2/9 + y^2/4 + z^2 = 1"
lowest = dict(resolution=24)


def sizes(mesh):
    return len(mesh.vertices["kind"]), len(mesh.edges["type"]), len(mesh.cells["sign"])


@pytest.fixture(scope="module")
def ellipsoid():
    return em.extract(text, box, **lowest)


@pytest.fixture(scope="module")
def wavy():
    return em.extract("x^2/9 + y^2/4 + z^2 + 0.02*sin(3*x)*cos(2*y + 1) + 0.03*x*y*z = 1", box, resolution=32)


def test_formula(ellipsoid):
    assert sizes(ellipsoid) == (10, 16, 8)  # extremal mesh of an ellipsoid
    assert ellipsoid.is_consistent() and len(ellipsoid.check()) > 10
    assert repr(ellipsoid) == "<ExtremalMesh: 10 vertices, 16 edges, 8 cells>"
    vertices = ellipsoid.vertices
    assert vertices["kind"].count("umbilic") == 4 and vertices["umbilic_type"].count("lemon") == 4
    at = vertices["point"]
    assert at.shape == (10, 3) and np.allclose(at[:, 0] ** 2 / 9 + at[:, 1] ** 2 / 4 + at[:, 2] ** 2, 1, atol=1e-12)
    # the umbilics: x² = 9(9 − 4)/(9 − 1), z² = (4 − 1)/(9 − 1), y = 0
    umbilics = at[[k == "umbilic" for k in vertices["kind"]]]
    assert np.allclose(np.abs(umbilics), [np.sqrt(45 / 8), 0, np.sqrt(3 / 8)], atol=1e-9)
    assert ellipsoid.info["euler_characteristic"] == 2 and ellipsoid.info["closed"]


def test_surface(ellipsoid):
    surface = ellipsoid.surface
    a, b, c = (surface["point"][surface["triangle"][:, i]] for i in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    for cell, area in enumerate(ellipsoid.cells["area"]):
        assert np.isclose(areas[surface["cell"] == cell].sum(), area, rtol=1e-9)


def test_function_as_formula(ellipsoid):
    mesh = em.extract(lambda x, y, z: (x / 3) ** 2 + y * y / 4 + z**2 - 1, box, **lowest)
    assert np.allclose(mesh.vertices["point"], ellipsoid.vertices["point"], atol=1e-9)
    torus = em.extract(lambda x, y, z: (np.sqrt(x**2 + 1.3 * y**2) - 1) ** 2 + z**2 * (1 + 0.2 * x) + 0.03 * y * z - 0.16,
                       (-1.6, -1.5, -0.7, 1.6, 1.5, 0.7), resolution=32)
    assert torus.info["euler_characteristic"] == 0 and torus.is_consistent()
    with pytest.raises(TypeError, match="derivatives=True"):
        em.extract(lambda x, y, z: 1.0, box)


def test_function_with_derivatives():
    def f(x, y, z):
        return [x * x / 9 + y * y / 4 + z * z - 1, 2 * x / 9, y / 2, 2 * z, 2 / 9, 0, 0, 1 / 2, 0, 2] + 10 * [0]

    mesh = em.extract(f, box, resolution=16, derivatives=True)
    assert sizes(mesh) == (10, 16, 8) and mesh.is_consistent()
    with pytest.raises(ValueError, match="20 numbers"):
        em.extract(lambda x, y, z: [1.0], box, derivatives=True)


def test_volume_and_affine():
    # sampled at 0.25 mm in turned axes; twice as large with twice the spacing and σ
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    i, j, k = np.meshgrid(np.arange(32), np.arange(40), np.arange(24), indexing="ij")
    affine = np.eye(4)
    affine[:3, :3] = 0.25 * turn
    affine[:3, 3] = -(affine[:3, :3] @ [15.5, 19.5, 11.5])
    p = np.einsum("ab,bijk->aijk", affine[:3, :3], np.array([i, j, k])) + affine[:3, 3].reshape(3, 1, 1, 1)
    volume = (p[0] / 3) ** 2 + (p[1] / 2) ** 2 + p[2] ** 2
    mesh = em.extract_image(volume, affine, iso=1.0, sigma=0.3)
    assert mesh.is_consistent()
    lemons = mesh.vertices["point"][[t == "lemon" for t in mesh.vertices["umbilic_type"]]]
    # a Gaussian adds a constant to a quadratic function: that of a smaller ellipsoid of the same shape
    c = 1 - 0.09 * (1 / 9 + 1 / 4 + 1)
    assert len(lemons) == 4
    assert np.allclose(np.abs(lemons), np.sqrt(c) * np.array([np.sqrt(45 / 8), 0, np.sqrt(3 / 8)]), atol=1e-3)  # voxels are floats
    double = em.extract_image(volume, np.diag([2, 2, 2, 1]) @ affine, iso=1.0, sigma=0.6)
    assert sizes(double) == sizes(mesh)
    with pytest.raises(ValueError, match="axes"):
        em.extract_image(volume[0], iso=1.0)


def ellipsoid_of_quadrilaterals(n):
    """a cube of n×n squares on each side, blown up to the ellipsoid"""
    points, faces, number = [], [], {}

    def vertex(p):
        if p not in number:
            number[p] = len(points)
            points.append(np.tan(np.pi / 4 * (2 * np.array(p) / n - 1)))  # squares of about one size on the sphere
        return number[p]

    for axis in range(3):
        for side in (0, n):
            for a in range(n):
                for b in range(n):
                    corners = [(side, a, b), (side, a + 1, b), (side, a + 1, b + 1), (side, a, b + 1)]
                    face = [vertex(tuple(np.roll(c, axis))) for c in corners]
                    faces.append(face if side else face[::-1])
    points = np.array(points)
    return points / np.linalg.norm(points, axis=1)[:, None] * [3, 2.5, 2], faces


def test_polygons():
    exact = em.extract("x^2/9 + y^2/6.25 + z^2/4 = 1", (-4, -3, -3, 4, 3, 3), resolution=32)
    points, faces = ellipsoid_of_quadrilaterals(24)
    mesh = em.extract_mesh(points, np.array(faces))
    assert mesh.is_consistent() and mesh.info["euler_characteristic"] == 2 and np.isclose(mesh.info["area"], exact.info["area"], rtol=5e-3)
    lemons = mesh.vertices["point"][[t == "lemon" for t in mesh.vertices["umbilic_type"]]]
    assert len(lemons) == 4
    assert np.allclose(np.abs(lemons), [np.sqrt(9 * 2.75 / 5), 0, np.sqrt(4 * 2.25 / 5)], atol=0.2)  # an edge is about 0.2 long
    # two quadrilaterals become a polygon of six corners
    first = faces[0]
    second = next(f for f in faces[1:] if {first[0], first[1]} <= set(f))
    around = second[second.index(first[0]) + 1:] + second[:second.index(first[0])]  # from after first[0] to first[1]
    polygons = [f for f in faces if f not in (first, second)] + [first[1:] + [first[0]] + around[:-1]]
    assert len(polygons[-1]) == 6
    assert em.extract_mesh(points, polygons).is_consistent()
    with pytest.raises(ValueError, match="n×3"):
        em.extract_mesh(points[:, :2], faces)
    with pytest.raises(ValueError):
        em.extract_mesh(points, [[0, 1, len(points)]])


def test_networkx(wavy):
    networkx = pytest.importorskip("networkx")
    graph = wavy.to_networkx()
    assert (graph.number_of_nodes(), graph.number_of_edges()) == sizes(wavy)[:2]
    assert all(degree % 2 == 0 for _, degree in graph.degree())
    length = networkx.single_source_dijkstra_path_length(graph, 0, weight="length")
    assert len(length) >= 2 and max(length.values()) > 0
    assert [d["type"] for *_, d in sorted(graph.edges(keys=True, data=True), key=lambda e: e[2])] == wavy.edges["type"]


def test_simplify(wavy):
    simple = wavy.simplify(cells=8)
    assert sizes(simple)[2] <= 8 < sizes(wavy)[2] and simple.is_consistent()
    assert sizes(wavy.simplify(threshold=0)) == sizes(wavy)
    with pytest.raises(ValueError, match="one of"):
        wavy.simplify(cells=8, threshold=1)


def test_register(wavy):
    # the same surface, turned about z by a right angle and moved: x = Y − 0.5, y = −(X − 1)
    moved = em.extract(lambda X, Y, Z: (lambda x, y, z: x**2 / 9 + y**2 / 4 + z**2 + 0.02 * np.sin(3 * x) * np.cos(2 * y + 1) + 0.03 * x * y * z - 1)(
        Y - 0.5, -(X - 1), Z), (-2, -3.5, -2, 4, 4.5, 2), resolution=32)
    motion = wavy.register(moved, tolerance=0.02)
    assert motion.found, motion.reason
    assert motion.rms < 1e-6 and len(motion.matched) == len([k for k in wavy.vertices["kind"] if k in ("extremal_point", "umbilic")])
    assert np.allclose(motion.matrix, [[0, -1, 0, 1], [1, 0, 0, 0.5], [0, 0, 1, 0], [0, 0, 0, 1]], atol=1e-5)


def test_files(ellipsoid, tmp_path):
    for name in ("e.graphml", "e.vtp", "e.glb", "e.obj", "e.mrk.json", "e.html"):
        ellipsoid.write(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 500
    again = em.read(tmp_path / "e.graphml")
    assert np.array_equal(again.vertices["point"], ellipsoid.vertices["point"])
    assert all(np.array_equal(a, b) for a, b in zip(again.edges["polyline"], ellipsoid.edges["polyline"]))
    with pytest.raises(ValueError, match="extension"):
        ellipsoid.write(tmp_path / "e.stl")
    with pytest.raises(OSError):
        em.read(tmp_path / "none.graphml")


def test_errors():
    with pytest.raises(ValueError):
        em.extract("x^2 +", box)
    with pytest.raises(ValueError, match="x0 y0"):
        em.extract(text, (0, 1))
    with pytest.raises(RuntimeError):  # a sphere has no extremal mesh
        em.extract("x^2 + y^2 + z^2 = 1", (-2, -2, -2, 2, 2, 2), **lowest)
