#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing, builds, extracts the extremal meshes of a skull in a CT, of an ellipsoid and of a polygon
# mesh, and simplifies that of the skull.
#
#   scripts/demo.sh [OUTPUT_FOLDER]       the default is ./demo_output
#
# EXTREMAL_MESH_3_BUILD_DIR names a build that exists already, to be used instead of build/release.
set -euo pipefail
output=$(realpath -m "${1:-demo_output}")
cd "$(dirname "$0")/.."

if [[ -n ${EXTREMAL_MESH_3_BUILD_DIR:-} ]]; then
  tool=$(find "$EXTREMAL_MESH_3_BUILD_DIR" -name extremal_mesh -type f -perm -u+x -print -quit)
else
  source scripts/dependencies.sh
  install_dependencies
  build release extremal_mesh
  tool=build/release/src/tool/extremal_mesh
fi
mkdir -p "$output"

extract() { # TITLE NAME ARGUMENT…
  local title=$1 base=$output/$2
  shift 2
  printf '\n%s\n' "$title"
  "$tool" extract "$@" -o "$base.graphml" -o "$base.png" -o "$base.off" --lines "$base.lines.off" \
    --cells "$base.cells.ply" --surface "$base.surface.off" --report "$base.report.json"
  "$tool" check "$base.graphml"
}

extract "Ellipsoid with semi-axes 3, 2, 1" ellipsoid --formula "x^2/9 + y^2/4 + z^2 = 1" --box -4 -3 -2 4 3 2
extract "Skull in a CT (data/skull_2.9.nrrd)" skull data/skull_2.9.nrrd --iso 2.9 --view 0.5 1 -0.2
extract "Femur, a triangle mesh (data/femur.off)" femur data/femur.off --radius 0.1 --view 0.3 1 -0.2

printf '\nThe skull, simplified to 200 cells\n'
"$tool" simplify "$output/skull.graphml" --cells 200 --surface "$output/skull.cells.ply" --view 0.5 1 -0.2 \
  -o "$output/skull_200.graphml" -o "$output/skull_200.png" --persistence "$output/skull.persistence.svg"

printf '\nIn %s:\n' "$output"
ls -l "$output" | awk 'NR > 1 { printf "%12d  %s\n", $5, $9 }'
printf 'The pictures are %s, %s, %s and %s.\n' "$output/skull.png" "$output/skull_200.png" "$output/ellipsoid.png" \
  "$output/femur.png"
