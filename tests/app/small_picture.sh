#!/bin/sh
# small_picture.sh CHAPTER PRECISION PROGRAM...: the program still draws its picture, at 96 x 54 pixels,
# byte for byte. small_pictures.txt holds the cksum of each. Before the program there may be words that run
# it, such as an emulator.
#
# small_picture.sh --update BUILD: draws all pictures with the programs of this build folder, and writes the
# file again. Build solution_programs and float_programs first.
set -eu
here=$(dirname "$0")
table=$here/small_pictures.txt
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT

# line CHAPTER PRECISION PROGRAM...: the table's line for what this program draws. For chapter 09 there is
# one for each of its scenes.
line() {
    chapter=$1 precision=$2
    shift 2
    case $chapter in
    09_own)
        for program; do :; done  # the last word
        for scene in "$(dirname "$program")"/../own_start/scenes/*.txt; do
            sed 's/^picture .*/picture 48 27 1 50/' "$scene" >"$drawn/scene.txt"
            "$@" "$drawn/scene.txt" "$drawn/image.ppm"
            echo "$chapter.$(basename "$scene" .txt) $precision $(cksum <"$drawn/image.ppm")"
        done ;;
    *)
        "$@" --quiet --width 96 --height 54 --out "$drawn/image.ppm"
        echo "$chapter $precision $(cksum <"$drawn/image.ppm")" ;;
    esac
}

if [ "$1" = --update ]; then
    bin=$(realpath "$2")/bin
    for program in "$bin"/[0-9][0-9]_*_solution; do
        chapter=$(basename "$program" _solution)
        line "$chapter" double "$program"
        if [ -x "${program}_float" ]; then line "$chapter" float "${program}_float"; fi
    done >"$drawn/table"
    cp "$drawn/table" "$table"
    exit
fi

actual=$(line "$@")
expected=$(grep -E "^$1(\.[a-z]+)? $2 " "$table")
[ "$actual" = "$expected" ] && exit
echo "expected:"
echo "$expected"
echo "actual:"
echo "$actual"
echo "If the picture was meant to change: tests/app/small_picture.sh --update BUILD"
exit 1
