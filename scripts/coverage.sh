#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   scripts/coverage.sh [CTEST_OPTION…]       the default is all tests
#
# Counts which lines of include/ and src/ the tests run (preset coverage). Prints them file by file; build/coverage/report/index.html
# shows them. Counters are not atomic, which would make threads wait for each other at every line: counts of lines that several threads run may
# be too low, but no line that was run counts as not run. The exit code is 1 if a test fails.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/dependencies.sh

install_dependencies "${coverage_packages[@]}"
build coverage
find build/coverage -name '*.gcda' -delete
status=0
ctest --preset coverage --parallel "$(nproc)" "$@" || status=1
mkdir -p build/coverage/report
gcovr --root . --filter include/ --filter src/ --exclude-unreachable-branches --exclude-throw-branches \
  --html-details build/coverage/report/index.html --txt - --print-summary build/coverage
exit "$status"
