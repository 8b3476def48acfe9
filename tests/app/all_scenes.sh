#!/bin/sh
# all_scenes.sh PROGRAM SCENES: every scene file is drawn, at a small size, without a word.
set -u
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
for scene in "$2"/*.json; do
    "$1" "$scene" --quiet --width 64 --height 36 --spp 1 --out "$place/image.png" || exit 1
done
