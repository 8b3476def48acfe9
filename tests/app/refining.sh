#!/bin/sh
# refining.sh PROGRAM SCENES: --target-error, --time-budget and --sampler do what they say,
# and print what they took.
set -u
program=$1
scenes=$2
# shellcheck source=tests/app/complain.sh
. "$(dirname "$0")/complain.sh"
draw() { "$program" "$@" --width 48 --height 27 --depth 9; }

# A scene with a mesh: two pyramids without a floor.
cat >"$place/pyramid.obj" <<'END'
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
v 0 1.5 0
f 1 5 2
f 2 5 3
f 3 5 4
f 4 5 1
END
cat >"$place/pyramids.json" <<'END'
{"camera": {"look_from": [2, 2, 5], "look_at": [0, 0.5, 0]},
 "materials": {"floor": {"type": "matte", "color": "#808080"}, "gold": {"type": "metal", "color": "#ffcf7a", "fuzz": 0.4}},
 "spheres": [{"center": [0, -100, 0], "radius": 100, "material": "floor"}],
 "meshes": [{"file": "pyramid.obj", "material": "gold"}, {"file": "pyramid.obj", "center": [2, 0, -2], "material": "floor"}]}
END

# The estimated error is below the one that is asked for, in every scene and with every way to sample; the
# picture is the same for any number of threads.
for scene in "$scenes/matte" "$scenes/cover" "$scenes/lights" "$scenes/fog" "$scenes/motion" "$place/pyramids"; do
    for way in "--sampler jittered" "--sampler sobol" --batches "--batches --sampler jittered"; do
        for threads in 1 3; do
            # shellcheck disable=SC2086  # two words
            draw "$scene.json" $way --target-error 0.05 --threads $threads \
                --out "$place/$threads.ppm" >"$place/said" || complain "$scene $way: no picture"
        done
        cmp "$place/1.ppm" "$place/3.ppm" || complain "$scene $way: threads change the picture"
        error=$(sed -n 's/^error: *\([0-9.e-]*\) .*/\1/p' "$place/said")
        awk -v error="$error" 'BEGIN { exit !(error > 0 && error <= 0.05) }' ||
            complain "$scene $way: error '$error' was said, expected at most 0.05"
    done
done

# Refining takes Sobol's points unless told otherwise.
for way in "" "--sampler sobol" "--sampler jittered"; do
    # shellcheck disable=SC2086  # none, or two words
    draw "$scenes/cover.json" $way --target-error 0.05 --quiet --out "$place/way$(echo "$way" | tr -d ' -').ppm"
done
cmp "$place/way.ppm" "$place/waysamplersobol.ppm" || complain "refining does not take Sobol's points"
cmp -s "$place/way.ppm" "$place/waysamplerjittered.ppm" && complain "refining takes jittered samples"

mean() { tail -c 3888 "$1" | od -An -v -tu1 | awk '{ for (i = 1; i <= NF; ++i) sum += $i } END { print sum / 3888 }'; }
steps() { tail -c 3888 "$1" | od -An -v -tu1 -w3 | awk '{ if (NR % 48 != 1) { d = $1 - before; sum += d < 0 ? -d : d }; before = $1 } END { print sum }'; }
# alike PICTURE OTHER WHAT: two pictures of the same light.
alike() {
    awk -v a="$(mean "$1")" -v b="$(mean "$2")" 'BEGIN { exit !(a - b < 3 && b - a < 3) }' ||
        complain "$scene: $3 draws another light: $(mean "$2"), expected $(mean "$1")"
}
for scene in "$scenes/cover.json" "$place/pyramids.json"; do
    # Without an aim: jittered samples are the usual ones, and Sobol's give a different picture of the same light.
    draw "$scene" --spp 4 --quiet --out "$place/usual.ppm"
    draw "$scene" --spp 4 --quiet --sampler jittered --out "$place/jittered.ppm"
    draw "$scene" --spp 4 --quiet --sampler sobol --out "$place/sobol.ppm"
    draw "$scene" --spp 4 --quiet --sampler sobol --threads 3 --out "$place/sobol3.ppm"
    cmp "$place/usual.ppm" "$place/jittered.ppm" || complain "$scene: --sampler jittered is not the default"
    cmp -s "$place/usual.ppm" "$place/sobol.ppm" && complain "$scene: --sampler sobol changes nothing"
    cmp "$place/sobol.ppm" "$place/sobol3.ppm" || complain "$scene: --sampler sobol: threads change the picture"
    alike "$place/usual.ppm" "$place/sobol.ppm" "--sampler sobol"

    # A tent shares samples among pixels: another picture of the same light, smoother, and the same for any number of
    # threads.
    draw "$scene" --spp 4 --quiet --filter box --out "$place/box.ppm"
    cmp "$place/usual.ppm" "$place/box.ppm" || complain "$scene: --filter box is not the default"
    for threads in 1 3; do
        # Several tiles.
        "$program" "$scene" --spp 4 --quiet --filter tent --width 148 --height 69 --depth 9 \
            --threads $threads --out "$place/tent$threads.ppm"
    done
    cmp "$place/tent1.ppm" "$place/tent3.ppm" || complain "$scene: --filter tent: threads change the picture"
    draw "$scene" --spp 4 --quiet --filter tent --out "$place/tent.ppm"
    alike "$place/usual.ppm" "$place/tent.ppm" "--filter tent"
    awk -v a="$(steps "$place/sobol.ppm")" -v b="$(steps "$place/tent.ppm")" 'BEGIN { exit !(b < 0.9 * a) }' ||
        complain "$scene: --filter tent is not smoother: steps of $(steps "$place/tent.ppm"), box $(steps "$place/sobol.ppm")"
done
# Meshes are drawn path by path, in batches, too.
draw "$place/pyramids.json" --spp 4 --quiet --batches --out "$place/batches.ppm"
cmp "$place/usual.ppm" "$place/batches.ppm" || complain "--batches draws another picture of a mesh"

# The time is kept, within what a busy machine needs to start and to write the file.
start=$(date +%s%N)
draw "$scenes/cover.json" --time-budget 0.5 --out "$place/timed.ppm" >"$place/said" ||
    complain "--time-budget: no picture"
took=$((($(date +%s%N) - start) / 1000000))
if [ "$took" -lt 300 ] || [ "$took" -gt 2500 ]; then complain "--time-budget 0.5 took $took ms"; fi
grep -q '^samples: .* a pixel on average' "$place/said" || complain "--time-budget does not say what it took"

# Options that exclude each other.
refused() {
    expected=$1
    shift
    draw "$@" --out "$place/none.ppm" >/dev/null 2>"$place/said"
    code=$?
    if [ $code -ne 2 ] || ! grep -q -e "$expected" "$place/said"; then
        complain "$*: expected exit code 2 and: $expected, actual $code and:"
        cat "$place/said"
    fi
    [ ! -e "$place/none.ppm" ] || complain "$*: left a picture"
}
refused "exclude each other" --target-error 0.1 --time-budget 1
refused "exclude each other" --target-error 0.1 --spp 4
refused "exclude each other" --filter tent --target-error 0.1
refused "exclude each other" --filter tent --sampler jittered
refused "'0' is not a number greater than 0" --target-error 0
refused "'-1' is not a number greater than 0" --time-budget=-1
refused "'nan' is not a number greater than 0" --time-budget nan
[ "$failures" -eq 0 ]
