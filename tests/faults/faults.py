# SPDX-License-Identifier: Apache-2.0
"""Lets one call after the other fail in small campaigns: see README.md.

faults.py IDEOTYPE LIBRARY [--most N] [--sample N] [--seed N] [--jobs N]
    [--only SETUP[/KIND]]

LIBRARY is faults.so of the same build. Prints a table of outcomes by kind of
call, and all that is wrong; ends with 1 if anything is."""

from __future__ import annotations

import argparse
import random
import shutil
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from disturbed import Fault, Setup, Verdict

_PROJECT = Path(__file__).resolve().parents[2]
_DATA = Path(__file__).resolve().parent

# Modes by kind of call. With "+" all later calls fail as well.
CALLS = {
    "write": ["EIO", "ENOSPC", "ENOSPC+", "EINTR", "short"],
    "reserve": ["ENOSPC", "EIO", "EINTR"],
    "sync": ["EIO", "ENOSPC", "EINTR"],
    "open": ["EMFILE", "EMFILE+", "EACCES", "EIO", "EINTR"],
    "rename": ["EIO", "ENOSPC", "EACCES"],
    "read": ["EIO", "EINTR", "short"],
    "map": ["ENOMEM"],
    "allocate": ["ENOMEM", "ENOMEM+"],
    "grow": ["ENOMEM"],
    "start": ["EAGAIN"],
}
MESSAGES = {"send": ["EIO", "delay"], "receive": ["EIO", "delay"]}
FILES = {
    "open": ["EMFILE", "EACCES", "EIO", "EINTR"],
    "read": ["EIO", "EINTR", "short"],
}
# Campaign, kinds of calls, and where they fail: the rank, and a part of the
# file name.
SETUPS = {
    "day": ("day", CALLS, None, None),
    "crop": ("season", FILES, None, "crops"),
    "weather": ("season", FILES, None, "weather"),
    "rank0": ("day", MESSAGES, 0, None),
    "rank1": ("day", MESSAGES, 1, None),
}
_RANKS = 3


def prepared(program: Path, library: Path, name: str, folder: Path) -> Setup:
    """Returns a setup with an undisturbed run, made in a new folder."""
    campaign, _, rank, _ = SETUPS[name]
    folder.mkdir()
    for part in ("crops", "weather"):
        shutil.copytree(_PROJECT / "campaigns" / part, folder / part)
    path = folder / f"{campaign}.toml"
    shutil.copy(_DATA / path.name, path)
    ranks = None if rank is None else _RANKS
    return Setup(program, library, path, folder, ranks)


def numbers(count: int, upper: int, sample: int, seed: str) -> list[int]:
    """Returns all numbers up to `upper`, and a random sample of the numbers
    from there to `count`."""
    rest = range(upper + 1, count + 1)
    chosen = random.Random(seed).sample(rest, min(sample, len(rest)))
    return [*range(1, min(count, upper) + 1), *sorted(chosen)]


def faults_of(
    name: str, counts: dict[str, int], upper: int, sample: int, seed: int
) -> Iterator[Fault]:
    """Yields the faults to try in a setup; `counts` are the numbers of calls
    in its undisturbed run."""
    _, calls, rank, file = SETUPS[name]
    for kind, modes in calls.items():
        for mode in modes:
            chosen = f"{seed} {name} {kind} {mode}"
            for n in numbers(counts[kind], upper, sample, chosen):
                lasting = mode.endswith("+")
                yield Fault(kind, mode.rstrip("+"), n, lasting, rank, file)


def tried(
    setup: Setup, faults: list[Fault], jobs: int
) -> Iterator[tuple[Fault, Verdict]]:
    """Yields the outcome of each fault."""
    with ThreadPoolExecutor(jobs) as pool:
        outs = [f"out{i}" for i in range(len(faults))]
        verdicts = pool.map(setup.judge, faults, outs)
        yield from zip(faults, verdicts, strict=True)


def mode_of(fault: Fault) -> str:
    return fault.mode + ("+" if fault.lasting else "")


def report(
    name: str, counts: dict[str, int], verdicts: list[tuple[Fault, Verdict]]
) -> list[str]:
    """Prints a row for each kind and mode, and returns the errors."""
    outcomes: dict[tuple[str, str], Counter[str]] = {}
    wrong = []
    for fault, verdict in verdicts:
        at = (fault.kind, mode_of(fault))
        outcomes.setdefault(at, Counter())[verdict.outcome] += 1
        if verdict.wrong:
            wrong.append(
                f"{name} {fault} on '{verdict.hit}': "
                f"{'; '.join(verdict.wrong[:4])}\n{verdict.output[-600:]}"
            )
        if verdict.outcome == "signal":
            last = verdict.output.strip().splitlines()[-1:]
            print(f"signal: {name} {fault}: {last}", file=sys.stderr)
    for (kind, mode), by in outcomes.items():
        cells = [
            by[each] or "" for each in ("right", "told", "signal", "not met")
        ]
        bad = by["silent"] + by["hung"]
        row = [name, kind, mode, counts[kind], by.total(), *cells, bad or ""]
        print("| " + " | ".join(map(str, row)) + " |", flush=True)
    return wrong


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=Path)
    parser.add_argument("library", type=Path)
    parser.add_argument("--most", type=int, default=200)
    parser.add_argument("--sample", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="")
    words = parser.parse_args()
    only_setup, _, only_kind = words.only.partition("/")
    print("| where | call | fault | calls | tried | right | told | signal |")
    wrong: list[str] = []
    with tempfile.TemporaryDirectory() as folder:
        for name in SETUPS:
            if only_setup not in ("", name):
                continue
            program = words.program.resolve()
            place = Path(folder) / name
            setup = prepared(program, words.library.resolve(), name, place)
            _, _, rank, file = SETUPS[name]
            counts = setup.counts(rank, file)
            faults = [
                fault
                for fault in faults_of(
                    name, counts, words.most, words.sample, words.seed
                )
                if only_kind in ("", fault.kind)
            ]
            found = list(tried(setup, faults, words.jobs))
            wrong += report(name, counts, found)
    print(*wrong, sep="\n\n")
    print(f"{len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
