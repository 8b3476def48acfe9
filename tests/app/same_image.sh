#!/bin/sh
# same_image.sh PROGRAM COMPARE IMAGE: the program still draws this picture at its default size.
set -eu
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
"$1" --quiet --out "$drawn/image.png"
"$2" "$3" "$drawn/image.png"
