#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# clean_debian_test.sh CPACK BUILD_FOLDER DATA_FOLDER WORK_FOLDER
# Installs the .deb, with the packages that it depends on and no others, in a Debian 12 that has nothing but what every Debian has, and
# uses it there. An extra test, with EXTREMAL_MESH_3_EXTRA_TESTS only: it needs root, debootstrap and a network, and takes minutes. Exit code
# 77: something of this is missing.
#
# DEBIAN_MIRROR is where packages come from; otherwise they come from where this machine's do. A root that debootstrap has made is kept in WORK_FOLDER/bookworm and used again.
set -euo pipefail
cpack=$1 build=$2 data=$3 work=$4
skip() { echo "skipped: $1"; exit 77; }
mirror=${DEBIAN_MIRROR:-$(apt-get indextargets --format '$(SITE)' 'Codename: bookworm' 2>/dev/null | head -1)}
[[ -n $mirror ]] || skip "DEBIAN_MIRROR does not tell where packages of Debian 12 come from, nor does apt"
[[ $(id -u) -eq 0 ]] || skip "only root can change the root folder"
PATH=$PATH:/usr/sbin:/sbin
for tool in debootstrap chroot dpkg-deb; do
  command -v $tool >/dev/null || skip "there is no $tool"
done

mkdir -p "$work"
cd "$work"
if [[ ! -e bookworm/.complete ]]; then
  rm -rf bookworm
  if ! debootstrap --variant=minbase bookworm bookworm "$mirror" >debootstrap.log 2>&1; then
    tail -3 debootstrap.log
    skip "debootstrap made no root from $mirror"
  fi
  touch bookworm/.complete
fi

# a copy, so that the next run begins with a clean one
rm -rf root package
cp -a bookworm root
trap 'rm -rf "$work/root"' EXIT
for file in /etc/resolv.conf /etc/hosts; do
  if [[ -e $file ]]; then cp -L "$file" root/etc/; fi
done
"$cpack" --config "$build/CPackConfig.cmake" -G DEB -B "$work/package" >cpack.log
cp package/extremal-mesh-3_*.deb root/extremal-mesh-3.deb
cp "$data/skull_2.9.nrrd" "$data/femur.off" root/

inside() { LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot root "$@"; }
inside sh -c 'command -v extremal_mesh' && { echo "the root is not clean"; exit 1; }
inside apt-get update -qq
inside apt-get install -qq -y --no-install-recommends /extremal-mesh-3.deb >install.log 2>&1 || { tail -20 install.log; exit 1; }
echo "$(inside dpkg-query -f '.\n' -W | wc -l) packages, $(du -sm root | cut -f 1) MB"

version=$(dpkg-deb -f root/extremal-mesh-3.deb Version)
[[ $(inside extremal_mesh --version) == "extremal_mesh $version" ]]
inside extremal_mesh extract --formula 'x^2/9+y^2/4+z^2=1' --box -4 -3 -2 4 3 2 -o /e.graphml -o /e.png -o /e.html --cells /e.ply
inside extremal_mesh check /e.graphml >/dev/null
inside extremal_mesh extract /skull_2.9.nrrd --iso 2.9 --sigma 6 --largest -o /skull.graphml --quiet
inside extremal_mesh extract /femur.off --radius 0.1 -o /femur.graphml -o /femur.vtp --quiet
inside extremal_mesh register /skull.graphml /skull.graphml -o /motion.json --quiet
[[ -s root/e.png && -s root/usr/share/man/man1/extremal_mesh.1 || -s root/usr/share/man/man1/extremal_mesh.1.gz ]]
inside apt-get purge -qq -y extremal-mesh-3 >/dev/null 2>&1
[[ ! -e root/usr/bin/extremal_mesh && ! -e root/usr/include/CGAL/Extremal_mesh_3 ]]
echo "installed, used and removed in a clean Debian 12"
