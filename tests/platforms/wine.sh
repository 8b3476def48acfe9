#!/bin/sh
# wine.sh PROGRAM...: runs a program for Windows, with the compiler's libraries. With --boot instead, it makes what
# wine needs before the first program, and says in which folder drive C: is. After it, wine's server stays until
# --end: a server that ends when no program runs can reset the connection of the next one.
set -eu
# Names have letters beyond ASCII.
export LC_ALL=C.UTF-8
export WINEDEBUG="${WINEDEBUG:--all}" WINEDLLOVERRIDES='mscoree,mshtml='
export WINEPREFIX="${WINEPREFIX:-${XDG_CACHE_HOME:-$HOME/.cache}/course-wine}"
wine=$(command -v wine64 || command -v wine || echo /usr/lib/wine/wine64)
server=$(command -v wineserver64 || command -v wineserver || echo /usr/lib/wine/wineserver64)
if [ "$1" = --end ]; then
    exec "$server" --kill
fi
if [ "$1" = --boot ]; then
    mkdir -p "$WINEPREFIX"
    "$server" --kill || true
    # These stay, so they must not hold on to the output of this script.
    "$server" --persistent >/dev/null 2>&1
    "$wine" wineboot --init >/dev/null 2>&1
    echo "$WINEPREFIX/drive_c"
    exit
fi
# A checkpoint finds the answer by PATH; see course_with_answers in cmake/Checkpoints.cmake.
WINEPATH="${COURSE_ANSWER:+Z:$COURSE_ANSWER};${WINEPATH:-}"
for library in libstdc++-6.dll libwinpthread-1.dll; do
    file=$(x86_64-w64-mingw32-g++-posix -print-file-name=$library)
    WINEPATH="$WINEPATH;Z:$(realpath "$(dirname "$file")")"
done
export WINEPATH
exec "$wine" "$@"
