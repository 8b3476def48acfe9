#!/bin/sh
# batches.sh PROGRAM SCENES: in batches, every scene is drawn byte for byte as ray by ray, whatever the number
# of threads, and --explain says what draws it.
set -u
program=$1
scenes=$2
# shellcheck source=tests/app/complain.sh
. "$(dirname "$0")/complain.sh"

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
for scene in "$scenes"/*.json; do
    same "$scene" "$scene"
done
# Sobol's points, and those filtered: with a lens, with all materials, and with lights, path by path.
for scene in cover textures lights; do
    same "$scene, Sobol" "$scenes/$scene.json" --sampler sobol
    same "$scene, tent" "$scenes/$scene.json" --filter tent
done

# explains SCENE RENDERER options...: what --explain says draws the scene.
explains() {
    scene=$1
    expected=$2
    shift 2
    "$program" "$scenes/$scene.json" --batches "$@" --explain --width 16 --height 9 --spp 1 \
        --out "$place/$scene.ppm" >"$place/said"
    grep -q "^renderer: $expected\$" "$place/said" || {
        complain "--explain $* does not say what draws $scene.json:"
        cat "$place/said"
    }
}
for way in "--sampler jittered" "--sampler sobol" "--filter tent"; do
    # shellcheck disable=SC2086  # two words
    explains matte "mirror, fuzz, glass, texture, lens, in batches" $way
done
# Lights take each path on by itself: batches would gain nothing.
explains lights "lights, one of [0-9]*"
[ "$failures" -eq 0 ]
