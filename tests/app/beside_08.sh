#!/bin/sh
# beside_08.sh PROGRAM OF_08 SCENES RUN: without options, the program with all options draws what chapter 08's draws.
# That one refuses the options that it lacks and says what takes them, and `./course run`, whose source is RUN, knows them.
set -u
program=$1 of_08=$2 scenes=$3 run=$4
# shellcheck source=tests/app/complain.sh
. "$(dirname "$0")/complain.sh"

for scene in matte cover; do
    for one in "$program" "$of_08"; do
        "$one" "$scenes/$scene.json" --width 64 --height 36 --spp 2 --quiet --out "$place/$(basename "$one").ppm"
    done
    cmp "$place/$(basename "$program").ppm" "$place/$(basename "$of_08").ppm" || complain "$scene: another picture"
done

options() { "$1" --help | grep -o '^ *--[a-z-]*' | tr -d ' ' | sort; }
options "$program" >"$place/all"
options "$of_08" >"$place/of_08"
added=$(comm -23 "$place/all" "$place/of_08")
[ "$(echo "$added" | wc -w)" -ge 5 ] || complain "only $added are added"
for option in $added; do
    grep -q "\"$option\"" "$run" || complain "./course run does not know that 08's program has no $option"
    "$of_08" "$option" --out "$place/refused.png" 2>"$place/stderr"
    code=$?
    [ "$code" -eq 2 ] || complain "$option: exit code $code, not 2"
    grep -q ' ./course run 08 ' "$place/stderr" || complain "$option: $(cat "$place/stderr")"
done
[ ! -e "$place/refused.png" ] || complain "a picture was drawn"

[ "$failures" -eq 0 ]
