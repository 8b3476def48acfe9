#!/bin/sh
# lost_ranks.sh MPIEXEC PROGRAM TIMES: a rank is killed in the middle of a run, so many times, each time at another
# moment of a picture of another seed; then --resume goes on from the tiles that are on the disk, and draws the same
# bytes. Nothing is drawn twice but what was lost.
set -u
mpiexec=$1 program=$2 times=$3
# shellcheck source=tests/app/group.sh
. "$(dirname "$0")/group.sh"
cd "$place" || exit 1

# Prints how many of the places of a file of tiles, each of so many bytes, have been written.
cat >written.py <<'END'
import pathlib, sys
data, size = pathlib.Path(sys.argv[1]).read_bytes(), int(sys.argv[2])
print(sum(any(data[at:at + size]) for at in range(0, len(data), size)))
END
place_size=$((8 + 16 * 16 * 24))
kept=0
for seed in $(seq "$times"); do
    options="--width 192 --height 108 --spp 16 --tile 16 --seed $seed"
    # shellcheck disable=SC2086  # a word an argument
    "$program" --quiet $options --out right.ppm
    # shellcheck disable=SC2086
    "$mpiexec" -n 4 "$program" --quiet --threads 2 --resume $options --out lost.ppm \
        >"$place/stdout" 2>"$place/stderr" &
    # When so many of its 84 places are in the file, or it has ended.
    moment=$((seed * 37 % 85))
    while [ -d "/proc/$!" ] && [ "$(stat -c %s cluster-tiles/*.tiles 2>/dev/null || echo 0)" -lt $((moment * place_size)) ]; do
        sleep 0.01
    done
    # One of its ranks: found by its parent, since other tests run the same program.
    victim=$(ps -o pid= --ppid $! | sed -n "$((1 + seed % 4))p")
    [ -z "$victim" ] || kill -9 "$victim"
    wait $!
    if [ -e lost.ppm ]; then
        cmp -s right.ppm lost.ppm || complain "seed $seed: a killed run wrote another picture"
    fi
    written=0
    [ ! -e cluster-tiles ] || written=$(python3 written.py cluster-tiles/*.tiles $place_size)
    [ "$written" -eq 0 ] || kept=$((kept + 1))
    # shellcheck disable=SC2086
    timeout 60 "$mpiexec" -n 3 "$program" --threads 1 --resume $options --out again.ppm >"$place/stdout" 2>"$place/stderr" ||
        complain "seed $seed: --resume ended with $?"
    cmp -s right.ppm again.ppm || complain "seed $seed: $written tiles were kept, and --resume draws another picture"
    found=$(sed -n 's/ tiles\? of 84 came from an earlier run.*//p' "$place/stdout")
    damaged=$(sed -n 's/.*; \([0-9]*\) damaged tiles\? .*/\1/p' "$place/stdout")
    # The rank that was killed may have been in the middle of writing one.
    { [ $((found + ${damaged:-0})) -eq "$written" ] && [ "${damaged:-0}" -le 1 ]; } ||
        complain "seed $seed: the file had $written tiles, and $found are found, ${damaged:-0} damaged"
    [ ! -e cluster-tiles ] || complain "seed $seed: finished tiles are left behind"
    rm -f lost.ppm again.ppm
done
echo "$times runs lost a rank, $kept of them with finished tiles; $failures failures"
[ "$failures" -eq 0 ]
