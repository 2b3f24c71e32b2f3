#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reproduces the tables and figures of docs/results.

study.py FOLDER [--only PART...] [--short] [--check] [--results PAGES]

A part is a script of this folder. It runs searches and evaluations in
FOLDER/PART and prints a table. Finished searches are not repeated, and
interrupted ones resume. The table replaces, in this clone, the text between

    <!-- study: PART -->
    <!-- end of study -->

on the page that has these marks, one of PAGES/*.md (docs/results by default).
A sentence below each table states how many of its searches have converged, and
which traits of their best plants are at a bound.

A paragraph of a page may name a cause only if this page shows an intervention:
a table in which this cause alone was changed, after a mark with its name,

    <!-- intervention: height -->

or if it links to such a page. Otherwise the script fails.

With --check the pages stay unchanged, and the script fails if a number on them
differs from what its script prints; parts without histories are computed
again, and parts that FOLDER lacks are run. The last digit of a number after ±
may differ by one, since some intervals were computed from rounded standard
errors.

The script prints the commit of the project, the version of the program and the
digests of the input files; for each part also the evaluations in its histories,
the time that it took, earlier sessions included, and whether the table on the
page holds. --short runs the same parts roughly, in minutes; its tables stand
between <!-- short study: PART --> and <!-- end of study -->.
IDEOTYPE_EXECUTABLE names the program; without it, the one on PATH is used.
"""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
import time
from collections import Counter
from dataclasses import dataclass
from difflib import unified_diff
from pathlib import Path
from statistics import median
from textwrap import shorten

from shared import CAMPAIGNS, guard, parser_of, run_program
from study_parts import PARTS

import ideotype
from ideotype.figures.convergence import judge_convergence
from ideotype.history import Case
from ideotype.history.bounds import bounds_in_words
from ideotype.history.trend import End

HERE = Path(__file__).parent
PAGES = CAMPAIGNS.parent / "docs" / "results"


def table_of(name: str, folder: Path, figures: Path, is_short: bool) -> str:
    """Returns the output of the script of a part."""
    part = PARTS[name]
    words = [*part.words, *(part.short if is_short else ())]
    places = {"folder": folder / name, "study": folder, "figures": figures}
    if words[0] != "-m":
        words[0] = str(HERE / words[0])
    done = run_program(
        [sys.executable, *(word.format(**places) for word in words)]
    )
    if done.returncode != 0:
        raise SystemExit(f"{name}: {words[0]} ended with {done.returncode}")
    return "\n\n".join([done.stdout.strip(), *say_searches(folder / name)])


def say_searches(folder: Path) -> list[str]:
    """States for the searches in a folder whether they have converged, and
    which traits are at a bound. Searches for several objectives, or for many
    types of plants, have no single best plant and are left out."""
    if not any(folder.rglob("*.h5")):
        return []
    with ideotype.open_study(folder) as study:
        searches = [
            Case(history.path.stem, [history])
            for history in study
            if not history.is_sensitivity
            and len(history.objectives) == 1
            and not history.resolved["search"].get("axes")
            and history.generations()
        ]
        verdicts = [
            judge_convergence(case, [case.histories[0].generations()])
            for case in searches
        ]
        bounds = bounds_in_words(searches)
    if not searches:
        return []
    count = Counter(verdict.end for verdict in verdicts)
    text = f"Searches: {len(searches)}. Converged: " + ", ".join(
        f"{end.value} {count[end]}" for end in End
    )
    left = [x.left for x in verdicts if x.left is not None]
    if left:
        text += (
            "; as many further evaluations gain at most "
            f"{median(left):.1f} % of the baseline more, in 90 % of searches "
            f"(median of {len(left)} by `auto`)"
        )
    return [f"{text}. At a bound: {bounds or 'no trait'}."]


END = "<!-- end of study -->"

CAUSE = re.compile(
    r"\b(because|due to|owing to|caus(e|es|ed|ing)|explain(s|ed)?)\b",
    re.IGNORECASE,
)
INTERVENTION = re.compile(r"<!-- intervention: [^>]+ -->\n+(\||<!-- study: )")
PARAGRAPH = re.compile(r"\n\n|\n(?=\* |\|)")


def causes_without_intervention(pages: Path) -> list[str]:
    """Lists the paragraphs that name a cause, on pages that neither show an
    intervention nor link in this paragraph to one that does."""
    texts = {
        page.name: page.read_text(encoding="utf-8")
        for page in sorted(pages.glob("*.md"))
    }
    shown = {name for name, text in texts.items() if INTERVENTION.search(text)}
    return [
        f'{pages / name}: "{shorten(paragraph, 60)}" names a '
        "cause, but no intervention shows it; put <!-- intervention: NAME --> "
        "before a table in which it alone was changed, link to such a page, or "
        "say it without a cause"
        for name, text in texts.items()
        if name not in shown
        for paragraph in PARAGRAPH.split(text)
        if CAUSE.search(paragraph)
        and not shown & set(re.findall(r"\((\w+\.md)", paragraph))
    ]


def block(place: str) -> re.Pattern[str]:
    return re.compile(rf"(<!-- {place} -->\n)(.*?)({END})", re.DOTALL)


@dataclass(frozen=True)
class Quotation:
    """The table of a part on a page of results."""

    page: Path
    table: str


def find_quotation(pages: Path, place: str) -> Quotation:
    """Finds the marks of a part on one of the pages."""
    matches = [
        Quotation(page, match[2].strip())
        for page in sorted(pages.glob("*.md"))
        for match in block(place).finditer(page.read_text(encoding="utf-8"))
    ]
    if not matches:
        raise SystemExit(
            f"{pages} has no place for this table; write "
            f"<!-- {place} --> and {END} on one of its pages"
        )
    if len(matches) > 1:
        names = ", ".join(match.page.name for match in matches)
        raise SystemExit(
            f"{pages} has several places for <!-- {place} -->: {names}"
        )
    return matches[0]


HALF_INTERVAL = re.compile(r"± (\d+)(\.\d+)?")


def half_intervals(table: str) -> list[tuple[int, int]]:
    """Returns the numbers after ±, each as its digits and its number of
    decimals."""
    return [
        (int(whole + part[1:]), len(part))
        for whole, part in HALF_INTERVAL.findall(table)
    ]


def agree(old: str, new: str) -> bool:
    """Returns whether two tables are equal, except that the last digits of
    numbers after ± may differ by one."""
    plain = (HALF_INTERVAL.sub("±", table) for table in (old, new))
    pairs = zip(half_intervals(old), half_intervals(new), strict=False)
    return len(set(plain)) == 1 and all(
        decimals == others and abs(digits - others_digits) <= 1
        for (digits, decimals), (others_digits, others) in pairs
    )


def differing_lines(old: str, new: str) -> str:
    """Returns the lines that only one of two tables has."""
    lines = unified_diff(old.splitlines(), new.splitlines(), n=0, lineterm="")
    return "\n".join(x for x in [*lines][2:] if not x.startswith("@@"))


def write(page: Path, place: str, table: str) -> None:
    text = page.read_text(encoding="utf-8")
    page.write_text(
        block(place).sub(lambda match: f"{match[1]}{table}\n{match[3]}", text),
        encoding="utf-8",
    )


def evaluations(folder: Path) -> int:
    """Counts the evaluations in all histories of a folder."""
    count = 0
    for path in folder.rglob("*.h5"):
        with ideotype.open_history(path) as history:
            count += len(history.evaluations().genome)
    return count


def output_of(*words: str) -> str:
    """Returns the output of a command, or a text that it prints nothing."""
    done = subprocess.run(words, check=False, capture_output=True, text=True)
    return done.stdout.strip() or f"{words[0]} prints nothing"


def versions() -> str:
    """Describes the versions of the project and of the program."""
    program = os.environ.get("IDEOTYPE_EXECUTABLE", "ideotype")
    return "{}; {}".format(
        output_of(
            *("git", "-C", str(CAMPAIGNS), "describe"),
            *("--always", "--dirty", "--tags"),
        ),
        output_of(program, "--version").partition("\n")[0],
    )


def digests() -> list[str]:
    """Lists the digests of all plants, weather files and campaigns that parts
    may read."""
    return [
        f"{hashlib.sha256(path.read_bytes()).hexdigest()[:12]} "
        f"{path.relative_to(CAMPAIGNS)}"
        for pattern in (
            "crops/*.toml",
            "plants/*.toml",
            "weather/*.csv",
            "*.toml",
        )
        for path in sorted(CAMPAIGNS.glob(pattern))
    ]


def timed(folder: Path, seconds: float) -> float:
    """Adds the time of this session, and returns the time that a part took in
    all sessions."""
    path = folder / "seconds"
    before = float(path.read_text()) if path.exists() else 0.0
    path.write_text(f"{before + seconds:.1f}\n")
    return before + seconds


def main() -> None:
    parser = parser_of(__doc__, f"Parts: {', '.join(PARTS)}.")
    parser.add_argument(
        "folder", type=Path, help="of histories; made if it does not exist"
    )
    parser.add_argument(
        "--only",
        nargs="+",
        choices=PARTS,
        metavar="PART",
        help="run these parts instead of all",
    )
    parser.add_argument(
        "--short", action="store_true", help="run roughly, in minutes"
    )
    parser.add_argument(
        "--check",
        action="store_true",
        help="compare tables with the pages instead of replacing them",
    )
    parser.add_argument(
        "--results",
        type=Path,
        default=PAGES,
        metavar="PAGES",
        help="the folder of pages (default: docs/results)",
    )
    options = parser.parse_args()
    folder = options.folder.resolve()
    figures = folder if options.short or options.check else HERE / "figures"
    print("\n".join([versions(), *digests()]), flush=True)
    places = {
        name: f"{'short study' if options.short else 'study'}: {name}"
        for name in options.only or PARTS
    }
    quotations = {
        name: find_quotation(options.results, place)
        for name, place in places.items()
    }
    wrong = causes_without_intervention(options.results)
    for name, place in places.items():
        (folder / name).mkdir(parents=True, exist_ok=True)
        begin = time.monotonic()
        table = table_of(name, folder, figures, options.short)
        seconds = time.monotonic() - begin
        if not options.check:
            seconds = timed(folder / name, seconds)
        page, before = quotations[name].page, quotations[name].table
        is_same = agree(before, table)
        print(
            f"{name}: {PARTS[name].question} {seconds:.0f} s, "
            f"{evaluations(folder / name)} evaluations, {page.name} "
            f"{'holds' if is_same else 'differs'}",
            flush=True,
        )
        if not options.check:
            write(page, place, table)
        elif not is_same:
            wrong.append(
                f"{page}: {place} is not what its script prints; the page (-) "
                f"and the script (+):\n{differing_lines(before, table)}"
            )
    if wrong:
        raise SystemExit("\n".join(wrong))


if __name__ == "__main__":
    guard(main)
