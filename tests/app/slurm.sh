#!/bin/sh
# slurm.sh CLUSTER PROGRAM: Slurm, on this machine alone, runs both jobs of the folder CLUSTER. A rank of the poster is
# killed: the job is started again, and draws the same bytes. Ends with 77 if Slurm is not installed, or without root.
set -u
cluster=$1 program=$2
for tool in munged slurmctld slurmd sbatch; do
    command -v $tool >/dev/null || { echo "$tool is not installed"; exit 77; }
done
[ "$(id -u)" -eq 0 ] || { echo "only root can start Slurm's daemons"; exit 77; }
place=$(mktemp -d)
stop() {
    for daemon in slurmd slurmctld munged; do
        [ ! -s "$place/$daemon.pid" ] || kill "$(cat "$place/$daemon.pid")"
    done
    sleep 1
    rm -rf "$place"
}
trap stop EXIT
cd "$place" || exit 1
failures=0
complain() {
    failures=$((failures + 1))
    echo "$1"
    for log in slurmctld.log slurmd.log ./*-*.log; do [ ! -e "$log" ] || sed "s/^/  $log: /" "$log" | tail -20; done
}

# A cluster of one node, whose daemons have ports, sockets and files of their own.
host=$(hostname -s)
port=$((20000 + $$ % 10000))
mkdir state spool
head -c 1024 /dev/urandom >munge.key
chmod 400 munge.key
munged --force --key-file="$place/munge.key" --socket="$place/munge.socket" --pid-file="$place/munged.pid" \
    --log-file="$place/munged.log" --seed-file="$place/munged.seed" || exit 1
cat >slurm.conf <<END
ClusterName=course
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthInfo=socket=$place/munge.socket,cred_expire=5
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmctldPidFile=$place/slurmctld.pid
SlurmdPidFile=$place/slurmd.pid
SlurmctldLogFile=$place/slurmctld.log
SlurmdLogFile=$place/slurmd.log
StateSaveLocation=$place/state
SlurmdSpoolDir=$place/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
END
export SLURM_CONF="$place/slurm.conf"
slurmctld
slurmd

# await SECONDS CONDITION...: until the condition holds, or so many seconds have passed.
await() {
    left=$(($1 * 10))
    shift
    while ! "$@" >/dev/null 2>&1; do
        left=$((left - 1))
        [ "$left" -gt 0 ] || return 1
        sleep 0.1
    done
}
is_idle() { sinfo -h -o %T | grep -qx idle; }
has_no_job() { [ -z "$(squeue -h 2>&1)" ]; }
await 30 is_idle || complain "Slurm has no node: $(sinfo -h)"

mkdir -p build/bin
ln -s "$program" build/bin/13_cluster_solution
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
options="--width 192 --height 108 --spp 64"
# shellcheck disable=SC2086  # a word an argument
"$program" --quiet $options --out right.png
# shellcheck disable=SC2086
job=$(sbatch --parsable --nodes=1 --ntasks-per-node=2 "$cluster/poster.sbatch" $options --tile 16)
is_half_drawn() { [ "$(stat -c %s cluster-tiles/*.tiles)" -gt 258384 ]; }
if await 60 is_half_drawn; then
    for rank in $(pgrep -f build/bin/13_cluster_solution); do  # also mpirun, and ranks of other tests
        [ "$(readlink "/proc/$rank/cwd")" = "$place" ] || continue
        [ "$(readlink "/proc/$rank/exe")" = "$(readlink -f "$program")" ] || continue
        kill -9 "$rank"
        break
    done
else
    complain "the poster's job draws nothing"
fi
await 120 has_no_job || complain "the poster's job does not end: $(squeue)"
cmp -s right.png poster.png || complain "the poster is another picture"
grep -q 'came from an earlier run' "poster-$job.log" || complain "the poster's job was not started again"

job=$(sbatch --parsable --array=1-2 "$cluster/turntable.sbatch" --width 64 --height 36 --spp 1)
await 60 has_no_job || complain "the turntable's job does not end: $(squeue)"
for frame in 1 2; do
    "$program" --quiet --width 64 --height 36 --spp 1 --frame $frame --frames 120 --out right.png
    cmp -s right.png "frame-00$frame.png" || complain "frame $frame is missing, or another picture"
done
[ "$failures" -eq 0 ]
