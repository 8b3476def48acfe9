#!/bin/sh
# same_image.sh PROGRAM COMPARE IMAGE: the program still draws this picture, as large as it is.
set -eu
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
# Bytes 16 to 23 of a PNG are its width and height.
# shellcheck disable=SC2046  # eight words
set -- "$@" $(od -An -tu1 -j16 -N8 "$3")
"$1" --quiet --width $(($6 * 256 + $7)) --height $((${10} * 256 + ${11})) --out "$drawn/image.png"
"$2" "$3" "$drawn/image.png"
