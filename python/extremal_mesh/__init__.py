# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The extremal mesh of surfaces: crest lines and other extremal lines, extremal points, umbilics and the cells between them.

    import extremal_mesh as em
    mesh = em.extract("x^2/9 + y^2/4 + z^2 = 1", box=(-4, -3, -2, 4, 3, 2))
    print(mesh)                    # 10 vertices, 16 edges, 8 cells
    mesh.write("ellipsoid.graphml")
"""
from __future__ import annotations

import json
import os
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core

__all__ = ["ExtremalMesh", "Registration", "extract", "extract_image", "extract_mesh", "read"]


class _Expression:
    """What a Python function makes of its arguments: a formula, of which the program knows all derivatives."""

    __slots__ = ("text",)

    def __init__(self, text: str):
        self.text = text

    @staticmethod
    def _text(value: Any) -> Optional[str]:
        if isinstance(value, _Expression):
            return value.text
        return f"({float(value)!r})" if isinstance(value, (int, float, np.integer, np.floating)) else None

    def _binary(self, other: Any, sign: str, swapped: bool = False) -> "_Expression":
        text = self._text(other)
        if text is None:
            return NotImplemented
        left, right = (text, self.text) if swapped else (self.text, text)
        return _Expression(f"({left} {sign} {right})")

    def __add__(self, other): return self._binary(other, "+")
    def __radd__(self, other): return self._binary(other, "+", True)
    def __sub__(self, other): return self._binary(other, "-")
    def __rsub__(self, other): return self._binary(other, "-", True)
    def __mul__(self, other): return self._binary(other, "*")
    def __rmul__(self, other): return self._binary(other, "*", True)
    def __truediv__(self, other): return self._binary(other, "/")
    def __rtruediv__(self, other): return self._binary(other, "/", True)
    def __pow__(self, other): return self._binary(other, "^")
    def __rpow__(self, other): return self._binary(other, "^", True)
    def __neg__(self): return _Expression(f"(-{self.text})")
    def __pos__(self): return self
    def __abs__(self): return _Expression(f"abs({self.text})")


def _add_functions() -> None:
    # numpy's functions call these methods of objects that they do not know: np.sin(x) is x.sin()
    names = {"arcsin": "asin", "arccos": "acos", "arctan": "atan"}
    for name in ("sqrt", "cbrt", "exp", "log", "log2", "log10", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh"):
        setattr(_Expression, name, lambda self, f=names.get(name, name): _Expression(f"{f}({self.text})"))


_add_functions()


class Registration:
    """A motion that takes one mesh to another.

    found: whether there is one; reason: why not; matrix: 4×4, takes points of the first mesh to the second; rms: of the distances
    of matched vertices; matched: (vertex of the first, vertex of the second, distance).
    """

    def __init__(self, outcome: Dict[str, Any]):
        self.found: bool = outcome["found"]
        self.reason: str = outcome["reason"]
        self.matrix: np.ndarray = np.array(outcome["matrix"])
        self.rms: float = outcome["rms"]
        self.matched: List[Tuple[int, int, float]] = outcome["matched"]


class ExtremalMesh:
    """An extremal mesh: vertices, edges and cells as numpy arrays, made by `extract()` and its kin or by `read()`."""

    def __init__(self, result: _core.Result):
        self._result = result

    def __repr__(self) -> str:
        vertices, edges, cells = self._result.sizes()
        return f"<ExtremalMesh: {vertices} vertices, {edges} edges, {cells} cells>"

    @property
    def vertices(self) -> Dict[str, Any]:
        """Columns, an entry per vertex: kind, point (n×3), normal, t1, t2, k_max, k_min, index, umbilic_type."""
        return self._result.vertices()

    @property
    def edges(self) -> Dict[str, Any]:
        """Columns, an entry per edge: source, target, family, type, length, strength, sharpness, left_cell, right_cell, polyline (n×3 each)."""
        return self._result.edges()

    @property
    def cells(self) -> Dict[str, Any]:
        """Columns, an entry per cell: sign of E_g, area, weight, euler_characteristic, boundary (walks of half-edges)."""
        return self._result.cells()

    @property
    def surface(self) -> Dict[str, np.ndarray]:
        """The surface cut along the lines: point (n×3), normal, triangle (m×3), cell (m). Empty for a mesh that was read."""
        return self._result.surface()

    @property
    def info(self) -> Dict[str, Any]:
        """What is known of the surface: euler_characteristic, closed, area, source, parameters, frame."""
        return self._result.info()

    def check(self) -> List[Dict[str, Any]]:
        """Tests all identities of an extremal mesh: dictionaries with name, claim, applies, holds, detail."""
        return self._result.check()

    def is_consistent(self) -> bool:
        """Whether no check that applies is violated."""
        return all(check["holds"] or not check["applies"] for check in self.check())

    def simplify(self, *, threshold: Optional[float] = None, cells: Optional[int] = None, vertices: Optional[int] = None) -> "ExtremalMesh":
        """A mesh without what is least persistent.

        At most one of: threshold, do all steps of at most this persistence; cells or vertices, until there are at most so many.
        Without any, up to the greatest rise of the persistence.
        """
        if sum(x is not None for x in (threshold, cells, vertices)) > 1:
            raise ValueError("give one of threshold, cells and vertices")
        return ExtremalMesh(self._result.simplify(threshold, cells, vertices))

    def register(self, other: "ExtremalMesh", *, tolerance: float = 0, scale: bool = False, mirror: bool = False) -> Registration:
        """Finds the motion that takes this mesh to another one, without an initial guess.

        tolerance: how far apart the same points may be; 0: chosen from the meshes.
        """
        return Registration(self._result.register(other._result, tolerance, scale, mirror))

    def write(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Writes a file that appears whole or not at all; what it is follows from its ending, as in `extremal_mesh extract -o`."""
        self._result.write(os.fspath(file))

    def to_networkx(self) -> Any:
        """A networkx.MultiGraph: nodes and edges have the columns of `vertices` and `edges` as attributes, edges their number as key."""
        import networkx

        graph = networkx.MultiGraph(**self.info)
        vertices, edges = self.vertices, self.edges
        for v in range(len(vertices["kind"])):
            graph.add_node(v, **{name: column[v] for name, column in vertices.items()})
        for e in range(len(edges["type"])):
            data = {name: column[e] for name, column in edges.items() if name not in ("source", "target")}
            graph.add_edge(int(edges["source"][e]), int(edges["target"][e]), key=e, **data)
        return graph


def _box(box: Sequence[float]) -> Tuple[List[float], List[float]]:
    numbers = [float(x) for x in np.asarray(box, dtype=float).ravel()]
    if len(numbers) != 6:
        raise ValueError("give a box as x0 y0 z0 x1 y1 z1")
    return numbers[:3], numbers[3:]


def extract(function: Union[str, Callable[..., Any]], box: Sequence[float], *, resolution: int = 64, derivatives: bool = False,
            max_level: int = 20, threads: int = 0) -> ExtremalMesh:
    """The extremal mesh of the surface f = 0 in a box (x0, y0, z0, x1, y1, z1).

    function: a formula such as "x^2/9 + y^2/4 + z^2 = 1"; or a function of x, y and z, written with operators and numpy's functions, which is
    called once to learn its formula. With derivatives=True it is called with numbers wherever it is needed (that is slow) and gives 20: the
    value, the gradient, second derivatives xx xy xz yy yz zz and third ones xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz.
    f should be negative inside, so that normals point outwards. resolution: cubes across the longest side of the box.
    """
    low, high = _box(box)
    parameters = json.dumps({"box": low + high, "resolution": resolution, "max_level": max_level})
    if isinstance(function, str):
        return ExtremalMesh(_core.extract_formula(function, low, high, resolution, max_level, threads, parameters))
    if derivatives:
        return ExtremalMesh(_core.extract_callable(function, low, high, resolution, max_level, parameters))
    formula = function(_Expression("x"), _Expression("y"), _Expression("z"))
    if not isinstance(formula, _Expression):
        raise TypeError("the function must be an expression of its arguments; or give derivatives=True and 20 numbers")
    return ExtremalMesh(_core.extract_formula(formula.text, low, high, resolution, max_level, threads, parameters))


def extract_image(volume: np.ndarray, affine: Optional[np.ndarray] = None, *, iso: float, sigma: float = 0, frame: str = "",
                  max_level: int = 8, max_line_level: int = 2, threads: int = 0) -> ExtremalMesh:
    """The extremal mesh of the surface where a volume, smoothed by a Gaussian, has the value iso.

    volume: voxel [i, j, k]. affine: 4×4 or 3×4, takes (i, j, k, 1) to positions, as nibabel has it; none: the indices. Positions come out in
    the axes of the affine. sigma: the width of the Gaussian in the affine's unit; 0: the largest side of a voxel.
    """
    volume = np.asarray(volume)
    if volume.ndim != 3:
        raise ValueError(f"the volume has {volume.ndim} axes, not 3")
    matrix = np.eye(4) if affine is None else np.asarray(affine, dtype=float)
    if matrix.shape not in ((4, 4), (3, 4)):
        raise ValueError(f"the affine is {matrix.shape}, not 4×4")
    parameters = json.dumps({"iso": iso, "sigma": sigma})
    return ExtremalMesh(_core.extract_volume(volume, matrix[:3].tolist(), iso, sigma, max_level, max_line_level, threads, parameters, frame))


def extract_mesh(vertices: np.ndarray, faces: Union[np.ndarray, Sequence[Sequence[int]]], *, radius: float = 0, rings: int = 0,
                 max_level: int = 8, threads: int = 0) -> ExtremalMesh:
    """The extremal mesh of a polygon mesh, by jets fitted at its vertices.

    vertices: n×3. faces: an m×k array or a list of polygons with any number of corners, counter-clockwise seen from outside; they must be an
    oriented manifold. radius: the size of the features looked for; rings: instead, how many edges away neighbours are; 0: chosen from the mesh.
    """
    points = np.ascontiguousarray(vertices, dtype=float)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"the vertices are {points.shape}, not n×3")
    begin, corners = [0], []
    for face in faces:
        corners.extend(int(v) for v in face)
        begin.append(len(corners))
    if corners and min(corners) < 0:
        raise ValueError("a face has a negative vertex")
    parameters = json.dumps({"radius": radius, "rings": rings})
    return ExtremalMesh(_core.extract_polygons(points, begin, corners, radius, rings, max_level, threads, parameters))


def read(file: Union[str, "os.PathLike[str]"]) -> ExtremalMesh:
    """Reads GraphML that the program or `write()` wrote."""
    return ExtremalMesh(_core.read(os.fspath(file)))
