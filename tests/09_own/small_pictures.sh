#!/bin/sh
# small_pictures.sh PROGRAM SCENES: our answer draws each scene, small, and the list draws the same.
set -eu
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
for scene in "$2"/*.txt; do
    sed 's/^picture .*/picture 48 27 1 50/' "$scene" >"$drawn/scene.txt"
    "$1" "$drawn/scene.txt" "$drawn/tree.ppm"
    "$1" "$drawn/scene.txt" "$drawn/list.ppm" --list --threads 1
    cmp "$drawn/tree.ppm" "$drawn/list.ppm"
done
