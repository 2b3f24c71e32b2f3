#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# digests.sh IDEOTYPE: prints digests of all results of an evaluation and of all
# rows of a short run, to compare two builds on one machine bit by bit.
set -euo pipefail
ideotype=$(readlink -f "$1")
campaigns=$(readlink -f "$(dirname "$0")/../../campaigns")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r "$campaigns" "$folder/campaigns"
cd "$folder"
sed -i -E 's/^generations = .*/generations = 4/' campaigns/ames_quick.toml

"$ideotype" evaluate campaigns/ames_quick.toml --json | grep -v '"seconds"' |
    sha256sum | sed 's/-/evaluate campaigns\/ames_quick.toml/'
"$ideotype" run campaigns/ames_quick.toml --out results >run.log
"$ideotype" export results/*/*.h5 --generations --to rows.csv >export.log
sha256sum rows.csv | sed 's/rows.csv/4 generations of it/'
