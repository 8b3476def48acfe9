#!/bin/sh
# new_exercise.sh COURSE FOLDER: begins an exercise in a copy of the course in this folder, and completes it.
set -eu
course=$1
COURSE_TEST_FOLDER=$(mktemp -d)
export COURSE_TEST_FOLDER
trap 'rm -rf "$COURSE_TEST_FOLDER"' EXIT
cd "$2"
tar --exclude=node_modules -cf - .clang-format book course.json CMakeLists.txt CMakePresets.json chapters cmake common companion docs exercises solutions tests |
    tar -xf - -C "$COURSE_TEST_FOLDER"
cd "$COURSE_TEST_FOLDER"
next=$(($(grep -c '"id": "00\.' course.json) + 1)) # of chapter 00, which is not checked in float
id=00.$next
cmake --preset release >configured || { cat configured; exit 1; }

# says CODE WORDS COMMAND...: it ends with this code and says this.
says() {
    code=$1 words=$2
    shift 2
    actual=0
    "$course" "$@" >said 2>&1 </dev/null || actual=$?
    if [ "$actual" -ne "$code" ] || ! grep -q "$words" said; then
        echo "course $*: expected exit code $code and '$words', actual: exit code $actual and"
        cat said
        exit 1
    fi
}
# edit FILE SED: an edit that must change something.
edit() {
    cp "$1" before
    sed "$2" before >"$1"
    ! cmp -s before "$1" || { echo "$1: '$2' changes nothing"; exit 1; }
}

says 2 'needs --name' dev new "$id"
says 2 "'xor' is a keyword" dev new "$id" --name xor
says 0 'exercises/00_toolchain/rt/absorbed.hpp' dev new "$id" --name absorbed
says 2 "the next exercise of this chapter is 00.$((next + 1))" dev new "$id" --name other
stub=exercises/00_toolchain/rt/absorbed.hpp solution=solutions/00_toolchain/rt/absorbed.hpp
mistakes=tests/mistakes/00_toolchain/$id.md cases=tests/00_toolchain/${id}_absorbed.cpp
# It can be built, and its checkpoint passes and recognizes the stub; what is left is a person's.
says 1 'needs at least three known mistakes, but has 1' dev check "$id"
if grep -qv 'is still UNWRITTEN$\|needs at least three known mistakes, but has 1' said; then
    cat said
    exit 1
fi
says 3 "$id  UNWRITTEN .* to be written" check "$id"

# Somebody writes it.
for file in course.json docs/00-toolchain.md docs/hints/00-toolchain.md $stub $solution "$mistakes" "$cases"; do
    edit "$file" 's/UNWRITTEN/written/'
done
sed -n '/^## /,$p' "$mistakes" >first
for name in twice more; do
    echo
    sed "/^## /s/_.*/_$name/; s/-x/2 * x + ($name)/; s/(twice)/0/; s/(more)/1/" first
done >>"$mistakes"
if ! grep -q '^COURSE_DEAD_ENDS:INTERNAL=$' build/CMakeCache.txt; then
    says 1 "dead_ends: $id: as its stub, .* if no picture needs it" dev check "$id"
    edit tests/dead_ends/unused.json "s/^{/{ \"$id\": \"a number\",/"
fi
says 0 "$id has all of its parts" dev check "$id"

# What breaks it is said.
edit $solution 's/return x/return  x/'
says 1 "^$solution:[0-9]* is not formatted" dev check "$id"
edit $solution 's/return  x/return x/'
edit "$cases" 's/computed == 2/computed == 3/'
says 1 "the solution fails in double: '$id written what holds'" dev check "$id"
edit "$cases" 's/computed == 3/computed == 2/'
edit $stub 's/return rt::todo.*/return x;/'
says 1 'the stub does not say that it is still to be written' dev check "$id"
edit $stub "s/return x;/return rt::todo(\"$id\", x);/"
edit "$mistakes" 's/2 \* x + 0;/0 + x;/'
says 1 "${id}_twice is not caught by" dev check "$id"
edit "$mistakes" 's/return 0 + x;/return 2 + ;/'
says 1 "${id}_twice does not compile" dev check "$id"
