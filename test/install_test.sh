#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# install_test.sh CMAKE BUILD_FOLDER CONSUMER_FOLDER CXX_COMPILER WORK_FOLDER
# Installs the build, moves the installed tree, and uses it as an outside project does: with find_package, with
# pkg-config, and by its program.
set -euo pipefail
cmake=$1 build=$2 consumer=$3 cxx=$4 work=$5

rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$cmake" --install "$build" --prefix "$work/first" >install.log
mv first installed

"$cmake" -S "$consumer" -B consumer -DCMAKE_PREFIX_PATH="$work/installed" -DCMAKE_CXX_COMPILER="$cxx" \
  -DCMAKE_BUILD_TYPE=Release >configure.log
"$cmake" --build consumer
consumer/my_program
[[ -s consumer.png && -s consumer.graphml ]]

installed/bin/extremal_mesh info consumer.graphml
[[ $(installed/bin/extremal_mesh --version) == "extremal_mesh $(sed -n 's/^set(PACKAGE_VERSION "\(.*\)")$/\1/p' \
  installed/lib*/cmake/Extremal_mesh_3/Extremal_mesh_3ConfigVersion.cmake)" ]]

if command -v pkg-config >/dev/null; then
  PKG_CONFIG_PATH=$(dirname "$(find "$work/installed" -name Extremal_mesh_3.pc)")
  export PKG_CONFIG_PATH
  read -ra flags <<<"$(pkg-config --cflags --libs Extremal_mesh_3)"
  "$cxx" -std=c++20 "$consumer/my_program.cpp" "${flags[@]}" -o with_pkg_config
  LD_LIBRARY_PATH=$(pkg-config --variable=libdir Extremal_mesh_3) ./with_pkg_config
fi

# What is installed names no folder of the machine it was built on.
if grep -rlF --include='*.cmake' --include='*.pc' --include='*.h' "$work" installed; then
  echo "the files above name $work" >&2
  exit 1
fi
