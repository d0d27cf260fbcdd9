#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# python_test.sh CMAKE SOURCE_FOLDER BUILD_FOLDER WORK_FOLDER
# Installs the Python module of a build by CMake, and by pip from a wheel, and uses it from there.
set -euo pipefail
cmake=$1 source=$2 build=$3 work=$4
rm -rf "$work"
mkdir -p "$work"

# An installed module is found and works, away from the sources.
"$cmake" --install "$build" --component python --prefix "$work/installed" >"$work.install.log"
try() { # FOLDER: a module that is installed there
  (cd "$work" && PYTHONPATH=$1 PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c '
import sys, extremal_mesh as em
assert em.__file__.startswith(sys.argv[1]), em.__file__
mesh = em.extract("x^2/9 + y^2/4 + z^2 = 1", box=(-4, -3, -2, 4, 3, 2))
assert repr(mesh) == "<ExtremalMesh: 10 vertices, 16 edges, 8 cells>", mesh' "$1")
}
try "$work/installed/lib/python3/dist-packages"

# The same by pip. Nothing is left in the tree.
if ! /usr/bin/python3 -c 'from importlib.util import find_spec; assert all(map(find_spec, ("pip", "wheel", "setuptools")))' 2>/dev/null; then
  echo "no wheel was made: python3-pip, python3-setuptools and python3-wheel bring what is missing"
  exit 0
fi
before=$(cd "$source" && ls -A)
EXTREMAL_MESH_3_PYTHON_BUILD_DIR=$build PYTHONDONTWRITEBYTECODE=1 \
  /usr/bin/python3 -m pip --disable-pip-version-check wheel "$source" --no-build-isolation --no-deps --wheel-dir "$work/wheels" \
  >"$work.wheel.log" 2>&1 || { tail -30 "$work.wheel.log"; exit 1; }
[[ $(cd "$source" && ls -A) == "$before" && ! -e $source/python/extremal_mesh.egg-info ]]
wheel=$(echo "$work"/wheels/extremal_mesh-*.whl)
/usr/bin/python3 -m zipfile -l "$wheel" | awk '{ print $1 }' >"$work/wheel.txt"
for file in extremal_mesh/__init__.py extremal_mesh/_core.pyi extremal_mesh/py.typed; do
  grep -qx "$file" "$work/wheel.txt" || { echo "$file is not in $wheel"; exit 1; }
done
/usr/bin/python3 -m pip --disable-pip-version-check install --no-deps --no-index --target "$work/site" "$wheel" >"$work.pip.log" 2>&1
try "$work/site"
