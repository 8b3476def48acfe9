#!/bin/sh
# stopped.sh PROGRAM SCENES OPTION...: a long render with these options that is stopped by a signal leaves a picture of
# what is done and says so; the exit code is 128 and the signal's number.
set -u
program=$1
scene=$2/matte.json
shift 2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
failures=0
complain() {
    failures=$((failures + 1))
    echo "$1"
    sed 's/^/  stderr: /' "$place/stderr"
}

# stops SIGNAL CODE WORD OPTIONS...
stops() {
    signal=$1 expected=$2 word=$3
    shift 3
    start=$(date +%s)
    # Far more work than time. Without --foreground, timeout would signal the program twice, and the second
    # signal would end it at once.
    timeout --foreground --preserve-status -s "$signal" 2 "$program" "$scene" "$@" --quiet \
        --out "$place/stopped.png" >"$place/stdout" 2>"$place/stderr"
    code=$?
    [ $(($(date +%s) - start)) -lt 30 ] || complain "$signal, $*: ends late"
    [ "$code" -eq "$expected" ] || complain "$signal, $*: exit code $code, not $expected"
    grep -q "stopped by $word; .*stopped.png shows the [0-9]* % that are done" "$place/stderr" ||
        complain "$signal, $*: does not say what it did"
    [ "$(wc -l <"$place/stderr")" -eq 1 ] || complain "$signal, $*: not one line on stderr"
    head -c 4 "$place/stopped.png" | grep -q PNG || complain "$signal, $*: no picture"
    rm -f "$place/stopped.png"
}
stops INT 130 Ctrl-C "$@"
stops TERM 143 SIGTERM "$@"
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
timeout --preserve-status -s HUP 1 "$program" "$scene" "$@" --quiet --out "$place/HUP.png" \
    2>"$place/stderr"
[ ! -e "$place/HUP.png" ] || complain "HUP: a picture was written"

[ "$failures" -eq 0 ]
