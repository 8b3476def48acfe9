#!/bin/sh
# by_hand.sh ROOT: runs the commands of chapter 00's text, those in blocks of ```console, in a copy of its
# files, and checks that each prints the lines that the text shows. Numbers may differ from machine to
# machine, and … stands for anything.
set -u
text=$1/docs/00-toolchain.md
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
export LC_ALL=C

# What the text shows is g++ on a PC with Linux. ctest counts 77 as skipped.
for tool in g++ nm; do command -v $tool >/dev/null || exit 77; done
[ "$(uname -sm)" = 'Linux x86_64' ] || exit 77
g++ --version | grep -q 'Free Software Foundation' || exit 77
echo 'int main() {}' | g++ -std=c++20 -fsyntax-only -x c++ - 2>/dev/null || exit 77

# As the course's folder, which the text starts from.
mkdir -p "$place/course/chapters/00_toolchain"
cp -r "$1/chapters/00_toolchain/by_hand" "$place/course/chapters/00_toolchain/"
cd "$place/course" || exit 1

failures=0
commands=0
command=''
# expect LINE: the last command must have printed such a line.
expect() {
    pattern=$(printf '%s\n' "$1" | sed 's/[][\.*^$]/\\&/g; s/^[0-9a-f]\{16\} /@address@/; s/0x[0-9a-f][0-9a-f]*/@hex@/g
        s/[0-9][0-9]*/[0-9][0-9]*/g; s/@hex@/0x[0-9a-f]*/g; s/@address@/[0-9a-f]* /; s/…/.*/g')
    grep -qx -- "$pattern" "$place/output" && return
    failures=$((failures + 1))
    printf '$ %s\n  does not print: %s\n  but:\n' "$command" "$1"
    sed 's/^/    /' "$place/output"
}

inside=''
while IFS= read -r line; do
    case $line in
        '```console') inside=yes ;;
        '```') inside='' ;;
        '$ '*)
            [ -n "$inside" ] || continue
            command=${line#??}
            commands=$((commands + 1))
            # Not in a shell of its own, because cd must last.
            eval "$command" >"$place/output" 2>&1 </dev/null
            ;;
        *)
            [ -z "$inside" ] || expect "$line"
            ;;
    esac
done <"$text"

echo "$commands commands, $failures lines that are not as in the text"
[ "$commands" -gt 10 ] && [ "$failures" -eq 0 ]
