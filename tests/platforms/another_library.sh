#!/bin/sh
# another_library.sh LIBRARY BUILD: the pictures are the same if the functions of <cmath> are rounded
# differently. BUILD/bin has the programs; those in float may be missing.
set -u
small_picture=$(dirname "$0")/../app/small_picture.sh
failed=0
for program in "$2"/bin/[0-9][0-9]_*_solution; do
    chapter=$(basename "$program" _solution)
    case $chapter in
        09_own) continue ;;  # uses <cmath>
    esac
    sh "$small_picture" "$chapter" double env "LD_PRELOAD=$1" "$program" || failed=1
    [ -x "${program}_float" ] || continue
    sh "$small_picture" "$chapter" float env "LD_PRELOAD=$1" "${program}_float" || failed=1
done
exit $failed
