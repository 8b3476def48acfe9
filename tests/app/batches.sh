#!/bin/sh
# batches.sh PROGRAM SCENES: in batches, every scene is drawn byte for byte as ray by ray, whatever the number
# of threads, and --explain says what draws it.
set -u
program=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
failures=0
complain() {
    failures=$((failures + 1))
    echo "$1"
}

# Sizes that leave smaller tiles at the edges, and batches that are not full.
same() {
    name=$1
    shift
    "$program" "$@" --quiet --width 83 --height 45 --spp 5 --depth 9 --out "$place/single.ppm" || exit 1
    for threads in 1 2 3; do
        "$program" "$@" --quiet --width 83 --height 45 --spp 5 --depth 9 --threads $threads \
            --batches --out "$place/batches.ppm" || complain "$name: no picture"
        cmp "$place/single.ppm" "$place/batches.ppm" || complain "$name, $threads threads: another picture"
    done
}
same "the final scene"
for scene in "$2"/*.json; do
    same "$scene" "$scene"
done

"$program" "$2/matte.json" --batches --explain --width 16 --height 9 --spp 1 \
    --out "$place/matte.ppm" >"$place/said"
grep -q '^renderer: none, one of [0-9]* for batches$' "$place/said" || {
    complain "--explain does not say what draws matte.json:"
    cat "$place/said"
}
[ "$failures" -eq 0 ]
