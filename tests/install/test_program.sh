#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the installed program and the files installed with it.
. "$(dirname "$0")/../cli/common.sh"
build=$4

DESTDIR=$folder/stage expect 0 cmake --install "$build" --prefix /ideotype
prefix=$folder/stage/ideotype
share=$prefix/share
expect 0 "$prefix/bin/ideotype" check "$share/ideotype/campaigns/ames_quick.toml"
for file in doc/ideotype/LICENSE bash-completion/completions/ideotype; do
    [ -s "$share/$file" ] || fail "there is no $file"
done
"$prefix/bin/ideotype" schema | cmp - "$share/ideotype/campaign.schema.json"
# The manual page is built only where help2man is installed.
! command -v help2man >/dev/null || [ -s "$share/man/man1/ideotype.1" ] ||
    fail "there is no manual page"

# The SLURM scripts find the program with which they were installed.
unset IDEOTYPE
expect 0 "$share/ideotype/slurm/submit" --dry-run \
    "$share/ideotype/campaigns/ames_quick.toml"
says "share/ideotype/slurm/campaign.sbatch"
write_campaign plain 6 2
cat >batch.sh <<BATCH
here=$share/ideotype/slurm
. "\$here/settings.sh"
find_program
echo "\$ideotype"
BATCH
expect 0 bash batch.sh
says "^$prefix/bin/ideotype$"
