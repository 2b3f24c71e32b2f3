#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Jobs that are cancelled, or lose a worker or a node, lose no results. A job
# that makes no progress is not requeued for ever.
. "$(dirname "$0")/../cli/common.sh"
. "$project/tests/slurm/cluster.sh"

write_campaign losses 12 400
trap stop_cluster EXIT
start_cluster "$folder/cluster" 3
export IDEOTYPE=$ideotype IDEOTYPE_PATIENCE=3
write_site here mpirun
# Open MPI's mpirun sometimes outlives its ranks; this replacement always does.
cat >clinging.sh <<'LAUNCHER'
#!/bin/sh
mpirun "$@"
exec sleep 1000
LAUNCHER
write_site worker "$folder/clinging.sh"
jobs=()
add_job() {
    submit "$1" --site "$2.sh" --out "$1" campaigns/losses.toml "$3"
    jobs+=("$job")
}
add_job cancel here --nodelist=node1
add_job worker worker --nodelist=node1
add_job node here --exclude=node1

# The ranks of this program die at once.
cat >dying.sh <<PROGRAM
#!/bin/sh
[ "\$1" != run ] || kill -KILL \$\$
exec "$ideotype" "\$@"
PROGRAM
chmod +x dying.sh clinging.sh
IDEOTYPE=$folder/dying.sh IDEOTYPE_IDLE_STARTS=1 submit dying --site here.sh \
    --out dying campaigns/losses.toml
dying=$job

wait_for_file "$(history_of cancel losses)"
scancel "${jobs[0]}"

wait_for_file "$(history_of worker losses)"
kill -KILL "$(worker_of "${jobs[1]}")"

wait_for_file "$(history_of node losses)"
node=$(squeue -h -j "${jobs[2]}" -o %N)
scontrol update "nodename=$node" state=down reason=test

for _ in $(seq 100); do
    [ -n "$(squeue -h -j "${jobs[0]}" 2>/dev/null)" ] || break
    sleep 0.2
done
"$ideotype" status cancel | grep -E ": (drained|dead), " ||
    fail "a cancelled job is not resumable: $("$ideotype" status cancel)"
submit again --site here.sh --out cancel campaigns/losses.toml
[ -n "$job" ] || fail "a cancelled job is not submitted again"

"$ideotype" run campaigns/losses.toml --out local >/dev/null
wait_for_jobs 120 || fail "jobs are still there: $(cat ideotype-*.log)"
show_jobs
for name in cancel worker node; do
    same_results "$(history_of local losses)" "$(history_of $name losses)"
done
grep -q "rank 0 is gone" "ideotype-losses-${jobs[1]}.log" ||
    fail "no word of the killed worker: $(cat "ideotype-losses-${jobs[1]}.log")"
grep -q "start 2 on" "ideotype-losses-${jobs[2]}.log" ||
    fail "no second start: $(cat "ideotype-losses-${jobs[2]}.log")"
grep -q "1 starts did not complete one evaluation" \
    "ideotype-losses-$dying.log" ||
    fail "an idle job continues: $(cat "ideotype-losses-$dying.log")"
