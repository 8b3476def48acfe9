#!/bin/sh
# stopped.sh PROGRAM SCENES: a long render that is stopped by a signal leaves a picture of what is done
# and says so; the exit code is 128 and the signal's number.
set -u
program=$1
scene=$2/matte.json
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
failures=0
complain() {
    failures=$((failures + 1))
    echo "$1"
    sed 's/^/  stderr: /' "$place/stderr"
}

# stops SIGNAL CODE WORD
stops() {
    # Far more work than time. Without --foreground, timeout would signal the program twice, and the second
    # signal would end it at once.
    timeout --foreground --preserve-status -s "$1" 2 "$program" "$scene" --spp 20000 --quiet \
        --out "$place/$1.png" >"$place/stdout" 2>"$place/stderr"
    code=$?
    [ "$code" -eq "$2" ] || complain "$1: exit code $code, not $2"
    grep -q "stopped by $3; .*$1.png shows the [0-9]* % that are done" "$place/stderr" ||
        complain "$1: does not say what it did"
    [ "$(wc -l <"$place/stderr")" -eq 1 ] || complain "$1: not one line on stderr"
    head -c 4 "$place/$1.png" | grep -q PNG || complain "$1: no picture"
}
stops INT 130 Ctrl-C
stops TERM 143 SIGTERM
[ -z "$(find "$place" -name '*.part')" ] || complain "temporary files were left"

# An ignored signal stays ignored: a shell's background jobs ignore Ctrl-C.
"$program" "$scene" --width 160 --height 90 --spp 400 --threads 1 --quiet \
    --out "$place/ignored.png" 2>"$place/stderr" &
sleep 1
kill -INT $!
wait $!
code=$?
[ "$code" -eq 0 ] || complain "ignored: exit code $code, not 0"

# Other signals end it at once.
timeout --preserve-status -s HUP 1 "$program" "$scene" --spp 20000 --quiet --out "$place/HUP.png" \
    2>"$place/stderr"
[ ! -e "$place/HUP.png" ] || complain "HUP: a picture was written"

[ "$failures" -eq 0 ]
