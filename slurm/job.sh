# SPDX-License-Identifier: Apache-2.0
# shellcheck disable=SC2034,SC2154  # shared with the script that sources it
# Functions of the batch scripts; sourced with `here` the folder slurm.
# run_until_complete CAMPAIGN OUT [CASE] is one start of a job: it resumes
# existing histories, drains before the time limit, and requeues the job as long
# as cases remain and starts make progress.
set -uo pipefail
. "$here/settings.sh"

# Longest time that a launcher may outlive its ranks [s], and largest number of
# consecutive starts without a new evaluation.
patience=${IDEOTYPE_PATIENCE:-60}
most_idle_starts=${IDEOTYPE_IDLE_STARTS:-3}

say() {
    echo "$(date -u +%FT%TZ)  job $SLURM_JOB_ID: $*"
}

give_up() {
    say "stops: $*" >&2
    exit 1
}

# The unfinished cases of this job: lines of index and evaluations done.
work_left() {
    "$ideotype" check "$campaign" --left --out "$out" |
        awk -v only="$only_case" 'only == "" || $1 == only'
}

# A job that makes no progress must not be requeued for ever: counts consecutive
# starts that found the same remaining work.
count_idle_starts() {
    local notes=$out/.slurm/$SLURM_JOB_ID idle=0 before=
    [ "${SLURM_RESTART_COUNT:-0}" -gt 0 ] || rm -f "$notes"
    if [ -e "$notes" ]; then
        { read -r idle && before=$(cat); } <"$notes"
        [ "$before" = "$left" ] && idle=$((idle + 1)) || idle=0
    fi
    [ "$idle" -lt "$most_idle_starts" ] ||
        give_up "$idle starts did not complete one evaluation, see above" \
            "and 'ideotype status $out'; submit again when the cause is fixed"
    mkdir -p "$out/.slurm"
    printf '%s\n%s\n' "$idle" "$left" >"$notes"
}

# The ranks of this start on this node, where rank 0 always is.
ranks_here() {
    local process
    for process in $(pgrep -u "$(id -u)" -x "$(basename "$ideotype")"); do
        ! grep -qzsx "IDEOTYPE_START=$IDEOTYPE_START" "/proc/$process/environ" ||
            echo "$process"
    done
}

# Waits for the launcher, which may never end: Open MPI's mpirun
# sometimes hangs after a rank was killed. Sets code; 124 if it had to be killed.
watch_over() {
    local seen=
    while kill -0 "$job" 2>/dev/null; do
        sleep 1 &
        wait $!  # which a signal interrupts
        [ -z "$(ranks_here)" ] || seen=$SECONDS
        if [ -n "$seen" ] && [ $((SECONDS - seen)) -gt "$patience" ]; then
            say "rank 0 is gone, but ${launcher[0]} does not end"
        elif [ -n "$drained" ] && [ $((SECONDS - drained)) -gt "$grace" ]; then
            say "the work in flight did not end within $grace s"
        else
            continue
        fi
        # shellcheck disable=SC2046  # a list
        kill -KILL "$job" $(ranks_here)
        code=124
        return
    done
    wait "$job"
    code=$?
}

# Leaves the remaining work to the next job of a chain, or requeues this job.
requeue() {
    if [ "${IDEOTYPE_LATER_JOBS:-0}" -gt 0 ]; then
        say "$*; the next job of the chain continues"
        exit 0
    fi
    [ -z "${IDEOTYPE_LATER_JOBS:-}" ] ||
        give_up "$*; this was the last job of the chain; submit again to continue"
    say "$*; requeued"
    scontrol requeue "$SLURM_JOB_ID" ||
        give_up "SLURM refused to requeue this job; submit again to continue"
    exit 0
}

run_until_complete() {
    campaign=$1 only_case=${3:-}
    local chosen=${2:-}
    load_site "${IDEOTYPE_SITE:-generic}" && find_program || exit
    out=${chosen:-$out}
    # Time for requeueing remains, since a job beyond its limit cannot be requeued.
    lead=${IDEOTYPE_LEAD:-$lead}
    grace=$((lead > 60 ? lead - 40 : lead / 2))
    drained='' cancelled=''
    left=$(work_left) || give_up "the cases cannot be listed"
    if [ -z "$left" ]; then
        say "all cases are finished"
        exit 0
    fi
    count_idle_starts
    say "start $((${SLURM_RESTART_COUNT:-0} + 1)) on $SLURM_JOB_NODELIST," \
        "cases left: $(wc -l <<<"$left")"

    export IDEOTYPE_START=$SLURM_JOB_ID.$$  # marks the ranks of this start
    "${launcher[@]}" "$ideotype" run "$campaign" --out "$out" --resume \
        ${only_case:+--case "$only_case"} &
    job=$!
    # mpirun and srun pass USR1 on to all ranks.
    trap 'drained=$SECONDS; say "time is up"; kill -USR1 $job' USR1
    trap 'cancelled=yes; kill -USR1 $job' TERM
    watch_over

    left=$(work_left) || give_up "the cases cannot be listed"
    if [ -z "$left" ]; then
        rm -f "$out/.slurm/$SLURM_JOB_ID"
        say "complete"
        exit 0
    fi
    [ -z "$cancelled" ] || give_up "SLURM cancelled it; if SLURM does not" \
        "requeue it, submit again to continue"
    case $code in
    5) requeue "drained" ;;
    # The mpirun of MPICH 4.0 at times ends with 0 after a signal.
    0)
        [ -z "$drained" ] || requeue "drained"
        requeue "other jobs work on the remaining cases"
        ;;
    # The program has reported an error that would occur again.
    1 | 2 | 3 | 4) give_up "the program ended with exit code $code" ;;
    *) requeue "the ranks were lost ($code)" ;;
    esac
}
