#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints one table of all benchmarks: times, ratios to the best that Embree
# can do, exponents of cost, memory, and the share of time inside Embree.
# Usage: tests/benchmark/table.sh BENCHMARKS [OPTION...], with the executable
# (build/dev/tests/benchmark/benchmarks) and options of Google Benchmark.
set -euo pipefail
if [ $# -lt 1 ]; then
    sed -n '3,6s/^# //p' "$0" >&2
    exit 2
fi
benchmarks=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

run() {
    "$benchmarks" --benchmark_format=json "$@" 2>/dev/null
}
run --benchmark_filter='^memory' >"$folder/memory.json"
run --benchmark_filter='-^memory' "$@" >"$folder/all.json"
if command -v perf >/dev/null && perf record -q -e cpu-clock -F 999 \
    -o "$folder/perf" "$benchmarks" --benchmark_filter='^generation' \
    >/dev/null 2>&1; then
    perf report -i "$folder/perf" --no-children --sort dso 2>/dev/null |
        grep -v '^#' >"$folder/shares" || true
fi

program=$(dirname "$benchmarks")/../../src/ideotype
if command -v mpirun >/dev/null && [ -x "$program" ]; then
    here=$(dirname "${BASH_SOURCE[0]}")
    "$here/rank_memory.sh" "$program" "$here/../../campaigns/ames.toml" \
        >"$folder/ranks"
fi

python3 - "$folder" <<'PYTHON'
import json
import math
import os
import sys

folder = sys.argv[1]
runs = []
for name in ("all", "memory"):
    with open(f"{folder}/{name}.json") as file:
        runs += json.load(file)["benchmarks"]
by_name = {run["name"]: run for run in runs}
limit = max(
    (run["rays"] for run in runs if "rays" in run), default=math.nan
)
print(f"load average {' '.join(f'{x:.1f}' for x in os.getloadavg())}; ratios "
      "within one run mean more than times\n")
print(f"{'benchmark':<42} {'ms':>10} {'rays or paths/s':>16} "
      f"{'of the limit':>13}  ")
for run in runs:
    rate = run.get("rays", run.get("paths") if run["name"] == "light" else 0)
    more = [
        f"{key} {run[key]:.4g}"
        for key in ("faces", "error", "evaluations", "MiB")
        if key in run
    ]
    if run["name"].startswith("evaluation"):
        more.append(f"paths {run['paths']:.4g}")
    print(
        f"{run['name']:<42} {run['cpu_time']:>10.3f} "
        + (f"{rate / 1e6:>14.2f} M {rate / limit:>13.3f}" if rate
           else " " * 30)
        + "  " + ", ".join(more)
    )

print("\ncost as a power of what grows, of the last doubling and of all")
for family in ("plants", "leaves", "faces", "hours", "sites"):
    points = sorted(
        (run["size"], run["cpu_time"])
        for run in runs
        if run["name"].startswith(f"{family}/")
    )
    if len(points) < 2:
        continue

    def exponent(first, last):
        return math.log(last[1] / first[1]) / math.log(last[0] / first[0])

    print(
        f"{family:<8} {points[0][0]:>8g} .. {points[-1][0]:<8g} "
        f"{exponent(points[-2], points[-1]):>6.2f} "
        f"{exponent(points[0], points[-1]):>6.2f}"
    )

if os.path.exists(f"{folder}/shares"):
    print("\nshare of the time of a generation, by library")
    with open(f"{folder}/shares") as file:
        lines = [line.split() for line in file if line.strip()]
    for share, library, *_ in lines[:5]:
        print(f"{share:>8} {library}")
if os.path.exists(f"{folder}/ranks"):
    print("\nmemory of a run's ranks; 0 is the master")
    with open(f"{folder}/ranks") as file:
        print(file.read(), end="")
PYTHON
