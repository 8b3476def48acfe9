#!/bin/sh
# damaged_tiles.sh MPIEXEC PROGRAM: whatever has become of the file of finished tiles, --resume draws the same picture,
# and says how many tiles it still had and how many were damaged. Two runs never use the file at the same time.
set -u
mpiexec=$1 program=$2
# shellcheck source=tests/app/group.sh
. "$(dirname "$0")/group.sh"
cd "$place" || exit 1

# 15 tiles of 16 x 16 pixels.
options="--width 80 --height 48 --spp 4 --tile 16 --resume --out image.ppm"
resume() {
    # shellcheck disable=SC2086  # a word an argument
    timeout 60 "$mpiexec" -n 2 "$program" --threads 1 $options "$@" >"$place/stdout" 2>"$place/stderr"
}
"$program" --quiet --width 80 --height 48 --spp 4 --out right.ppm
# keep_tiles ARGUMENTS...: the file of a run, which removes it at its end, gets a second name, kept. On a busy machine,
# the run may be over before that.
keep_tiles() {
    until [ -e kept ]; do
        resume "$@" &
        while [ -d "/proc/$!" ] && [ ! -e kept ]; do
            for file in cluster-tiles/*.tiles; do ln "$file" kept && name=$file; done 2>/dev/null
            sleep 0.01
        done
        wait $!
    done
}
keep_tiles --seed 2 && mv kept other
keep_tiles && mv kept whole

# after WORDS: the run with the file that lies there draws the right picture, and says these words.
after() {
    mkdir -p cluster-tiles && mv damaged "$name"
    rm -f image.ppm
    resume || complain "$1: exit code $?"
    cmp -s right.ppm image.ppm || complain "$1: another picture"
    grep -q "^$1$" "$place/stdout" || complain "expected '$1', actual '$(grep tile "$place/stdout")'"
    [ ! -e cluster-tiles ] || complain "$1: something is left behind"
}
# edit PYTHON: makes `damaged` from the bytes of `whole`; a place has p bytes.
edit() { python3 -c "
p = 8 + 16 * 16 * 24
whole, other = bytearray(open('whole', 'rb').read()), open('other', 'rb').read()
$1
open('damaged', 'wb').write(whole)"; }
edit ''; after '15 tiles of 15 came from an earlier run'
edit 'whole = b""'; after '0 tiles of 15 came from an earlier run'
edit 'del whole[7 * p + 99:]'; after '7 tiles of 15 came from an earlier run; 1 damaged tile had to be drawn again'
edit 'whole += bytes(whole)'; after '15 tiles of 15 came from an earlier run'
edit 'whole[5 * p + 3] ^= 1; whole[9 * p + 999] ^= 128'
after '13 tiles of 15 came from an earlier run; 2 damaged tiles had to be drawn again'
edit 'whole[:] = bytes(len(whole))'; after '0 tiles of 15 came from an earlier run'
edit 'whole[:p] = whole[p:2 * p]'; after '14 tiles of 15 came from an earlier run; 1 damaged tile had to be drawn again'
edit 'whole = other'; after '0 tiles of 15 came from an earlier run; 15 damaged tiles had to be drawn again'

# Another run has the file. It is a link to somebody else's file.
mkdir cluster-tiles
(
    flock 9 && : >is_locked
    while [ -e is_locked ]; do sleep 0.1; done
) 9>"$name.lock" &
while [ ! -e is_locked ]; do sleep 0.1; done
resume; code=$?; expect 1 'another run of the same command has its tiles in cluster-tiles'
rm is_locked
wait
echo precious >somebody-elses
ln -s ../somebody-elses "$name"
resume; code=$?; expect 1 'cannot be opened'
[ "$(cat somebody-elses)" = precious ] || complain "somebody else's file is changed"
[ "$failures" -eq 0 ]
