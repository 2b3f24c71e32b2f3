#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Kills runs at random times, examines the histories, resumes, and compares with
# an uninterrupted run bit for bit: see README.md.
# kill.sh IDEOTYPE [KILLS] [SEED] [day|season|growth|soil|threads] [KEY=VALUE...]
ideotype=$(readlink -f "$1")
kills=${2:-100}
seed=${3:-1}
light=${4:-day}
command=run
[ "$light" != study ] || command=sensitivity
settings=()
for setting in "${@:5}"; do settings+=(--set "$setting"); done
here=$(readlink -f "$(dirname "$0")")
project=$(readlink -f "$here/../..")
work=$(mktemp -d)
set -- "$ideotype" "$project" "$work/test"
. "$project/tests/cli/common.sh"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    OMPI_MCA_rmaps_base_oversubscribe=1

generations=$((kills > 20 ? 1200 : 200))
population=12
RANDOM=$seed
job=
ranks=()

stop_all() {
    for process in $job "${ranks[@]}"; do
        kill -KILL "$process" 2>/dev/null || true
    done
    cd /
    rm -rf "$work"
}
trap stop_all EXIT

# A Python that can read histories; empty if there is none.
python=
for candidate in "${PYTHON:-}" "$project/.venv/bin/python" python3; do
    if [ -n "$candidate" ] &&
        "$candidate" -c "import h5py" >/dev/null 2>&1; then
        python=$candidate
        break
    fi
done
[ -n "$python" ] ||
    echo "NO PYTHON WITH h5py: FILES ARE READ BY ideotype status ALONE" >&2

# Starts a run on any number of ranks or threads; sets job, log and width.
start() {
    log=run.$1.log
    width=$((1 + RANDOM % 4))
    local how=(mpirun -n "$width" "$ideotype" "$command")
    [ "$light" != threads ] || how=("$ideotype" run --threads "$width")
    "${how[@]}" campaigns/stress.toml "${settings[@]}" --resume \
        --out "round$round" >"$log" 2>&1 &
    job=$!
    disown $job  # no word of the shell about its end
    ranks=()
}

is_alive() {
    grep -qs "^State:[[:space:]]*[^ZX[:space:]]" "/proc/$1/status"
}

# Returns whether process $1 ends within $2 seconds.
goes() {
    for _ in $(seq $((20 * $2))); do
        is_alive "$1" || return 0
        sleep 0.05
    done
    return 1
}

# Waits for the end of a run, whatever the order in which its processes end.
wait_for_end() {
    local process
    for process in "${ranks[@]}"; do
        goes "$process" 30 ||
            fail "rank $process is there 30 s after the kill of $target"
    done
    # Open MPI 4.1's mpirun sometimes waits for ever (in a futex) after it has
    # reported a killed rank and all ranks are gone.
    if ! goes "$job" 10; then
        [ "$light" != threads ] || fail "$job is there 10 s after the kill"
        stuck=$((stuck + 1))
        kill -KILL "$job"
        goes "$job" 10 || fail "mpirun $job does not go"
    fi
}

committed() {
    [ -e "$1" ] || { echo 0; return; }
    "$ideotype" status "$1" | sed -n 's/.*, \([0-9]*\) of [0-9]* plants in .*/\1/p'
}

# Counts the errors in the file of a killed run.
look() {
    local text reported
    [ -e "$history" ] || return 0
    looks=$((looks + 1))
    if ! text=$("$ideotype" status "$history" 2>&1); then
        echo "unreadable: $text" >&2
        unreadable=$((unreadable + 1))
        return
    fi
    reported=$(sed -n "s/.*  generation [0-9]*, \([0-9]*\) of [0-9]* plants.*/\1/p" "$log" | tail -1)
    if [ "$(committed "$history")" -lt "${reported:-0}" ]; then
        echo "lost: the log had $reported plants; $text" >&2
        lost=$((lost + 1))
    fi
    [ -n "$python" ] || return 0
    local code=0
    PYTHONPATH=$project/analysis/src "$python" "$here/look.py" "$whole" \
        "$history" "${reported:-0}" || code=$?
    case $code in
    0) ;;
    3) different=$((different + 1)) ;;
    4) lost=$((lost + 1)) ;;
    *) unreadable=$((unreadable + 1)) ;;
    esac
}

finished() {
    [ -e "$history" ] && "$ideotype" status "$history" | grep -q ": finished"
}

# A complete round is compared with the uninterrupted run; the next round begins
# with a new file.
end_round() {
    (same_results "$whole" "$history") >&2 || different=$((different + 1))
    rounds=$((rounds + 1))
    rm -rf "round$round"
    round=$((round + 1))
    history=$(history_of "round$round" stress $name)
}

name=0807
lag=400
is_season=
[[ ! $light =~ ^(season|growth|soil)$ ]] || is_season=1
[ -z "$is_season" ] || generations=$((generations / 4))
[ "$light" != soil ] || generations=$((generations / 3))
write_campaign stress $population "$generations"
if [ -n "$is_season" ]; then
    "give_$light" stress
    yield=carbon_balance
    [ "$light" != soil ] || yield=grain_yield
    printf '[objective]\nmaximise = "%s"\n' $yield >>campaigns/stress.toml
    name=july
    lag=1000  # before this the weather is read
fi
"$ideotype" "$command" campaigns/stress.toml "${settings[@]}" --out whole >/dev/null
whole=$(history_of whole stress $name)
round=0
history=$(history_of round0 stress $name)
targets=(rank0 worker mpirun all term stop)
[ "$light" != threads ] || targets=(all term stop)
declare -A hits=([rank0]=0 [worker]=0 [mpirun]=0 [all]=0 [term]=0 [stop]=0)
declare -A places=([start]=0 [resume]=0 [generations]=0 [finals]=0)
done_kills=0 looks=0 lost=0 unreadable=0 different=0 rounds=0 missed=0
stuck=0 failed=0 changes=0 last_width=3

while [ $done_kills -lt "$kills" ]; do
    before=$(committed "$history")
    target=${targets[RANDOM % ${#targets[@]}]}
    # Delay [ms]; in one of three rounds, the kill occurs while the ranks start
    # and open the file.
    delay=$((RANDOM % 3 == 0 ? 150 + RANDOM % 350 : lag + RANDOM % 1000))
    start $done_kills
    [ $width -eq $last_width ] || changes=$((changes + 1))
    last_width=$width
    [ $width -gt 1 ] || [ "$target" != worker ] || target=rank0
    sleep "$(printf '%d.%03d' $((delay / 1000)) $((delay % 1000)))"
    mapfile -t ranks < <(descendants_of $job)
    case $target in
    rank0) victims=$(rank_of $job 0) ;;
    worker) victims=$(rank_of $job $((1 + RANDOM % (width - 1)))) ;;
    mpirun) victims=$job ;;
    *) victims="$job ${ranks[*]}" ;;
    esac
    # A drain under way, and ranks that have stood still.
    # shellcheck disable=SC2086  # a list
    case $target in
    term) kill -TERM $victims 2>/dev/null || true ;;
    stop) kill -STOP $victims 2>/dev/null || true ;;
    esac
    [[ $target != term && $target != stop ]] ||
        sleep "0.$(printf '%03d' $((RANDOM % 300)))"
    # shellcheck disable=SC2086  # a list
    if [ -z "$victims" ] || ! kill -KILL $victims 2>/dev/null; then
        missed=$((missed + 1))
        [ $missed -le $((2 * kills + 40)) ] || fail "runs end before the kills"
        wait_for_end
    else
        wait_for_end
        after=$(committed "$history")
        if [ ! -e "$history" ]; then
            place=start
        elif [ "$after" -eq $((generations * population)) ]; then
            place=finals
        elif [ "$after" -eq "$before" ]; then
            place=resume
        else
            place=generations
        fi
        places[$place]=$((places[$place] + 1))
        hits[$target]=$((hits[$target] + 1))
        done_kills=$((done_kills + 1))
        if sed '/  ideotype: warning: /d' "$log" | grep "  ideotype: " >&2; then
            failed=$((failed + 1))
        fi
        look
    fi
    if finished; then end_round; fi
    rm -f "$log"
done
if ! finished; then
    mpirun -n 3 "$ideotype" "$command" campaigns/stress.toml "${settings[@]}" --resume \
        --out "round$round" >last.log 2>&1 ||
        fail "the last resume failed: $(cat last.log)"
fi
end_round

echo "kills: $done_kills (rank 0 ${hits[rank0]}, a worker ${hits[worker]}," \
    "mpirun ${hits[mpirun]}, all ${hits[all]}, all while they drain" \
    "${hits[term]}, all after they stood still ${hits[stop]}); seed $seed"
echo "changes of the number of ranks or threads: $changes"
echo "where: before the file ${places[start]}, before the first new" \
    "generation ${places[resume]}, in later generations" \
    "${places[generations]}, in the finals ${places[finals]}"
echo "files looked at: $looks; complete runs compared: $rounds"
echo "mpirun stuck after all its ranks were gone: $stuck"
echo "starts that failed by themselves: $failed"
echo "generations lost: $lost"
echo "files unreadable: $unreadable"
echo "files with different rows: $different"
[ $((lost + unreadable + different + failed)) -eq 0 ] || fail "the contract is broken"
