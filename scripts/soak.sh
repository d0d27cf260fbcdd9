#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   scripts/soak.sh SECONDS [SEED]
#
# Random surfaces through extract, check, simplify, register, write and read, for so long, in one process: no failure, and memory
# that does not grow. Prints a line every half a minute; the exit code is 1 if something fails.
set -euo pipefail
cd "$(dirname "$0")/.."
if [[ ! ${1:-} =~ ^[0-9]+$ ]]; then
  echo "usage: $0 SECONDS [SEED]" >&2
  exit 2
fi
if [[ -z ${SOAK_NO_BUILD:-} ]]; then
  cmake --preset ci >/dev/null
  cmake --build --preset ci --target soak --parallel "$(nproc)" >/dev/null
fi
exec build/ci/test/soak/soak "$@"
