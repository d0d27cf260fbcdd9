#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   scripts/benchmark.sh [OUT.csv] [OPTIONS of benchmark/comparison/compare.py]
#
# Builds what is compared with ITK, VTK and CGAL, runs ours and theirs in turn on the same inputs, and prints a table.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/dependencies.sh

packages+=(libvtk9-dev) # only to compare with
install_dependencies
cmake --preset benchmark >/dev/null
cmake --build --preset benchmark --parallel "$(nproc)" --target comparison

csv=()
if [[ $# -gt 0 && $1 != -* ]]; then
  csv=(--csv "$1")
  shift
fi
python3 benchmark/comparison/compare.py build/benchmark "${csv[@]}" "$@"
