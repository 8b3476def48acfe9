#!/bin/sh
# refining.sh PROGRAM SCENES: --target-error, --time-budget and --sampler do what they say,
# and print what they took.
set -u
program=$1
scenes=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
failures=0
complain() {
    failures=$((failures + 1))
    echo "$1"
}
draw() { "$program" "$@" --width 48 --height 27 --depth 9; }

# The estimated error is below the one that is asked for, in every scene and with every way to sample; the
# picture is the same for any number of threads.
for scene in matte cover lights fog motion; do
    for way in "--sampler jittered" "--sampler sobol" --batches "--batches --sampler jittered"; do
        for threads in 1 3; do
            # shellcheck disable=SC2086  # two words
            draw "$scenes/$scene.json" $way --target-error 0.05 --threads $threads \
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

# Without an aim: jittered samples are the usual ones, and Sobol's give a different picture of the same light.
draw "$scenes/cover.json" --spp 4 --quiet --out "$place/usual.ppm"
draw "$scenes/cover.json" --spp 4 --quiet --sampler jittered --out "$place/jittered.ppm"
draw "$scenes/cover.json" --spp 4 --quiet --sampler sobol --out "$place/sobol.ppm"
cmp "$place/usual.ppm" "$place/jittered.ppm" || complain "--sampler jittered is not the default"
cmp -s "$place/usual.ppm" "$place/sobol.ppm" && complain "--sampler sobol changes nothing"
mean() { tail -c 3888 "$1" | od -An -v -tu1 | awk '{ for (i = 1; i <= NF; ++i) sum += $i } END { print sum / 3888 }'; }
awk -v a="$(mean "$place/usual.ppm")" -v b="$(mean "$place/sobol.ppm")" \
    'BEGIN { exit !(a - b < 3 && b - a < 3) }' || complain "--sampler sobol draws another light"

# A tent shares samples among pixels: another picture of the same light, smoother, and the same for any number of threads.
draw "$scenes/cover.json" --spp 4 --quiet --filter box --out "$place/box.ppm"
cmp "$place/usual.ppm" "$place/box.ppm" || complain "--filter box is not the default"
for threads in 1 3; do
    # Several tiles.
    "$program" "$scenes/cover.json" --spp 4 --quiet --filter tent --width 148 --height 69 --depth 9 \
        --threads $threads --out "$place/tent$threads.ppm"
done
cmp "$place/tent1.ppm" "$place/tent3.ppm" || complain "--filter tent: threads change the picture"
draw "$scenes/cover.json" --spp 4 --quiet --filter tent --out "$place/tent.ppm"
awk -v a="$(mean "$place/usual.ppm")" -v b="$(mean "$place/tent.ppm")" \
    'BEGIN { exit !(a - b < 3 && b - a < 3) }' || complain "--filter tent draws another light"
steps() { tail -c 3888 "$1" | od -An -v -tu1 -w3 | awk '{ if (NR % 48 != 1) { d = $1 - before; sum += d < 0 ? -d : d }; before = $1 } END { print sum }'; }
awk -v a="$(steps "$place/sobol.ppm")" -v b="$(steps "$place/tent.ppm")" 'BEGIN { exit !(b < 0.9 * a) }' ||
    complain "--filter tent is not smoother: steps of $(steps "$place/tent.ppm"), box $(steps "$place/sobol.ppm")"

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
