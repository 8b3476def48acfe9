#!/bin/sh
# jobs.sh CLUSTER: the jobs in the folder CLUSTER, without a cluster: mpirun, scontrol and the program are stand-ins. A
# job is started again only if that may help, and three times at most.
set -u
cluster=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place" || exit 1
failures=0
complain() {
    failures=$((failures + 1))
    echo "$1"
}
mkdir -p bin
PATH=$place/bin:$PATH
export SLURM_JOB_ID=7 SLURM_ARRAY_TASK_ID=7 SLURM_RESTART_COUNT MPIRUN_ENDS
stand_in() { # FILE SCRIPT
    printf '#!/bin/sh\n%s\n' "$2" >"$1"
    chmod +x "$1"
}
# shellcheck disable=SC2016  # the stand-in expands it
stand_in bin/scontrol 'echo "$*" >>requeued'
# shellcheck disable=SC2016
stand_in bin/mpirun 'echo "$*" >>begun; [ "$MPIRUN_ENDS" = never ] || exit "$MPIRUN_ENDS"; exec sleep 60'

# expect CODE BEGUN REQUEUED: how the latest job ended, and how often mpirun and scontrol were called.
expect() {
    begun=$(grep -c "" begun 2>/dev/null) requeued=$(grep -cx 'requeue 7' requeued 2>/dev/null)
    [ "$code ${begun:-0} ${requeued:-0}" = "$1 $2 $3" ] ||
        complain "restart $SLURM_RESTART_COUNT, mpirun $MPIRUN_ENDS: expected $1 $2 $3, actual $code ${begun:-0} ${requeued:-0}"
    rm -f begun requeued
}
poster() {
    sh "$cluster/poster.sbatch" scene.json 2>errors
    code=$?
}
SLURM_RESTART_COUNT=0 MPIRUN_ENDS=0
poster; expect 127 0 0
sh "$cluster/turntable.sbatch" 2>errors; code=$?; expect 127 0 0
grep -q 'is missing' errors || complain "nothing is said of the missing program"

mkdir -p build/bin
# shellcheck disable=SC2016
stand_in build/bin/13_cluster_solution 'echo "$*" >drawn'
sh "$cluster/turntable.sbatch" scene.json
grep -qx 'scene.json --frame 7 --frames 120 --out frame-007.png' drawn || complain "the turntable draws $(cat drawn)"
for SLURM_RESTART_COUNT in 0 1 2 3; do
    for MPIRUN_ENDS in 0 1 2 3 126 127; do poster; expect "$MPIRUN_ENDS" 1 0; done
    for MPIRUN_ENDS in 132 137 205; do poster; expect "$MPIRUN_ENDS" 1 $((SLURM_RESTART_COUNT < 3)); done
done
SLURM_RESTART_COUNT=4; poster; expect 1 0 0

# The time limit is near.
MPIRUN_ENDS=never
for SLURM_RESTART_COUNT in 0 3; do
    sh "$cluster/poster.sbatch" &
    until [ -e begun ]; do sleep 0.05; done
    kill -USR1 $!
    wait $!
    code=$?; expect 1 1 $((SLURM_RESTART_COUNT < 3))
done
[ "$failures" -eq 0 ]
