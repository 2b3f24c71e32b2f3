# SPDX-License-Identifier: Apache-2.0
# shellcheck disable=SC2034,SC2154  # its variables are those of what sources it
# A real SLURM on this machine, in one folder and on local ports: source it,
# then start_cluster FOLDER NODES, and stop_cluster at the end. Needs
# slurmctld, slurmd, slurm-client and munge; leaves nothing outside FOLDER.

start_cluster() {
    cluster=$(mkdir -p "$1" && cd "$1" && pwd)
    local nodes=$2 port host node
    # The ports are below those that the kernel assigns, and differ from those
    # of another cluster started at the same time.
    port=$((20000 + $$ % 1500 * 8))
    host=$(hostname -s)
    mkdir -p "$cluster"/{state,log,run/tmp}
    for node in $(seq "$nodes"); do
        mkdir -p "$cluster/run/slurmd.node$node" "$cluster/run/tmp.node$node"
    done
    chmod 700 "$cluster/log"
    chmod 755 "$cluster/run"
    (umask 077 && head -c 128 /dev/urandom >"$cluster/munge.key")
    cat >"$cluster/slurm.conf" <<CONF
ClusterName=ci
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=$(id -un)
AuthInfo=socket=$cluster/run/munge.socket,cred_expire=5
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/run/slurmd.%n
SlurmctldPidFile=$cluster/run/slurmctld.pid
SlurmdPidFile=$cluster/run/slurmd.%n.pid
SlurmctldLogFile=$cluster/log/slurmctld.log
SlurmdLogFile=$cluster/log/slurmd.%n.log
TmpFS=$cluster/run/tmp.%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,bf_interval=1
JobCompType=jobcomp/filetxt
JobCompLoc=$cluster/log/jobcomp.txt
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=30
KillWait=5
NodeName=node[1-$nodes] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + nodes))] CPUs=4 State=UNKNOWN
PartitionName=debug Nodes=ALL Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:4
CONF
    # Without control groups, SLURM of Debian 12 works by default; later
    # versions need a setting.
    case $(slurmd -V) in
    *" 22."*) ;;
    *) echo "CgroupPlugin=disabled" >"$cluster/cgroup.conf" ;;
    esac
    export SLURM_CONF=$cluster/slurm.conf
    # --force is needed because root's own folder may not be entered by others.
    munged --force --key-file="$cluster/munge.key" \
        --socket="$cluster/run/munge.socket" \
        --pid-file="$cluster/run/munged.pid" \
        --log-file="$cluster/log/munged.log" \
        --seed-file="$cluster/munge.seed"
    slurmctld
    for node in $(seq "$nodes"); do slurmd -N "node$node"; done
    for _ in $(seq 100); do
        [ "$(sinfo -h -o %D -t idle 2>/dev/null || true)" = "$nodes" ] &&
            return
        sleep 0.2
    done
    cat "$cluster"/log/*.log >&2
    echo "the cluster did not start" >&2
    return 1
}

stop_cluster() {
    local file
    scancel --user="$(id -un)" 2>/dev/null || true
    wait_for_jobs 15 2>/dev/null || true
    for file in "$cluster"/run/*.pid; do
        [ ! -e "$file" ] || kill "$(cat "$file")" 2>/dev/null || true
    done
}

# Waits until no job is left, for at most $1 seconds.
wait_for_jobs() {
    local end=$((SECONDS + $1))
    while [ -n "$(squeue -h)" ]; do
        if [ $SECONDS -gt $end ]; then
            squeue >&2
            return 1
        fi
        sleep 0.5
    done
}

# Writes what a site's file would say: $1 a name, the rest the launcher. Nodes
# that share one machine cannot share memory by node, and reach each other by
# the loopback interface, whatever networks there are.
write_site() {
    cat >"$1.sh" <<SITE
sbatch_options=(--ntasks=3 --time=10)
launcher=(${*:2})
export OMPI_MCA_btl=tcp,self OMPI_MCA_btl_tcp_if_include=lo
SITE
}

# Prints the option with which srun starts ranks of the MPI library of this
# build.
srun_of_mpi() {
    if is_mpich; then
        echo srun --mpi=pmi2
    else
        echo srun --mpi=pmix
    fi
}

# Submits jobs and stores the output; sets job to the first job of the chain. $1
# a name for the log.
submit() {
    "$project/slurm/submit" "${@:2}" >"submit-$1.log" 2>&1 ||
        fail "submit: $(cat "submit-$1.log")"
    job=$(job_of "$1" 1)
}

# Prints job $2, from 1, of the chain that was submitted as $1. Its numbers need
# not be consecutive, because SLURM also numbers tasks of arrays.
job_of() {
    sed -n 's/^job  *\([^;]*\);.*/\1/p' "submit-$1.log" | cut -d ' ' -f "$2"
}

# Waits until the file $1 exists.
wait_for_file() {
    for _ in $(seq 300); do
        [ ! -e "$1" ] || return 0
        sleep 0.1
    done
    squeue >&2
    tail -n 20 ideotype-*.log >&2 || true
    fail "there is no $1"
}

# Prints the process of rank 1 of job $1. Other clusters on this machine may use
# the same job numbers.
worker_of() {
    local process environment
    for process in $(pgrep -x ideotype); do
        environment=$(tr '\0' '\n' 2>/dev/null <"/proc/$process/environ" || true)
        if grep -qx "SLURM_JOB_ID=$1" <<<"$environment" &&
            grep -qx "SLURM_CONF=$SLURM_CONF" <<<"$environment" &&
            grep -qx "\(OMPI_COMM_WORLD_RANK\|PMI_RANK\|SLURM_PROCID\)=1" \
                <<<"$environment"; then
            echo "$process"
            return
        fi
    done
    fail "job $1 has no worker"
}

# Prints all information of the controller about the jobs, for the log of a
# failed test.
show_jobs() {
    echo "--- $(basename "$0" .sh): sacct -c"
    sacct -c --format=JobID,JobName%18,NodeList,State,Start,End 2>/dev/null
    grep -hiE "requeu|time limit|signal=10|nodes? .*down" \
        "$cluster/log/slurmctld.log" | cut -c 1-150 || true
    echo "--- what the jobs said"
    grep -h " job [0-9]*: " ideotype-*.log | sort -s -k 1,2
}
