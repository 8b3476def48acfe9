# shellcheck shell=sh
# For tests of programs: a folder for files, which goes at the end, and complain WORDS, which counts a failure.
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
failures=0
complain() {
    failures=$((failures + 1))
    echo "$1"
}
