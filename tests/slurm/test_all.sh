#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# All tests on clusters side by side, since they mostly wait for SLURM: each
# has a cluster, separate ports and a folder.
# test_all.sh IDEOTYPE PROJECT FOLDER
set -euo pipefail
here=$(readlink -f "$(dirname "$0")")
mkdir -p "$3"
names=(limit chain sweep campaign losses)
processes=()
for name in "${names[@]}"; do
    "$here/test_$name.sh" "$1" "$2" "$3/$name" >"$3/$name.log" 2>&1 &
    processes+=($!)
done
trap 'kill "${processes[@]}" 2>/dev/null || true; wait' EXIT
failed=()
for i in "${!names[@]}"; do
    wait "${processes[i]}" || failed+=("${names[i]}")
    cat "$3/${names[i]}.log"
done
[ ${#failed[@]} -eq 0 ] || {
    echo "FAILED: ${failed[*]}" >&2
    exit 1
}
