#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   scripts/lint.sh [FILE.cpp…]       the default is all sources
#
# Checks the formatting of the code, and runs clang-tidy on it, as far as they are installed. Not part of the tests: it
# takes minutes.
set -euo pipefail
cd "$(dirname "$0")/.."

status=0
if command -v clang-format >/dev/null; then
  git ls-files -z '*.h' '*.cpp' | xargs -0 clang-format --dry-run -Werror || status=1
else
  echo "clang-format is not installed" >&2
fi
if command -v clang-tidy >/dev/null; then
  cmake --preset dev >/dev/null
  files=("$@")
  # ITK's headers refuse clang 14.
  [[ $# -gt 0 ]] || mapfile -t files < <(git ls-files 'src/*.cpp' ':!src/images/read_image.cpp')
  printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/dev --quiet || status=1
else
  echo "clang-tidy is not installed" >&2
fi
exit "$status"
