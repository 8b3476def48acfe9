#!/bin/sh
# linux_program.sh FILE NAME WORDS...: runs a program of Linux for linux_program.cpp. What it prints goes to FILE, its
# exit code to FILE.code.
said=$1 name=$2
shift 2
slashes() { printf %s "$1" | tr '\134' /; }
for word; do
    shift
    case $word in
    [Zz]:[/\\]*) word=$(slashes "${word#?:}") ;;
    [Cc]:[/\\]*) word=$WINEPREFIX/drive_c$(slashes "${word#?:}") ;;
    -I[Cc]:[/\\]*) word=-I$WINEPREFIX/drive_c$(slashes "${word#-I?:}") ;;
    /* | -I/*) word=$(slashes "$word") ;;
    esac
    set -- "$@" "$word"
done
# Scripts such as build.sh call g++, too, and ask whether this is Windows.
PATH=$(dirname "$0")/mingw:$PATH MSYSTEM=UCRT64 "$name" "$@" >"$said" 2>&1 </dev/null
echo $? >"$said.now"
mv "$said.now" "$said.code"
