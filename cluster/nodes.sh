#!/bin/sh
# A cluster of two nodes, a and b, in containers: nodes.sh start makes them, nodes.sh run COMMAND runs a command on
# node a, nodes.sh stop removes them. Both see the course's folder, as machines of a cluster see a shared disk.
set -eu
cd "$(dirname "$0")/.."
engine=podman
command -v podman >/dev/null || engine=docker
remove() {
    for node in a b; do "$engine" rm -f "course-$node" || true; done
    "$engine" network rm course-cluster || true
}
case ${1-} in
start)
    remove >/dev/null 2>&1
    "$engine" build -t course-node -f cluster/Containerfile cluster
    "$engine" network create course-cluster
    for node in a b; do
        "$engine" run -d --name "course-$node" --hostname "$node" --network course-cluster --network-alias "$node" \
            -v "$PWD:$PWD" -w "$PWD" course-node
    done
    ;;
run)
    shift
    terminal=
    if [ -t 0 ] && [ -t 1 ]; then terminal=-t; fi
    # shellcheck disable=SC2086  # no word if there is no terminal
    exec "$engine" exec -i $terminal course-a "$@"
    ;;
stop) remove >/dev/null 2>&1 ;;
*)
    echo "nodes.sh: start, run COMMAND or stop" >&2
    exit 2
    ;;
esac
