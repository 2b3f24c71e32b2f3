#!/usr/bin/env bash
# A sweep as an array over two nodes of a real SLURM: a task that is requeued in
# the middle resumes, and all histories are bitwise those of local runs.
. "$(dirname "$0")/../app/common.sh"
. "$project/tests/slurm/cluster.sh"

write_campaign sweep 12 100
sed -i 's/^seed = 7/seed = 7\nreplicates = 3/' campaigns/sweep.toml
[ "$("$ideotype" plan campaigns/sweep.toml --count)" = 3 ] || fail "not 3 cases"
"$ideotype" run campaigns/sweep.toml --out local >/dev/null

trap stop_cluster EXIT
start_cluster "$folder/cluster" 2
# Nodes that share one machine cannot share memory by node.
export OMPI_MCA_btl=tcp,self
export IDEOTYPE=$ideotype
job=$(sbatch --parsable --array=0-2 --ntasks=3 --output="slurm-%a.log" \
    "$project/slurm/case.sbatch" campaigns/sweep.toml out)
for _ in $(seq 100); do
    [ -e out/sweep/ames_0807_762x152_all_r1.h5 ] && break
    sleep 0.1
done
scontrol requeue "${job}_0"
wait_for_jobs 120 || fail "jobs are still there: $(cat slurm-*.log)"
for replicate in 1 2 3; do
    same_results "local/sweep/ames_0807_762x152_all_r$replicate.h5" \
        "out/sweep/ames_0807_762x152_all_r$replicate.h5"
done
grep -qi "requeuing" "$cluster/log/slurmctld.log" || fail "nothing was requeued"
