#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the messages of slurm/submit without a cluster.
. "$(dirname "$0")/../cli/common.sh"

# $1 the expected exit code, the rest arguments.
submit() {
    expect "$1" "$project/slurm/submit" "${@:2}"
}

# This machine has all commands except those of SLURM.
mkdir bin
for command in bash chmod cp basename dirname readlink realpath cut cat id grep wc \
    ls sed awk; do
    ln -s "$(command -v $command)" bin/$command
done
full_path=$PATH
PATH=$folder/bin
export IDEOTYPE=$ideotype
write_campaign plain 6 2
sed 's/^seed = 7/seed = 7\nreplicates = 3/' campaigns/plain.toml \
    >campaigns/sweep.toml
sed 's/plants = 3/plnats = 3/' campaigns/plain.toml >campaigns/typo.toml

submit 0 --help
says "--throttle"
submit 2
says "no campaign"
submit 2 --form both campaigns/plain.toml
submit 2 --throttle many campaigns/plain.toml
submit 2 --chain 0 campaigns/plain.toml
submit 2 --site nowhere campaigns/plain.toml
says "generic.sh"
submit 1 campaigns/plain.toml
says "there is no sbatch here"
submit 3 --dry-run campaigns/typo.toml
says "typo.toml:18:1: unknown key .plnats."
submit 1 --dry-run campaigns/missing.toml
IDEOTYPE=$folder/nothing
submit 1 --dry-run campaigns/plain.toml
says "IDEOTYPE"
IDEOTYPE=$ideotype

submit 0 --dry-run campaigns/sweep.toml
says "^queue     squeue is not available"
says "^cases     3: 0 finished, 0 queued, 3 to submit"
says "'--signal=B:USR1@120' .*/campaign.sbatch'"
submit 0 --dry-run --form sweep --throttle 2 --lead 60 campaigns/sweep.toml \
    --time=7
says "'--requeue' .*'--signal=B:USR1@60' .*'--array=0,1,2%2' .*'--time=7' .*/sweep"
submit 0 --dry-run --chain 3 campaigns/sweep.toml
says "^chain     2 more with --dependency=afterok:JOB"
submit 0 --dry-run --chain 3 --form sweep campaigns/sweep.toml
says "^chain     2 more with --dependency=aftercorr:JOB"
PATH=$full_path "$ideotype" run campaigns/sweep.toml --case 1 >/dev/null
submit 0 --dry-run --form sweep campaigns/sweep.toml
says "'--array=0,2'"

# Nothing is submitted while the controller does not answer.
printf '#!%s/bash\necho no controller >&2\nexit 1\n' "$folder/bin" >squeue
chmod +x squeue
cp squeue bin/squeue
cp squeue bin/sbatch
submit 1 campaigns/sweep.toml
says "the queue cannot be read: .*no controller"
