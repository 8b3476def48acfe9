#!/bin/sh
# memory.sh MPIEXEC PROGRAM ONE_FILE: what a rank keeps in its memory: rank 0 one picture, the others none; if the ranks
# write into one file (ONE_FILE), no rank keeps a picture.
set -u
mpiexec=$1 program=$2 one_file=$3
# shellcheck source=tests/app/group.sh
. "$(dirname "$0")/group.sh"
cd "$place" || exit 1

# Writes the most memory that a rank had, in KiB, to memory.RANK.
cat >watched.py <<'END'
import os, resource, subprocess, sys
code = subprocess.call(sys.argv[1:])
with open("memory." + os.environ["OMPI_COMM_WORLD_RANK"], "w") as out:
    print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, file=out)
sys.exit(code)
END
measure() {
    timeout 100 "$mpiexec" -n 2 python3 watched.py "$@" >"$place/stdout" 2>"$place/stderr" || complain "$*: exit code $?"
}
more_than() {  # RANK MOST NAME
    more=$(($(cat "memory.$1") - $(cat "small.$1")))
    [ "$more" -le "$2" ] || complain "$3: rank $1 needs $more KiB more for the larger picture, expected $2 at most"
}
keep_small() { for rank in 0 1; do mv "memory.$rank" "small.$rank"; done; }

# 1000 x 1000 colors take 23,438 KiB, and the bytes of the file a quarter of that or two.
tiles() { measure "$program" --quiet --threads 1 --width "$1" --height "$1" --spp 1 --depth 1 --out image.ppm; }
tiles 100 && keep_small && tiles 1000
more_than 0 38000 tiles
more_than 1 8000 tiles
slices() { measure "$program" --quiet --threads 1 --width "$1" --height "$1" --spp 1 --depth 1 --share slices --out image.ppm; }
slices 100 && keep_small && slices 1000
more_than 0 47000 slices  # the picture, and its own half
more_than 1 16000 slices
into_one() { measure "$one_file" "$1" "$1" 1 one.ppm; }
into_one 100 && keep_small && into_one 1000
more_than 0 8000 'one file'
more_than 1 8000 'one file'
[ "$failures" -eq 0 ]
