#!/bin/sh
# hung_rank.sh MPIEXEC PROGRAM: a rank that stops (SIGSTOP) in the middle of a run keeps nobody from finishing the picture.
# One line says which rank it was.
set -u
mpiexec=$1 program=$2
# shellcheck source=tests/app/group.sh
. "$(dirname "$0")/group.sh"
cd "$place" || exit 1

options="--width 192 --height 108 --spp 32 --tile 16"
# Rank $VICTIM stops by itself when half of the 84 places, of 6152 bytes each, are in the file of finished tiles.
cat >stopping.sh <<'END'
#!/bin/sh
if [ "$OMPI_COMM_WORLD_RANK" -eq "$VICTIM" ]; then
    rank=$$
    (
        until [ "$(stat -c %s cluster-tiles/*.tiles 2>/dev/null || echo 0)" -ge 258384 ]; do sleep 0.01; done
        kill -STOP $rank
    ) &
fi
exec "$@"
END
chmod +x stopping.sh
# shellcheck disable=SC2086  # a word an argument
"$program" --quiet $options --out right.ppm
for VICTIM in 1 2; do
    export VICTIM
    # shellcheck disable=SC2086
    timeout 60 "$mpiexec" -n 3 ./stopping.sh "$program" --quiet --threads 2 --resume $options --out image.ppm \
        >"$place/stdout" 2>"$place/stderr"
    code=$?
    expect 0 "rank $VICTIM on .* no longer answers; the others drew its tiles"
    cmp -s right.ppm image.ppm || complain "rank $VICTIM hangs: another picture"
    [ ! -e cluster-tiles ] || complain "rank $VICTIM hangs: finished tiles are left behind"
    rm -f image.ppm
done
[ "$failures" -eq 0 ]
