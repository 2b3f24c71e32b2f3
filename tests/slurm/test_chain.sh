#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests chains of jobs over two nodes. A job that drains before its time limit
# succeeds, so that the next one resumes the remaining work; after a failure no
# further job starts.
. "$(dirname "$0")/../cli/common.sh"
. "$project/tests/slurm/cluster.sh"

# The run is long enough for its worker to be found while it runs.
write_campaign chain 12 200
sed 's/^seed = 7/seed = 7\nreplicates = 2/; s/"chain"/"tasks"/; s/= 200/= 40/' \
    campaigns/chain.toml >campaigns/tasks.toml
trap stop_cluster EXIT
start_cluster "$folder/cluster" 2
export IDEOTYPE=$ideotype
write_site here mpirun
submit limit --site here.sh --out limit --lead 50 --chain 4 \
    campaigns/chain.toml --time=1 --nodes=2 --ntasks=3 --no-requeue
limit=$job
# Even on a fast machine the first job must not finish before its time limit.
wait_for_file "$(history_of limit chain)"
worker=$(worker_of "$limit")
kill -STOP "$worker"
# Continues the worker in time, whatever this script does meanwhile.
(
    for _ in $(seq 600); do
        ! grep -q "time is up" "ideotype-chain-$limit.log" || break
        sleep 0.1
    done
    kill -CONT "$worker"
) &
submit tasks --site here.sh --out tasks --form sweep --chain 2 \
    campaigns/tasks.toml --no-requeue
tasks=$job
wait_for_file tasks/tasks/ames_0807_762x152_all_r1.h5
scancel --batch --signal=USR1 "${tasks}_0"
submit again --site here.sh --out tasks --form sweep campaigns/tasks.toml
grep -q "nothing to submit" submit-again.log ||
    fail "cases of a chain were submitted twice: $(cat submit-again.log)"

# The first program reports an error, and the ranks of the second die at once.
for name in wrong dying; do
    ending="exit 1"
    [ $name = wrong ] || ending="kill -KILL \$\$"
    cat >$name.sh <<PROGRAM
#!/bin/sh
[ "\$1" != run ] || $ending
exec "$ideotype" "\$@"
PROGRAM
    chmod +x $name.sh
    IDEOTYPE=$folder/$name.sh submit $name --site here.sh --out $name \
        --chain 2 campaigns/chain.toml --no-requeue
done

"$ideotype" run campaigns/tasks.toml --out local >/dev/null
"$ideotype" run campaigns/chain.toml --out local >/dev/null
wait_for_jobs 200 || fail "jobs are still there: $(cat ideotype-*.log)"
show_jobs
same_results "$(history_of local chain)" "$(history_of limit chain)"
for replicate in 1 2; do
    same_results "local/tasks/ames_0807_762x152_all_r$replicate.h5" \
        "tasks/tasks/ames_0807_762x152_all_r$replicate.h5"
done
# $1 a text that the log of one of the remaining jobs must contain
has() {
    grep -q -- "$1" "${@:2}" || fail "no '$1' in $(cat "${@:2}")"
}
has "drained; the next job of the chain continues" "ideotype-chain-$limit.log"
has ": start 1 on node\[1-2\]" "ideotype-chain-$(job_of limit 2).log"
has ": complete$" ideotype-chain-*.log
has "drained; the next job" "ideotype-tasks-${tasks}_0.log"
has ": complete$" "ideotype-tasks-$(job_of tasks 2)_0.log"
has "all cases are finished" "ideotype-tasks-$(job_of tasks 2)_1.log"
has "the program ended with exit code 1" "ideotype-chain-$(job_of wrong 1).log"
second=$(job_of wrong 2)
[ ! -e "ideotype-chain-$second.log" ] || fail "a chain continues after a failure"
sacct -c -j "$second" --format=State | grep -q CANCELLED ||
    fail "SLURM keeps the rest of a chain that failed"
has "ranks were lost (137); the next job" \
    "ideotype-chain-$(job_of dying 1).log"
has "this was the last job of the chain" "ideotype-chain-$(job_of dying 2).log"
