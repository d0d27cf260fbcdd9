# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of doc/tutorial_program.md: from a formula to a graph, from an array to landmarks, from arrays of polygons to cells."""
import networkx
import numpy as np

import extremal_mesh as em

# a formula, or a function of x, y and z
mesh = em.extract(lambda x, y, z: x**2 / 9 + y**2 / 4 + z**2 - 1, box=(-4, -3, -2, 4, 3, 2))
print(mesh, "is consistent:", mesh.is_consistent())

# columns of numpy: where are the umbilics?
kinds = np.array(mesh.vertices["kind"])
print(mesh.vertices["point"][kinds == "umbilic"])

# NetworkX: which way leads from one end of the ellipsoid to the other along the lines?
graph = mesh.to_networkx()
ends = [int(np.argmin(mesh.vertices["point"][:, 0])), int(np.argmax(mesh.vertices["point"][:, 0]))]
print(networkx.shortest_path(graph, *ends, weight="length"))

# a volume with its affine, as nibabel gives them; here a ball with bumps
i, j, k = np.meshgrid(*3 * [np.linspace(-1.5, 1.5, 48)], indexing="ij")
volume = -(i**2 + 1.3 * j**2 + 1.7 * k**2 + 0.3 * i * j * k)
affine = np.diag([0.5, 0.5, 0.5, 1.0])
from_image = em.extract_image(volume, affine, iso=-1.0, sigma=0.75)
simple = from_image.simplify()
print(from_image, "simplified:", simple)

# polygons as arrays; a mesh registered with itself does not move
surface = from_image.surface
from_mesh = em.extract_mesh(surface["point"], surface["triangle"], radius=2.5)
motion = from_image.register(from_image)
assert motion.found and np.allclose(motion.matrix, np.eye(4), atol=1e-6)
from_mesh.write("from_mesh.graphml")
