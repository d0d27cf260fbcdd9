# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The one list of the Debian packages that the project needs, sourced by the other scripts.

packages=(
  # to build
  g++ cmake ninja-build pkg-config
  libboost-graph-dev libtbb-dev libfmt-dev nlohmann-json3-dev libpng-dev zlib1g-dev
  libinsighttoolkit5-dev libcli11-dev
  libcgal-dev libeigen3-dev libopenmesh-dev
  # to test
  libgtest-dev python3 python3-networkx python3-igraph
  meshlab xvfb xauth
  python3-vtk9 chromium dpkg-dev groff-base doxygen
  pybind11-dev python3-dev python3-numpy python3-pytest python3-pip python3-setuptools python3-wheel
)

# What only some scripts need: fuzz.sh, lint.sh, coverage.sh.
fuzz_packages=(clang-14 libclang-rt-14-dev)
lint_packages=(clang-format clang-tidy cppcheck)
coverage_packages=(gcovr)

# installs the packages that are missing. Elsewhere than on Debian and its kin, CMake tells what it does not find.
install_dependencies() { # [PACKAGE…]   beyond those above
  local packages=("${packages[@]}" "$@")
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is not a Debian system: install yourself what these packages hold: ${packages[*]}" >&2
    return 0
  fi
  local missing=() package as_root=()
  for package in "${packages[@]}"; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
  done
  [[ ${#missing[@]} -eq 0 ]] && return 0
  if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      echo "Missing packages; as root, run: apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing ${missing[*]}"
  if ! { "${as_root[@]}" apt-get update -qq &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}" >/dev/null; }; then
    echo "These packages could not be installed (is there a network?): ${missing[*]}" >&2
    return 1
  fi
}

# configures and builds with a preset.
build() { # PRESET [TARGET]
  cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" --parallel "$(nproc)" ${2:+--target "$2"}
}
