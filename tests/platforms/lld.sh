#!/bin/sh
# lld.sh COMMAND ARGUMENTS...: for g++ -wrapper. It calls lld in place of the usual linker, which for Windows takes a
# hundred times as long.
case $1 in
*/collect2) shift && exec ld.lld "$@" ;;
*) exec "$@" ;;
esac
