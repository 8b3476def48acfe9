# shellcheck shell=sh disable=SC2154
# Sourced by the tests of a group of ranks, after they have set mpiexec and program. In it:
#   ranks N THREADS ARGUMENTS...: runs $program on N ranks of this machine.

place=$(mktemp -d)
trap 'umount "$place/cluster-tiles" 2>/dev/null; rm -rf "$place"' EXIT
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl_vader_single_copy_mechanism=none
failures=0
complain() {
    failures=$((failures + 1))
    echo "$1"
    sed 's/^/  stderr: /' "$place/stderr"
}
ranks() {
    count=$1 threads=$2
    shift 2
    timeout 60 "$mpiexec" -n "$count" "$program" --quiet --threads "$threads" "$@" >"$place/stdout" 2>"$place/stderr"
}
# expect CODE WORDS: how the latest run ended: with this code, and one line of its own, which has these words.
expect() {
    grep '13_cluster: ' "$place/stderr" >"$place/said"
    [ "$code" -eq "$1" ] || complain "expected exit code $1, actual $code"
    [ "$(wc -l <"$place/said")" -eq 1 ] || complain "expected one line, actual $(wc -l <"$place/said")"
    grep -q -- "$2" "$place/said" || complain "expected the words '$2'"
}
