#!/bin/sh
# What effects cost, in instructions, which valgrind counts.
#
#   costs.sh PROGRAM         an effect that is absent costs nothing: a renderer without it executes at most 1 % more
#                            instructions than a loop written by hand for the same scene. And instructions.csv, from
#                            which the texts quote, is what the program does.
#   costs.sh PROGRAM record  writes instructions.csv anew; then run tests/figures.py --write
set -u
program=$1
record=$(dirname "$0")/instructions.csv
if ! command -v valgrind >/dev/null; then
    echo "valgrind is not installed: instructions are not counted"
    exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# drawing SCENE RENDERER: how many instructions drawing takes.
drawing() {
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect='*sum_of*' "$program" "$@" \
        >"$folder/stdout" 2>"$folder/stderr" || { cat "$folder/stderr" >&2; return 1; }
    sed -n 's/.*Collected : *\([0-9]*\).*/\1/p' "$folder/stderr"
}

# row VARIANT X X_NAME COUNT WITHOUT: a line of the record. WITHOUT is the count with which this one is compared.
row() {
    awk -v variant="$1" -v x="$2" -v x_name="$3" -v count="$4" -v without="$5" 'BEGIN {
        printf "%s,double,%d,\"%s\",%.6g,%% more instructions,%.6g,million instructions\n",
               variant, x, x_name, 100 * (count / without - 1), count / 1e6 }'
}

# The record: each effect in a renderer of its own, where it is absent, unused and present; the renderers that scenes
# share, against those; and loops written by hand.
measure() {
    materials=$("$program" materials)
    lit=$("$program" lit)
    every=$("$program" every)
    echo "study,variant,precision,x,x_name,error,error_name,cost,cost_name"
    echo "compiler,$("$program" compiler),,,,,,,"
    none=$(drawing none none) || return
    is="absent, unused, present"
    by="all materials, lights and instances too, everything"
    for effect in $("$program" effects); do
        unused=$(drawing none "$effect") && present=$(drawing "$effect" "$effect") || return
        row "effects,$effect" 0 "$is" "$none" "$none"
        row "effects,$effect" 1 "$is" "$unused" "$none"
        row "effects,$effect" 2 "$is" "$present" "$none"
        # The same scene by the renderers that scenes share.
        by_every=$(drawing "$effect" "$every") || return
        case "+$materials+" in *"+$effect+"*)
            by_materials=$(drawing "$effect" "$materials") || return
            row "shared,$effect" 0 "$by" "$by_materials" "$present" ;;
        esac
        case $effect in lights | instances)
            by_lit=$(drawing "$effect" "$lit") || return
            row "shared,$effect" 1 "$by" "$by_lit" "$present" ;;
        esac
        row "shared,$effect" 2 "$by" "$by_every" "$present"
    done
    by_materials=$(drawing none "$materials") && by_every=$(drawing none "$every") || return
    row "shared,matte" 0 "$by" "$by_materials" "$none"
    row "shared,matte" 2 "$by" "$by_every" "$none"
    for scene in none mirror+fuzz glass+lens; do
        hand=$(drawing "$scene" hand) && exact=$(drawing "$scene" "$scene") || return
        case $scene in none) name=matte ;; mirror*) name=metal ;; *) name="glass and a lens" ;; esac
        row "by hand,$name" 0 "by hand, by a renderer" "$hand" "$hand"
        row "by hand,$name" 1 "by hand, by a renderer" "$exact" "$hand"
    done
}

if [ "${2:-}" = record ]; then
    measure >"$folder/record" && cp "$folder/record" "$record"
    exit
fi

for scene in none mirror+fuzz glass+lens; do
    [ "$("$program" $scene $scene)" = "$("$program" $scene hand)" ] || {
        echo "$scene: the renderer and the loop by hand draw different pictures"
        exit 1
    }
done
measure >"$folder/record" || exit 1
awk -F, '$1 == "by hand" && $4 == 1 { seen++; print $2 ": " $(NF - 3) " % more instructions than by hand" }
         $1 == "by hand" && $4 == 1 && !($(NF - 3) <= 1) { print "that is more than 1 %"; wrong = 1 }
         END { exit wrong || seen != 3 }' "$folder/record" || exit 1

# Another compiler makes other instructions.
compiler=$("$program" compiler)
if ! grep -qF "compiler,$compiler," "$record"; then
    echo "the record is of $(sed -n 's/^compiler,\([^,]*\),.*/\1/p' "$record"), and this is $compiler: they are not compared"
    exit 0
fi
# The same program always executes the same number of instructions. But what else is compiled beside a renderer changes
# what the compiler inlines: up to 0.3 % were seen.
awk -F, -v noise=0.5 '
    function apart(a, b) { return a > b ? a - b : b - a }
    { key = $1 "," $2 "," $4; percent = $(NF - 3); millions = $(NF - 1) }
    NR == FNR { percents[key] = percent; counts[key] = millions; next }
    !(key in counts) { print key ": not in the record"; wrong = 1; next }
    apart(percent, percents[key]) > noise || apart(millions, counts[key]) * 100 > noise * counts[key] {
        print key ": " counts[key] " million instructions in the record, " percents[key] " % more; actual: " \
              millions ", " percent " % more"
        wrong = 1
    }
    { delete counts[key] }
    END {
        for (key in counts) { print key ": in the record alone"; wrong = 1 }
        if (wrong) print "costs.sh PROGRAM record writes instructions.csv anew"
        exit wrong
    }' "$record" "$folder/record"
