#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures how many genomes of a file `serve` evaluates in a second, beside the
# evaluations of `run`: serve_rate.sh IDEOTYPE CAMPAIGN [GENOMES [RANKS]]. Both
# have the same number of evaluations, with a single generation of random plants.
set -euo pipefail
ideotype=$(realpath "$1")
campaign=$2
genomes=${3:-1000}
ranks=${4:-3}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
launcher=(mpirun -n "$ranks")
[ "$ranks" -gt 1 ] || launcher=()
settings=(--set "search.population=$genomes" --set stop.generations=1
    --set search.optimizer=random --set final.candidates=1)
"${launcher[@]}" "$ideotype" run "$campaign" --out "$folder" "${settings[@]}" >"$folder/run.log"
history=$(find "$folder" -name "*.h5" | head -n 1)
"$ideotype" export "$history" --generations --to "$folder/plants.csv"
# The columns of genes, as requests. A gene of unit 1 has no unit in its column.
"$ideotype" serve "$campaign" </dev/null 2>/dev/null |
    grep -o '"name":"[^"]*","trait":"[^"]*","leaf":[0-9]*,"unit":"[^"]*"' |
    sed -E 's/.*"name":"([^"]*)".*"unit":"([^"]*)"/\1 \2/; s/ 1$//; s/ /_/' >"$folder/genes"
awk -F , 'NR == FNR { wanted[++count] = $1; next }
    !seen { for (i = 1; i <= NF; ++i) at[$i] = i; seen = 1; next }
    { line = ""
      for (i = 1; i <= count; ++i) line = line (i > 1 ? "," : "") $at[wanted[i]]
      print "{\"id\":" FNR - 2 ",\"genome\":[" line "]}" }' \
    "$folder/genes" "$folder/plants.csv" >"$folder/requests"
# The mpirun of MPICH would not bear all of them at once as its own input.
# shellcheck disable=SC2016  # for the shell of each rank
read_requests=(sh -c 'exec "$1" serve "$2" <"$3"' sh "$ideotype" "$campaign"
    "$folder/requests")
"${launcher[@]}" "${read_requests[@]}" >"$folder/answers" 2>"$folder/serve.log"
done=$(grep -c '"status":"done"' "$folder/answers" || true)
[ "$done" = "$genomes" ] || { tail -n 2 "$folder/answers" >&2; exit 1; }
grep -o "generation 0, .* evaluations per second" "$folder/run.log" | sed 's/^/run:   /'
grep -o "[0-9]* genomes .*second" "$folder/serve.log" | sed 's/^/serve: /'
