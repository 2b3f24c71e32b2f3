#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures the cost of an evaluation for rank 0, and the number of workers it serves.
# Usage: tests/stress/master_cost.sh [RANKS...]    after a build of preset dev
set -euo pipefail
cd "$(dirname "$0")/../.."
program=build/dev/tests/run/master_cost
[ $# -gt 0 ] || set -- 2 3 5 9 17 33 64
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 \
    OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1 \
    OMPI_MCA_hwloc_base_binding_policy=none \
    PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe \
    PRTE_MCA_hwloc_default_binding_policy=none
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

echo "workers sleep/ms evaluations per-second CPU/us-each CPU-of-rank-0/%"
for ranks in "$@"; do
    mpirun -n "$ranks" "$program" "$folder" | tee -a "$folder/table"
done

# Rank 0 is saturated if evaluations take no time; otherwise most of its CPU
# time is spent polling for messages.
awk '$2 == 0 { if (!least || $5 < least) least = $5 }
     END { printf "\nat %.0f us each, one master feeds %.0f workers at 5 ms " \
               "and %.0f at 100 ms per evaluation\n",
               least, 5000 / least, 100000 / least }' "$folder/table"
