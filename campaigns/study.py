#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the study of RESULTS.md anew: all of its tables and figures.

study.py FOLDER [--only PART...] [--short] [--check] [--results FILE.md]

Each part is a script of this folder, which breeds and evaluates in FOLDER/PART and
prints a table. What is in FOLDER already is not bred again, and interrupted searches
go on. The tables replace those between

    <!-- study: PART -->
    <!-- end of study -->

in RESULTS.md; with --check that file stays as it is, and the script fails if any number
in it is not what the histories say. It tells the commit of the project, the version of
the program, the time that each part took, and how many evaluations the histories have.
--short is a study of minutes with the same parts, for tests.
IDEOTYPE_EXECUTABLE names the program, else it is that on PATH.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from shared import HERE, guard

import ideotype


@dataclass(frozen=True)
class Part:
    question: str
    words: tuple[str, ...]
    """The script and its options; {folder} is that of the part, {study} that of all
    parts."""
    short: tuple[str, ...] = ()
    """Options of a short study, after the others."""


PARTS = {
    "paper_table": Part(
        "How much can breeding gain, and which search finds it?",
        (
            "paper_table.py",
            "{folder}",
            "--figure",
            "{figures}/paper_table.png",
        ),
        (
            *("--rough", "--objective", "absorbed_par"),
            *("--condition", "all", "azimuth", "angles", "widths"),
            *("7", "56p2", "15x3", "15x6"),
            *("--evaluations", "20", "--seeds", "1"),
        ),
    ),
    "plants_differ": Part(
        "What do plants that are all alike hide?",
        ("plants_differ.py", "--figure", "{figures}/plants_differ.png"),
        ("--under", str(HERE / "ames_quick.toml"), "--plants", "2"),
    ),
    "erect_tops": Part(
        "When does an erect top pay?",
        (
            "erect_tops.py",
            "{folder}",
            "--figure",
            "{figures}/erect_tops.png",
        ),
        (
            *("--rough", "--light", "clear", "--limit", "area"),
            *("--densities", "4", "20", "--latitudes", "42"),
            *("--generations", "2", "--seeds", "2"),
        ),
    ),
    "claims": Part(
        "What are the claims of arXiv:2512.06064 worth?",
        ("claims.py", "{folder}", "--table", "{study}/paper_table"),
        (
            *("--set-up", "stand, absorbed PAR"),
            *("--evaluations", "20", "--seeds", "1", "--rough"),
        ),
    ),
}


def table_of(name: str, folder: Path, figures: Path, is_short: bool) -> str:
    """What the script of a part prints."""
    part = PARTS[name]
    words = [*part.words, *(part.short if is_short else ())]
    done = subprocess.run(
        [
            sys.executable,
            str(HERE / words[0]),
            *(
                word.format(
                    folder=folder / name, study=folder, figures=figures
                )
                for word in words[1:]
            ),
        ],
        check=False,
        stdout=subprocess.PIPE,
        text=True,
    )
    if done.returncode != 0:
        raise SystemExit(f"{name}: {words[0]} ended with {done.returncode}")
    return done.stdout.strip()


def block(name: str) -> re.Pattern[str]:
    return re.compile(
        rf"(<!-- study: {name} -->\n)(.*?)(<!-- end of study -->)", re.DOTALL
    )


def written(results: Path, name: str) -> str:
    """The table of a part as the file has it."""
    found = block(name).search(results.read_text(encoding="utf-8"))
    if found is None:
        raise SystemExit(
            f"{results} has no place for {name}; write "
            f"<!-- study: {name} --> and <!-- end of study --> in it"
        )
    return found[2].strip()


def write(results: Path, name: str, table: str) -> None:
    text = results.read_text(encoding="utf-8")
    results.write_text(
        block(name).sub(lambda found: f"{found[1]}{table}\n{found[3]}", text),
        encoding="utf-8",
    )


def evaluations(folder: Path) -> int:
    """Of all histories of a folder."""
    count = 0
    for path in folder.rglob("*.h5"):
        with ideotype.open_history(path) as history:
            count += len(history.evaluations().genome)
    return count


def told_by(*words: str) -> str:
    """What a command prints, if it can be run."""
    done = subprocess.run(words, check=False, capture_output=True, text=True)
    return done.stdout.strip() or f"{words[0]} tells nothing"


def versions() -> str:
    """Of the project that this script is in, and of the program."""
    program = os.environ.get("IDEOTYPE_EXECUTABLE", "ideotype")
    return "{}; {}".format(
        told_by(
            *("git", "-C", str(HERE), "describe"),
            *("--always", "--dirty", "--tags"),
        ),
        told_by(program, "--version").partition("\n")[0],
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", nargs="+", choices=PARTS, metavar="PART")
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--results", type=Path, default=HERE / "RESULTS.md")
    options = parser.parse_args()
    folder = options.folder.resolve()
    figures = folder if options.short or options.check else HERE / "figures"
    print(versions())
    names = options.only or list(PARTS)
    told = {name: written(options.results, name) for name in names}
    wrong = []
    for name in names:
        (folder / name).mkdir(parents=True, exist_ok=True)
        begin = time.monotonic()
        table = table_of(name, folder, figures, options.short)
        print(
            f"{name}: {PARTS[name].question} "
            f"{time.monotonic() - begin:.0f} s, "
            f"{evaluations(folder / name)} evaluations"
        )
        if not options.check:
            write(options.results, name, table)
        elif told[name] != table:
            wrong.append(f"{options.results}: {name} is not\n{table}")
    if wrong:
        raise SystemExit("\n".join(wrong))


if __name__ == "__main__":
    guard(main)
