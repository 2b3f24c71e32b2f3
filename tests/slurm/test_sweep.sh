#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A sweep as an array over two nodes of a real SLURM: a requeued task and a task
# that drains in the middle both resume, a second submission adds nothing, and
# all histories are bitwise equal to those of local runs.
. "$(dirname "$0")/../cli/common.sh"
. "$project/tests/slurm/cluster.sh"

write_campaign sweep 12 100
sed -i 's/^seed = 7/seed = 7\nreplicates = 3/' campaigns/sweep.toml
trap stop_cluster EXIT
start_cluster "$folder/cluster" 2
export IDEOTYPE=$ideotype
write_site here mpirun
arguments=(--site here.sh --out out --form sweep --throttle 2
    campaigns/sweep.toml)
submit first "${arguments[@]}"
job=$(sed -n 's/^job  *\([0-9]*\);.*/\1/p' submit-first.log)
wait_for_file out/sweep/ames_0807_762x152_all_r2.h5
scancel --batch --signal=USR1 "${job}_1"
wait_for_file out/sweep/ames_0807_762x152_all_r1.h5
scontrol requeue "${job}_0"
submit second "${arguments[@]}"
grep -q "nothing to submit" submit-second.log ||
    fail "cases were submitted twice: $(cat submit-second.log)"
submit third --site here.sh --out out campaigns/sweep.toml
grep -q "nothing to submit" submit-third.log ||
    fail "cases were submitted twice: $(cat submit-third.log)"

"$ideotype" run campaigns/sweep.toml --out local >/dev/null
wait_for_jobs 120 || fail "jobs are still there: $(cat ideotype-*.log)"
show_jobs
for replicate in 1 2 3; do
    same_results "local/sweep/ames_0807_762x152_all_r$replicate.h5" \
        "out/sweep/ames_0807_762x152_all_r$replicate.h5"
done
grep -qi "requeuing" "$cluster/log/slurmctld.log" || fail "nothing was requeued"
grep -q "drained; requeued" ideotype-*_1.log ||
    fail "no drain: $(cat ideotype-*_1.log)"
submit last "${arguments[@]}"
grep -q "3 finished" submit-last.log || fail "$(cat submit-last.log)"
grep -q "nothing to submit" submit-last.log || fail "$(cat submit-last.log)"
"$ideotype" status out | grep -qx "3 cases: 3 finished" || fail "not 3 finished"
