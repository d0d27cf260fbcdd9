#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Remakes viewer/dist/viewer.js from viewer/src and three.js, after a change of either. Needs npm; builds do not, as the
# result is in the repository.
set -euo pipefail
cd "$(dirname "$0")/../viewer"
npm ci
node bundle.js
