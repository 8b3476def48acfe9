#!/bin/sh
# costs.sh PROGRAM: an effect that is absent costs nothing. Counts, with valgrind, the instructions that
# the narrowest renderer executes, and those of a loop written by hand for the same scene: 1 % more are
# allowed. costs.sh PROGRAM table: what each effect costs where it is present, compiled in, absent.
set -u
program=$1
if ! command -v valgrind >/dev/null; then
    echo "valgrind is not installed: instructions are not counted"
    exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# count SCENE WAY ROWS: how many instructions the whole program executes.
count() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$@" \
        >"$folder/stdout" 2>"$folder/stderr" || { cat "$folder/stderr" >&2; return 1; }
    sed -n 's/.*Collected : *\([0-9]*\).*/\1/p' "$folder/stderr"
}
# drawing SCENE WAY: those of drawing alone: without making the scene and its tree.
drawing() {
    all=$(count "$1" "$2" 27) || exit 1
    before=$(count "$1" "$2" 0) || exit 1
    echo $((all - before))
}

if [ "${2:-}" = table ]; then
    none=$(drawing matte narrow)
    echo "effect,absent,compiled in,present"
    for effect in mirror fuzz glass texture lens motion lights fog haze; do
        echo "$effect,$none,$(drawing matte $effect),$(drawing $effect narrow)"
    done
    echo "all,$none,$(drawing matte full),"
    exit
fi

failures=0
for scene in matte metal glass_lens; do
    [ "$("$program" $scene narrow 27)" = "$("$program" $scene hand 27)" ] || {
        echo "$scene: the narrowest renderer and the loop by hand draw different pictures"
        failures=$((failures + 1))
    }
    narrow=$(drawing $scene narrow) || exit 1
    hand=$(drawing $scene hand) || exit 1
    echo "$scene: $narrow instructions, by hand $hand: $((narrow * 10000 / hand)) in 10000"
    if [ "$narrow" -le 0 ] || [ $((narrow * 100)) -gt $((hand * 101)) ]; then
        echo "$scene: more than 1 % more than by hand"
        failures=$((failures + 1))
    fi
done
[ "$failures" -eq 0 ]
