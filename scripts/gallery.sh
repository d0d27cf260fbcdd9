#!/usr/bin/env bash
# Copyright (c) 2026 The Extremal_mesh_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes the pictures of doc/gallery.md, doc/manual.md and the tutorials anew: runs the commands that the gallery shows.
#
#   scripts/gallery.sh PROGRAM [OUTPUT_FOLDER]      the default is doc/figures. That of the viewer needs Chromium.
set -euo pipefail
if [[ $# -lt 1 || $# -gt 2 ]]; then
  echo "usage: $0 PROGRAM [OUTPUT_FOLDER]" >&2
  exit 2
fi
program=$(realpath "$1")
root=$(realpath "$(dirname "$0")/..")
output=$(realpath "${2:-$root/doc/figures}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
ln -s "$root/data" "$root/scripts" .
extremal_mesh() { "$program" "$@"; }
export -f extremal_mesh
export program

# the blocks of shell commands of the gallery, in their order
awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$root/doc/gallery.md" >commands.sh
bash -euo pipefail commands.sh
# the page of the skull, as the manual shows it
extremal_mesh view skull.graphml --surface skull.ply -o skull.html --view 0.5 1 -0.2 --quiet
if command -v chromium >/dev/null; then
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/test /usr/bin/python3 - <<'P'
import browser
with browser.Page("skull.html", width=960, height=690) as page:
    page.evaluate("extremalMeshViewer.setLevel(12), extremalMeshViewer.select({ kind: 'edge', id: 100 })")
    page.settle()
    open("viewer.png", "wb").write(page.screenshot())
P
else
  echo "viewer.png stays as it is: there is no Chromium" >&2
fi
for picture in *.png; do
  mv "$picture" "$output/$picture"
  printf '%8d  %s\n' "$(stat -c %s "$output/$picture")" "$picture"
done
