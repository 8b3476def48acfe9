#!/usr/bin/env bash
# The same bytes everywhere: with each configuration, a compiler, a processor and so on, all chapters'
# solutions draw the pictures of tests/app/small_pictures.txt and pass their checkpoints, in both
# precisions.
#
#   check.sh --list                 says which configurations there are, and what is left out
#   check.sh [OPTIONS] all          checks all of them
#   check.sh [OPTIONS] NAME...      checks these, such as clang++-baseline-O0-libc++-x86_64
#
#   --pictures PATTERN              of the chapters that match (grep -E), such as '0[38]'; default: all
#   --checkpoints PATTERN           likewise; '-' for none
#   --learner                       on Windows, leaves out the tests of common/ and the companion, but not a learner there
#   --jobs N                        default: the number of cores
#   --folder FOLDER                 to build in; default: build-platforms
#
# Each configuration has one line of output. Exit code 1 when one failed.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit
pictures=. checkpoints=. learner='' folder=build-platforms
jobs=$(nproc 2>/dev/null || getconf _NPROCESSORS_ONLN)

each_name() {
    local compiler tuning level library processor
    for processor in x86_64 aarch64 windows; do
        for library in libstdc++ libc++; do
            for compiler in g++ clang++; do
                for tuning in native baseline; do
                    for level in O0 O3; do
                        echo "$compiler-$tuning-$level-$library-$processor"
                    done
                done
            done
        done
    done
}

# left_out NAME: says why there is no such configuration; prints nothing if there is one.
left_out() {
    case $1 in
    g++*-libc++-*) echo "g++ comes with libstdc++ alone" ;;
    *-native-*-aarch64) echo "an emulator has no processor of its own" ;;
    *-libc++-aarch64) echo "Debian has no libc++ for cross-compiling" ;;
    clang++-*-windows | *-libc++-windows) echo "what MSYS2 gives a beginner is g++" ;;
    esac
}

# compiles CODE COMPILER...
compiles() {
    local code=$1
    shift
    echo "$code" | "$@" -std=c++20 -x c++ - -o /dev/null 2>/dev/null
}

# missing NAME: says which tool this machine lacks; prints nothing if it has all.
missing() {
    local compiler=${1%%-*}
    case $1 in
    *-aarch64)
        command -v aarch64-linux-gnu-g++ >/dev/null || echo "needs g++-aarch64-linux-gnu"
        command -v "$emulator" >/dev/null || echo "needs qemu-user" ;;
    esac
    case $1 in
    *-windows)
        command -v x86_64-w64-mingw32-g++-posix >/dev/null || echo "needs g++-mingw-w64-x86-64-posix"
        [ -x /usr/lib/wine/wine64 ] || command -v wine >/dev/null || echo "needs wine64"
        command -v ld.lld >/dev/null || echo "needs lld"
        return ;;
    esac
    command -v "$compiler" >/dev/null || echo "needs $compiler"
    case $1 in
    *-libc++-*)
        compiles $'#include <vector>\nint main() {}' "$compiler" -stdlib=libc++ ||
            echo "needs libc++-dev and libc++abi-dev" ;;
    *-x86_64) [ "$(uname -m)" = x86_64 ] || echo "needs another processor" ;;
    esac
}

# configure NAME BUILD
configure() {
    local compiler=${1%%-*} source=. level flags=() native=ON
    level=$(echo "$1" | grep -o -- '-O[0-9]')
    case $1 in *-baseline-*) native=OFF ;; esac
    case $1 in
    *-libc++-*)
        # The system's TBB is built for libstdc++.
        flags+=(-DCMAKE_CXX_FLAGS=-stdlib=libc++ -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON) ;;
    *-aarch64)
        # The emulator finds the other system's libraries where the cross compiler has them.
        flags+=(-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64
                "-DCMAKE_CROSSCOMPILING_EMULATOR=$(command -v "$emulator");-L;/usr/aarch64-linux-gnu"
                -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON -DCMAKE_DISABLE_FIND_PACKAGE_OpenMP=ON)
        if [ "$compiler" = g++ ]; then
            compiler=aarch64-linux-gnu-g++
        else
            flags+=(-DCMAKE_CXX_COMPILER_TARGET=aarch64-linux-gnu)
        fi ;;
    *-windows)
        tests/platforms/wine.sh --boot || return
        compiler=x86_64-w64-mingw32-g++-posix
        source=${2%/build}  # a learner writes in it
        mkdir -p "$source" && find "$source" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} + &&
            git ls-files -z | xargs -0 cp -p --parents -t "$source" || return
        flags+=("-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/mingw.cmake") ;;
    esac
    cmake -S "$source" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
        -DRT_OPTIMIZE="$level" -DRT_NATIVE=$native -DRT_WERROR=ON \
        -DCOURSE_ALL_TESTS=ON "${flags[@]}"
}

# folder_of NAME: to build in. On Windows it is in the course's folder, as a learner has it, and its name is not plain.
folder_of() {
    case $1 in
    *-windows) echo "$folder/Zoë Müller/course/build" ;;
    *) echo "$folder/$1" ;;
    esac
}

# check NAME BUILD
check() {
    local targets=() drawn='' checked='' more='' chapter
    for chapter in solutions/*; do
        chapter=${chapter#solutions/}
        # MPI is this system's alone; the tracer has a program for each chapter, which graft_mistakes tries.
        case $1:$chapter in *-aarch64:13_* | *-windows:13_* | *:tracer) continue ;; esac
        if echo "$chapter" | grep -qE -- "$pictures"; then
            targets+=("${chapter}_solution")
            [ "$chapter" = 09_own ] || targets+=("${chapter}_solution_float")
            drawn+="|$chapter"
        fi
        if [ "$chapter" != 09_own ] && echo "$chapter" | grep -qE -- "$checkpoints"; then
            targets+=("${chapter}_checkpoint_solution")
            checked+="|${chapter%%_*}"
        fi
    done
    case $1 in
    *-windows)
        targets+=(course linux_program own_start)
        if [ -z "$learner" ]; then
            targets+=(common_test_double common_test_float companion_test)
            more='|^common_|^companion[.]'
        fi ;;
    esac
    configure "$1" "$2" && cmake --build "$2" -j "$jobs" --target "${targets[@]}" || return
    if [ -f "$2/bin/linux_program.exe" ]; then
        python3 tests/platforms/stand_ins.py "$2" || return
        local -x WINEPATH
        WINEPATH=Z:$(realpath "$2")/tools
    fi
    local result=0
    ctest --test-dir "$2" -j "$jobs" --no-tests=error --output-on-failure -E "$(excluded "$1")" \
        -R "^(-$drawn)\.small_picture(_in_float)?$|^checkpoint\.(-$checked)\.$more" || result=1
    # A learner's day does not depend on these tests.
    case $1 in *-windows) python3 tests/platforms/windows_learner.py "${2%/build}" || result=1 ;; esac
    return "$result"
}

# excluded NAME: tests that tell nothing there.
excluded() {
    case $1 in
    *-aarch64)
        # 00.1 starts a program of its own, which knows nothing of the emulator.
        echo '^checkpoint\.00\.1$' ;;
    *-windows)
        # A terminal of Linux; a compiler of Linux, which names files otherwise; the processor time of a program that
        # has ended, of which wine tells less than there was.
        echo '^companion[.](commands|build|test_results)$' ;;
    *) echo '^$' ;;
    esac
}

emulator=qemu-aarch64
command -v $emulator >/dev/null || emulator=qemu-aarch64-static
names=()
while [ $# -gt 0 ]; do
    case $1 in
    --list)
        for name in $(each_name); do
            reason=$(left_out "$name")
            [ -n "$reason" ] && reason="left out: $reason" || reason=$(missing "$name" | head -n 1)
            printf '%-40s %s\n' "$name" "$reason"
        done
        exit ;;
    --pictures) pictures=$2 && shift ;;
    --checkpoints) checkpoints=$2 && shift ;;
    --learner) learner=only ;;
    --jobs) jobs=$2 && shift ;;
    --folder) folder=$2 && shift ;;
    all) for name in $(each_name); do [ -n "$(left_out "$name")" ] || names+=("$name"); done ;;
    *)
        if ! each_name | grep -xF -- "$1" >/dev/null || [ -n "$(left_out "$1")" ]; then
            echo "check.sh: no configuration '$1': see check.sh --list" >&2
            exit 2
        fi
        names+=("$1") ;;
    esac
    shift
done
[ ${#names[@]} -gt 0 ] || { sed -n '2,/^set/{/^#/s/^# \{0,1\}//p;}' "${BASH_SOURCE[0]}" && exit 2; }

failed=0
TIMEFORMAT='%R s, of which the processors worked %U + %S s'
for name in "${names[@]}"; do
    reason=$(missing "$name" | head -n 1)
    if [ -n "$reason" ]; then
        echo "skipped $name: $reason"
        continue
    fi
    log=$(mktemp)
    if took=$({ time check "$name" "$(folder_of "$name")" >"$log" 2>&1; } 2>&1); then
        echo "ok      $name: $(sed -n 's/.*tests failed out of //p' "$log") tests, $took"
    else
        echo "FAILED  $name: $took"
        tail -n 60 "$log" | sed 's/^/    /'
        failed=1
    fi
    rm -f "$log"
    case $name in *-windows) tests/platforms/wine.sh --end ;; esac
done
exit $failed
