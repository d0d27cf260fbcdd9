#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# package_test.sh CPACK BUILD_FOLDER WORK_FOLDER
# Makes the .deb, looks into it, and runs the program, the manual page and the completion that it holds. Exit code 77: this is no
# Debian.
set -euo pipefail
cpack=$1 build=$2 work=$3
for tool in dpkg-deb dpkg-shlibdeps; do
  command -v $tool >/dev/null || { echo "skipped: there is no $tool; the packages dpkg and dpkg-dev bring it"; exit 77; }
done

rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$cpack" --config "$build/CPackConfig.cmake" -G DEB -B "$work" >cpack.log
package=$(echo "$work"/extremal-mesh-3_*.deb)
[[ -s $package ]]

field() { dpkg-deb -f "$package" "$1"; }
[[ $(field Package) == extremal-mesh-3 ]]
[[ $(field Depends) == *libc6* ]] # dpkg-shlibdeps has looked at the program
dpkg-deb -c "$package" | awk '{ print $6 }' >content.txt
for file in bin/extremal_mesh share/man/man1/extremal_mesh.1 share/bash-completion/completions/extremal_mesh \
  include/CGAL/Extremal_mesh_3/Extremal_mesh.h; do
  grep -qx "./usr/$file" content.txt || { echo "/usr/$file is not in the package"; exit 1; }
done
if grep -v '^\./$\|^\./usr/' content.txt; then
  echo "the files above are not under /usr"
  exit 1
fi

dpkg-deb -x "$package" root
program=$work/root/usr/bin/extremal_mesh
[[ $("$program" --version) == "extremal_mesh $(field Version)" ]]
"$program" extract --formula 'x^2/9+y^2/4+z^2=1' --box -4 -3 -2 4 3 2 --resolution 24 -o e.graphml --quiet
"$program" check e.graphml >/dev/null

# The manual page has each command with its example, and no warning.
man=root/usr/share/man/man1/extremal_mesh.1
commands=$("$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z-]*\)  .*/\1/p')
[[ $(wc -w <<<"$commands") -ge 12 ]]
for command in $commands; do
  grep -q "^\.SS ${command//-/\\\\-}\$" "$man" || { echo "$command is not in the manual page"; exit 1; }
  "$program" "$command" --help | grep -q "^ *extremal_mesh $command " || { echo "the help of $command has no example"; exit 1; }
done
if command -v groff >/dev/null; then
  groff -man -Kutf8 -Tutf8 -ww "$man" 2>warnings.txt >page.txt
  if [[ -s warnings.txt ]]; then
    cat warnings.txt
    exit 1
  fi
fi

# The completion, as bash calls it.
complete_words() { # WORD…: what the last one can become
  bash -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _extremal_mesh; echo "${COMPREPLY[*]}"' bash \
    root/usr/share/bash-completion/completions/extremal_mesh "$@"
}
[[ $(complete_words extremal_mesh extr) == extract ]]
[[ $(complete_words extremal_mesh extract --form) == --formula ]]
[[ $(complete_words extremal_mesh extract --mesher '') == "grid cgal" ]]
[[ -z $(complete_words extremal_mesh info e.g) ]] # left to bash, which completes files

# Nothing names the folder that it was built in.
if grep -rlF "$build" root/usr/lib root/usr/share root/usr/include --include='*.cmake' --include='*.pc' --include='*.1' --include='*.h'; then
  echo "the files above name $build"
  exit 1
fi
