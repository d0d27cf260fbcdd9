#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing, builds with warnings as errors, runs all tests. The last line counts them; the exit code
# is 0 if all passed.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/dependencies.sh

install_dependencies
build ci

log=build/ci/ctest.log
status=0
ctest --preset ci --parallel "$(nproc)" | tee "$log" || status=$?

# 98% tests passed, 2 tests failed out of 100
counts=$(sed -n 's/^.* tests passed, \([0-9]*\) tests* failed out of \([0-9]*\)$/\1 \2/p' "$log")
read -r failed all <<<"${counts:-0 0}"
if [[ $all -eq 0 ]]; then
  echo "0 passed, 0 failed: no test was run"
  exit 1
fi
skipped=$(grep -c '\*\*\*Skipped' "$log" || true)
[[ $skipped -eq 0 ]] || echo "$skipped skipped"
echo "$((all - failed - skipped)) passed, $failed failed"
exit "$status"
