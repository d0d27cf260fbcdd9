#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# python_test.sh CMAKE SOURCE_FOLDER WORK_FOLDER
# Builds the Python module, for which the library must be position independent and is built once more, and runs its tests.
# Exit code 77: what it needs is missing.
set -euo pipefail
cmake=$1 source=$2 work=$3
/usr/bin/python3 -c 'import numpy, pytest' 2>/dev/null && [[ -e /usr/lib/cmake/pybind11 || -e /usr/share/cmake/pybind11 ]] ||
  { echo "skipped: pybind11-dev, python3-numpy and python3-pytest bring what is missing"; exit 77; }

"$cmake" -S "$source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DEXTREMAL_MESH_3_WARNINGS_AS_ERRORS=ON \
  -DEXTREMAL_MESH_3_BUILD_PYTHON=ON -DEXTREMAL_MESH_3_BUILD_TESTS=OFF -DEXTREMAL_MESH_3_BUILD_EXAMPLES=OFF >"$work.configure.log"
"$cmake" --build "$work/build" >"$work.build.log" || { tail -30 "$work.build.log"; exit 1; }
cd "$work/build"
ctest -R '^python$' --no-tests=error --output-on-failure

# An installed module is found and works, away from the sources.
"$cmake" --install . --prefix "$work/installed" >"$work.install.log"
cd "$work"
PYTHONPATH=$work/installed/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c '
import extremal_mesh as em
mesh = em.extract("x^2/9 + y^2/4 + z^2 = 1", box=(-4, -3, -2, 4, 3, 2))
assert repr(mesh) == "<ExtremalMesh: 10 vertices, 16 edges, 8 cells>", mesh'
