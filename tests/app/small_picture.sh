#!/bin/sh
# small_picture.sh PROGRAM CHAPTER: the program still draws its picture, at 96 x 54 pixels, byte for byte.
# small_pictures.txt has the cksum of each chapter's.
set -eu
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
"$1" --quiet --width 96 --height 54 --out "$drawn/image.ppm"
actual="$2 $(cksum <"$drawn/image.ppm")"
expected=$(grep "^$2 " "$(dirname "$0")/small_pictures.txt")
[ "$actual" = "$expected" ] && exit
echo "expected: $expected"
echo "actual:   $actual"
echo "If the picture was meant to change, put the new line into tests/app/small_pictures.txt."
exit 1
