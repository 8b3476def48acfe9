#!/bin/sh
# lost_ranks.sh MPIEXEC PROGRAM TIMES: a rank is killed at a random moment of a run, so many times, each time in a
# picture of another seed; then --resume goes on from the tiles that are on the disk, and draws the same bytes.
set -u
mpiexec=$1 program=$2 times=$3
# shellcheck source=tests/app/group.sh
. "$(dirname "$0")/group.sh"
cd "$place" || exit 1

kept=0
for seed in $(seq "$times"); do
    options="--width 192 --height 108 --spp 32 --tile 16 --seed $seed"
    # shellcheck disable=SC2086  # a word an argument
    "$program" --quiet $options --out right.ppm
    # shellcheck disable=SC2086
    "$mpiexec" -n 4 "$program" --quiet --threads 1 --resume $options --out lost.ppm \
        >"$place/stdout" 2>"$place/stderr" &
    # When so many of its 84 tiles are finished, or it has ended.
    moment=$(shuf -i 0-90 -n 1)
    while [ -d "/proc/$!" ] && [ "$(find cluster-tiles -name '*.tile' 2>"$place/stdout" | wc -l)" -lt "$moment" ]; do
        sleep 0.01
    done
    # One of its ranks, at random. It is found by its parent, since other tests run the same program.
    for victim in $(ps -o pid= --ppid $! | shuf -n 1); do kill -9 "$victim"; done
    wait $!
    if [ -e lost.ppm ]; then
        cmp -s right.ppm lost.ppm || complain "seed $seed: a killed run wrote another picture"
    fi
    tiles=$(find cluster-tiles -name '*.tile' 2>"$place/stdout" | wc -l)
    [ "$tiles" -eq 0 ] || kept=$((kept + 1))
    # shellcheck disable=SC2086
    ranks 3 1 --resume $options --out again.ppm || complain "seed $seed: --resume ended with $?"
    cmp -s right.ppm again.ppm || complain "seed $seed: $tiles tiles were kept, and --resume draws another picture"
    [ ! -e cluster-tiles ] || complain "seed $seed: finished tiles are left behind"
    rm -f lost.ppm again.ppm
done
echo "$times runs lost a rank, $kept of them with finished tiles; $failures failures"
[ "$failures" -eq 0 ]
