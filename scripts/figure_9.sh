#!/bin/sh
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The paper's figure 9 for an image and a copy of it that was moved, resampled, and got noise: the table of the whole meshes, that of
# both simplified up to a persistence, and that of the simplified first one and the whole second one.
#
# usage: scripts/figure_9.sh BUILD IMAGE ISO SIGMA PERSISTENCE
# example: scripts/figure_9.sh build/ci cranium_ct.nrrd 300 3 24
set -eu
if [ $# -ne 5 ]; then
  echo "usage: $0 BUILD IMAGE ISO SIGMA PERSISTENCE" >&2
  exit 2
fi
program=$1/src/tool/extremal_mesh
graphs=$(mktemp -d)
trap 'rm -rf "$graphs"' EXIT
"$1"/benchmark/registration_experiment "$2" --iso "$3" --sigma "$4" --motions 1 --keep "$graphs" -o "$graphs"/results.csv >&2
"$program" register "$graphs"/a.graphml "$graphs"/1b.graphml -o "$graphs"/motion.json --quiet
compare() {
  echo "$1"
  "$program" compare "$graphs/$2" "$graphs/$3" --transform "$graphs"/motion.json
}
for mesh in a 1b; do
  "$program" simplify "$graphs"/$mesh.graphml --threshold "$5" -o "$graphs"/${mesh}_simple.graphml --quiet
done
compare "unsimplified" a.graphml 1b.graphml
compare "both simplified to persistence $5" a_simple.graphml 1b_simple.graphml
compare "the first one simplified, the second one whole" a_simple.graphml 1b.graphml
