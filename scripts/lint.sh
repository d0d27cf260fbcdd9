#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
#   scripts/lint.sh [FILE.cpp…]       the default is all sources
#
# Checks the formatting of the code, and runs cppcheck and clang-tidy on it. Not part of the tests: it takes minutes. The exit
# code is 1 if one of them finds something.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/dependencies.sh

install_dependencies "${lint_packages[@]}"
cmake --preset dev >/dev/null
files=("$@")
[[ $# -gt 0 ]] || mapfile -t files < <(git ls-files 'src/*.cpp')

status=0
git ls-files -z '*.h' '*.cpp' | xargs -0 clang-format --dry-run -Werror || status=1

# Without its advice on style. It does not know the headers of the system.
cppcheck --quiet --std=c++20 --language=c++ --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
  -j "$(nproc)" -I include --suppressions-list=scripts/cppcheck_suppressions.txt "${files[@]}" || status=1

# ITK's headers refuse clang 14.
for file in "${files[@]}"; do
  [[ $file == src/images/@(dicom|read_image).cpp ]] || printf '%s\0' "$file"
done | xargs -0 -r -n 1 -P "$(nproc)" clang-tidy -p build/dev --quiet || status=1
exit "$status"
