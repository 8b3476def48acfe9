#!/bin/sh
# build_for_debugger.sh exercises/NN_topic/...: builds the checkpoints of that chapter with your code for the
# debugger, and puts them where launch.json looks: build-debugger/open_chapter. They run all exercises of the
# chapter, and stop where you have set a breakpoint.
set -eu
cd "$(dirname "$0")/.."
chapter=${1#exercises/}
chapter=${chapter%%/*}
if [ ! -d "exercises/$chapter" ]; then
    echo "This is no file of an exercise: $1. Open one in exercises/ first." >&2
    exit 2
fi
# As the checkpoints are always built, most of them without optimization, so that every variable is seen.
cmake --preset release -B build-debugger "-DCMAKE_CXX_FLAGS=-g -D_GLIBCXX_ASSERTIONS"
cmake --build build-debugger --target "${chapter}_checkpoint"
ln -sfn "bin/${chapter}_checkpoint" build-debugger/open_chapter
