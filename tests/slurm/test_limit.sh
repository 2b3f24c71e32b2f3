#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A job that reaches its time limit drains before it and is requeued, until all
# cases are complete.
. "$(dirname "$0")/../cli/common.sh"
. "$project/tests/slurm/cluster.sh"

write_campaign limit 12 150
sed -i 's/^seed = 7/seed = 7\nreplicates = 2/' campaigns/limit.toml
trap stop_cluster EXIT
start_cluster "$folder/cluster" 2
export IDEOTYPE=$ideotype
write_site here "$(srun_of_mpi)"
submit here --site here.sh --out out --lead 50 campaigns/limit.toml \
    --time=1 --ntasks=2
# Even on a fast machine the first start must not finish before its time limit.
# The controller signals within 30 s; evaluations may take a minute.
wait_for_file "$(history_of out limit)"
worker=$(worker_of "$job")
kill -STOP "$worker"
for _ in $(seq 500); do
    ! grep -q "time is up" ideotype-*.log || break
    sleep 0.1
done
kill -CONT "$worker"
"$ideotype" run campaigns/limit.toml --out local >/dev/null
wait_for_jobs 200 || fail "jobs are still there: $(cat ideotype-*.log)"
show_jobs
for replicate in 1 2; do
    same_results "local/limit/ames_0807_762x152_all_r$replicate.h5" \
        "out/limit/ames_0807_762x152_all_r$replicate.h5"
done
log=$(cat ideotype-*.log)
grep -q "time is up" <<<"$log" || fail "no time limit came: $log"
grep -q "drained; requeued" <<<"$log" || fail "no requeue: $log"
grep -q "start 2 on" <<<"$log" || fail "no second start: $log"
grep -q ": complete$" <<<"$log" || fail "not complete: $log"
