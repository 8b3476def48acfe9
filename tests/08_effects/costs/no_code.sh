#!/bin/sh
# no_code.sh OBJECT: of without_haze in haze.cpp nothing is left but "ret", perhaps after "endbr64".
left=$(objdump -d --no-show-raw-insn "$1" | sed -n '/<.*without_haze.*>:$/,/^$/s/^ .*:[[:space:]]*\([a-z0-9]*\).*/\1/p' |
       grep -v '^endbr64$')
[ "$left" = ret ] || {
    echo "without haze, expected: ret, actual:"
    echo "$left"
    exit 1
}
