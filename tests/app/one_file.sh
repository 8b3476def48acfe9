#!/bin/sh
# one_file.sh MPIEXEC PROGRAM EFFECTS: the file into which several ranks write their tiles (PROGRAM) is the one that
# chapter 08's program EFFECTS writes, byte for byte.
set -u
mpiexec=$1 program=$2 effects=$3
# shellcheck source=tests/app/group.sh
. "$(dirname "$0")/group.sh"
cd "$place" || exit 1

"$effects" --quiet --width 100 --height 54 --spp 2 --out right.ppm
for count in 1 2 3 4; do
    head -c 99999 /dev/zero >one.ppm  # an older, longer file
    timeout 60 "$mpiexec" -n "$count" "$program" 100 54 2 one.ppm 2>"$place/stderr" || complain "$count ranks: exit code $?"
    cmp right.ppm one.ppm || complain "$count ranks: another file"
    rm -f one.ppm
done
[ "$failures" -eq 0 ]
