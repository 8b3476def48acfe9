#!/bin/sh
# build_for_debugger.sh exercises/NN_topic/...: builds the checkpoints of that chapter with your code, and
# assertions and sanitizers, and puts them where launch.json looks: build-debug/open_chapter. They run all
# exercises of the chapter, and stop where you have set a breakpoint.
set -eu
cd "$(dirname "$0")/.."
chapter=${1#exercises/}
chapter=${chapter%%/*}
if [ ! -d "exercises/$chapter" ]; then
    echo "This is no file of an exercise: $1. Open one in exercises/ first." >&2
    exit 2
fi
cmake --preset debug
cmake --build build-debug --target "${chapter}_checkpoint"
ln -sfn "bin/${chapter}_checkpoint" build-debug/open_chapter
