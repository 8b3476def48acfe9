#!/bin/sh
# share.sh MPIEXEC COUNT PROGRAM ARGUMENT: cluster_share_test finds nothing wrong on so many ranks.
set -u
mpiexec=$1 count=$2 program=$3
# shellcheck source=tests/app/group.sh
. "$(dirname "$0")/group.sh"
timeout 60 "$mpiexec" -n "$count" "$program" "$4"
