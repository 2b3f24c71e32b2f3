#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the benchmark: meshes, cases and their values.

    python make.py [--error 1e-4] [--rounds 40] [--only TEXT]

Two ways that share no code compute each case in rounds, each with a seed of its
own, until all standard errors of both together are below --error of the light
on the ground, or as many rounds are done as --rounds says. methods.csv keeps
what each way has found, so that a run that was stopped continues; the values
depend on the numbers of rounds alone. Where theory knows a value it is the
value, and both ways are compared with it."""

from __future__ import annotations

import argparse
import csv
import sys
from collections import defaultdict
from pathlib import Path
from typing import TextIO

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE / "adapters")]

import plain  # noqa: E402
import program  # noqa: E402
import theory  # noqa: E402
from cases import Case, read_cases, write_cases  # noqa: E402

PATHS, PLAIN_PATHS, PLAIN_REPEATS = 2**17, 2**15, 16

# Mean, standard error and number of rounds by (case, quantity), for each
# method.
Key = tuple[str, str]
Found = dict[str, dict[Key, tuple[float, float, int]]]


def read(path: Path) -> Found:
    found: Found = {"program": {}, "plain": {}}
    if path.exists():
        with path.open() as file:
            for row in csv.DictReader(file):
                found[row["method"]][row["case"], row["quantity"]] = (
                    float(row["value"]),
                    float(row["standard_error"]),
                    int(row["rounds"]),
                )
    return found


def write(path: Path, found: Found) -> None:
    with path.open("w") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(
            ["case", "quantity", "method", "value", "standard_error", "rounds"]
        )
        for method, rows in found.items():
            for (case, quantity), (mean, error, rounds) in sorted(
                rows.items()
            ):
                out.writerow(
                    [
                        case,
                        quantity,
                        method,
                        f"{mean:.9g}",
                        f"{error:.3g}",
                        rounds,
                    ]
                )


def add_round(found: Found, name: str, case: Case) -> None:
    """Adds the answers of both methods with the next seed."""
    first = (name, case["quantities"][0])
    done = found["program"].get(first, (0, 0, 0))[2]
    ways = {
        "program": program.answer(case, paths=PATHS, seed=done + 1),
        "plain": plain.answer(case, PLAIN_PATHS, PLAIN_REPEATS, done + 1),
    }
    for way, answers in ways.items():
        for quantity in filter(answers.get, case["quantities"]):
            mean, error = answers[quantity]
            old = found[way].get((name, quantity), (0.0, 0.0, 0))
            n = old[2] + 1
            found[way][name, quantity] = (
                old[0] + (mean - old[0]) / n,
                ((old[1] * (n - 1)) ** 2 + error**2) ** 0.5 / n,
                n,
            )


def together(found: Found, key: Key) -> tuple[float, float]:
    """Returns the mean of both methods, weighted by precision, and its
    error."""
    known = [rows[key] for rows in found.values() if key in rows]
    for mean, error, _ in reversed(known):
        if error == 0:
            return mean, 0.0
    weights = [1 / error**2 for _, error, _ in known]
    mean = sum(w * x[0] for w, x in zip(weights, known, strict=True))
    return mean / sum(weights), sum(weights) ** -0.5


def is_done(
    found: Found, name: str, case: Case, error: float, rounds: int
) -> bool:
    keys = [(name, q) for q in case["quantities"]]
    if keys[0] not in found["program"]:
        return False
    if found["program"][keys[0]][2] >= rounds:
        return True
    exact = theory.answer(case)
    # Errors of assimilation are relative to its maximum.
    scale = 50.0 if case["class"] == "assimilation" else 1.0
    return all(
        k[1] in exact or together(found, k)[1] <= error * scale for k in keys
    )


def values(
    found: Found, cases: dict[str, Case]
) -> dict[Key, tuple[float, float]]:
    result = {}
    for name, case in cases.items():
        exact = theory.answer(case)
        for quantity in case["quantities"]:
            key = (name, quantity)
            result[key] = (
                (float(exact[quantity]), 0.0)
                if quantity in exact
                else together(found, key)
            )
    return result


def compare(found: Found, cases: dict[str, Case], out: TextIO) -> float:
    """Prints for each class the differences between both methods, and between
    each method and theory.

    Returns the largest deviation in standard errors."""
    pairs = defaultdict(list)
    for name, case in cases.items():
        exact = theory.answer(case)
        for quantity in case["quantities"]:
            rows = {
                w: r[name, quantity]
                for w, r in found.items()
                if (name, quantity) in r
            }
            if quantity in exact:
                rows["theory"] = (float(exact[quantity]), 0.0, 0)
            ways = list(rows)
            for i, one in enumerate(ways):
                for other in ways[:i]:
                    a, b = rows[one], rows[other]
                    # The error includes the rounding in methods.csv.
                    error = (
                        a[1] ** 2 + b[1] ** 2 + (2e-8 * a[0]) ** 2 + 1e-20
                    ) ** 0.5
                    pairs[case["class"], f"{other} and {one}"].append(
                        (a[0] - b[0]) / error
                    )
    print("| class | ways | values | beyond 2 s.e. | largest |", file=out)
    print("|---|---|---|---|---|", file=out)
    worst = 0.0
    for (kind, ways), z in sorted(pairs.items()):
        far = max(map(abs, z))
        worst = max(worst, far)
        beyond = 100 * sum(abs(x) > 2 for x in z) / len(z)
        print(
            f"| {kind} | {ways} | {len(z)} | {beyond:.0f} % | {far:.1f} |",
            file=out,
        )
    return worst


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--error", type=float, default=1e-4)
    parser.add_argument("--rounds", type=int, default=40)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    write_cases()
    cases = read_cases()
    found = read(HERE / "methods.csv")
    for n in range(1, options.rounds + 1):
        for name, case in cases.items():
            if options.only in name and not is_done(
                found, name, case, options.error, n
            ):
                add_round(found, name, case)
                write(HERE / "methods.csv", found)
    with (HERE / "values.csv").open("w") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["case", "quantity", "value", "standard_error"])
        for (name, quantity), (mean, error) in values(found, cases).items():
            out.writerow([name, quantity, f"{mean:.8g}", f"{error:.2g}"])
    worst = compare(found, cases, sys.stdout)
    return 0 if worst < 5 else 1


if __name__ == "__main__":
    sys.exit(main())
