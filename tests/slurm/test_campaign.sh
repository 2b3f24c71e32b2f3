#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests all cases in one job over two nodes, started by mpirun and by srun, and
# a case that is submitted without slurm/submit.
. "$(dirname "$0")/../cli/common.sh"
. "$project/tests/slurm/cluster.sh"

write_campaign whole 12 60
sed -i 's/^seed = 7/seed = 7\nreplicates = 3/' campaigns/whole.toml
trap stop_cluster EXIT
start_cluster "$folder/cluster" 2
export IDEOTYPE=$ideotype
write_site mpirun mpirun
write_site srun "$(srun_of_mpi)"
for site in mpirun srun; do
    submit $site --site $site.sh --out $site campaigns/whole.toml --nodes=2 \
        --ntasks=4
done
(cd "$project" && IDEOTYPE_SITE=$folder/mpirun.sh sbatch --array=0 \
    --output="$folder/ideotype-hand.log" slurm/sweep.sbatch \
    "$folder/campaigns/whole.toml" "$folder/hand")
"$ideotype" run campaigns/whole.toml --out local >/dev/null
wait_for_jobs 100 || fail "jobs are still there: $(cat ideotype-*.log)"
show_jobs
for site in mpirun srun; do
    for replicate in 1 2 3; do
        same_results "local/whole/ames_0807_762x152_all_r$replicate.h5" \
            "$site/whole/ames_0807_762x152_all_r$replicate.h5"
    done
done
same_results "local/whole/ames_0807_762x152_all_r1.h5" \
    "hand/whole/ames_0807_762x152_all_r1.h5"
[ "$(cat ideotype-*.log | grep -c ": complete$")" -eq 3 ] ||
    fail "not three complete jobs: $(cat ideotype-*.log)"
