#!/bin/sh
# ranks.sh MPIEXEC PROGRAM EFFECTS SCENES POOR_MPI [OTHER]: any number of ranks and threads draw the file that chapter
# 08's program EFFECTS draws, byte for byte. What is wrong is said in one line by one rank. With POOR_MPI, MPI has few
# tags, or no threads. OTHER is PROGRAM as another build: ranks that run different builds are refused.
set -u
mpiexec=$1 program=$2 effects=$3 scenes=$4 poor_mpi=$5
# shellcheck source=tests/app/group.sh
. "$(dirname "$0")/group.sh"
cd "$place" || exit 1

"$effects" --quiet --width 96 --height 54 --spp 4 --out right.ppm
for count in 1 2 3 4 16; do
    for threads in 1 2; do
        ranks "$count" "$threads" --width 96 --height 54 --spp 4 --tile 8 --out shared.ppm ||
            complain "$count ranks: exit code $?"
        cmp -s right.ppm shared.ppm || complain "$count ranks, $threads threads: another picture"
        rm -f shared.ppm
    done
done
ranks 4 1 --width 96 --height 54 --spp 4 --share slices --out slices.ppm || complain "slices: exit code $?"
cmp -s right.ppm slices.ppm || complain "slices: another picture"

# A scene that only rank 0 can read: the others get it from rank 0, and what it names.
mkdir scene && cp "$scenes"/planets.json "$scenes"/*.png scene
printf 'v 0 1 0\nv -1 -1 1\nv 1 -1 1\nv 0 -1 -1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n' >scene/pyramid.obj
cat >scene/meshes.json <<'END'
{"camera": {"look_from": [0, 1, 5], "look_at": [0, 0, 0], "vfov_deg": 50},
 "materials": {"gold": {"type": "metal", "color": "#ffcc66"}},
 "meshes": [{"file": "pyramid.obj", "material": "gold"}]}
END
cat >reader.sh <<'END'
#!/bin/sh
# All ranks but rank 0 find nothing where the scene is, and have nowhere to write to.
[ "$OMPI_COMM_WORLD_RANK" -eq 0 ] || { mkdir -p "elsewhere$OMPI_COMM_WORLD_RANK" && cd "elsewhere$OMPI_COMM_WORLD_RANK"; }
[ "$OMPI_COMM_WORLD_RANK" -eq 0 ] || export TMPDIR=/nowhere
exec "$@"
END
chmod +x reader.sh
for scene in planets meshes; do
    "$program" scene/$scene.json --quiet --width 64 --height 36 --spp 2 --out right.ppm
    timeout 60 "$mpiexec" -n 3 ./reader.sh "$program" scene/$scene.json --quiet --width 64 --height 36 --spp 2 --tile 4 \
        --out read.ppm 2>"$place/stderr" || complain "$scene, sent: exit code $?"
    cmp -s right.ppm read.ppm || complain "$scene, sent: another picture"
    [ -z "$(find elsewhere1 elsewhere2 -type f)" ] || complain "$scene, sent: a rank has written a file"
    rm -f read.ppm
done

# One line, whatever the number of ranks.
ranks 3 1 --bogus; code=$?; expect 2 bogus
ranks 3 1 nowhere.json; code=$?; expect 2 'does not exist'
ranks 3 1 --width 9 --height 9 --out nowhere/image.png; code=$?; expect 1 'does not exist'
with_few_tags() {
    timeout 60 "$mpiexec" -x LD_PRELOAD="$poor_mpi" -n 2 "$program" --quiet --spp 1 --tile 4 --out few.ppm "$@" \
        >"$place/stdout" 2>"$place/stderr"
}
with_few_tags --width 64 --height 36; code=$?; expect 2 'too many: 144, .* only up to 99;'
with_few_tags --width 64 --height 36 --share slices || complain "slices need no tags: exit code $?"
with_few_tags --width 40 --height 40 || complain "as many tiles as tags: exit code $?"
export POOR_MPI=yes
with_few_tags; code=$?; expect 1 'rank 0 on .* has an MPI that does not allow'
unset POOR_MPI
ranks 2 1 --frame 3 --frames 2; code=$?; expect 2 'go together'
ranks 2 1 --resume --share slices; code=$?; expect 2 'leave out --resume'
timeout 60 "$mpiexec" -n 1 "$program" --quiet --spp 2 : -n 1 "$program" --quiet --spp 3 >"$place/stdout" 2>"$place/stderr"
code=$?; expect 1 'rank 1 on .* other options'
if [ $# -gt 5 ]; then
    timeout 60 "$mpiexec" -n 2 "$program" --quiet : -n 1 "$6" --quiet >"$place/stdout" 2>"$place/stderr"
    code=$?; expect 1 'rank 2 on .* another program'
fi

# Under mpirun, stderr is a pipe. The bar is drawn if mpirun has a terminal, and only then.
bar() {
    script -qec "$mpiexec -n 2 $program --threads 1 --width 64 --height 36 --spp 1 --out bar.ppm $1" bar.txt \
        >"$place/stdout" 2>"$place/stderr"
}
if command -v script >/dev/null; then
    bar ''
    grep -q '[[]#' "$place/stdout" || complain "mpirun has a terminal: no progress bar"
    bar '2>errors.txt'
    if grep -q '[[]#' "$place/stdout" errors.txt; then complain "mpirun's stderr is a file: a progress bar"; fi
    bar --quiet
    if grep -q '[[]#' "$place/stdout"; then complain "--quiet: a progress bar"; fi
fi

# No room for finished tiles: a clear error, and what is finished stays. Only root may mount a disk.
mkdir cluster-tiles
if mount -t tmpfs -o size=20k tmpfs cluster-tiles 2>"$place/stderr"; then
    ranks 3 1 --width 64 --height 36 --spp 2 --tile 16 --resume --out full.ppm; code=$?
    expect 1 'cannot be written; free some space there. What is finished is kept'
    [ ! -e full.ppm ] || complain "a full disk: a picture was written"
    mount -o remount,size=1m cluster-tiles
    "$effects" --quiet --width 64 --height 36 --spp 2 --out right.ppm
    ranks 3 1 --width 64 --height 36 --spp 2 --tile 16 --resume --out full.ppm || complain "then room: exit code $?"
    cmp -s right.ppm full.ppm || complain "then room: another picture"
    umount cluster-tiles
fi

[ "$failures" -eq 0 ]
