#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# viewer_bundle_test.sh VIEWER_FOLDER WORK_FOLDER
# The script that is in the repository is what its sources give. Exit code 77: npm or its packages cannot be had.
set -euo pipefail
viewer=$1 work=$2

rm -rf "$work"
mkdir -p "$work"
cp -r "$viewer"/{.npmrc,package.json,package-lock.json,bundle.js,src} "$work"
cd "$work"
command -v npm >/dev/null || { echo "skipped: there is no npm"; exit 77; }
timeout 120 npm ci >npm.log 2>&1 || { tail -3 npm.log; echo "skipped: npm cannot get the packages"; exit 77; }
node bundle.js made.js
cmp made.js "$viewer/dist/viewer.js" || { echo "remake it: scripts/bundle_viewer.sh"; exit 1; }
