#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scores the answers of any program against the values of the benchmark.

    python score.py ANSWERS.csv...

An answers file has the header `case,quantity,value,standard_error`; the last
column may be empty, and cases may be left out. Prints a table by class of case:
how much was answered, the median and the largest relative error, the part of
answers within 1 %, and the part within three standard errors (of the answer and
of the value together), for answers that have one. Relative errors of light are
those of at least a hundredth of the light on the ground. Needs Python alone."""

from __future__ import annotations

import csv
import json
import sys
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median

HERE = Path(__file__).resolve().parent
LEAST = 0.01  # fraction of the light on the ground
HEADER = ["case", "quantity", "value", "standard_error"]

Numbers = dict[tuple[str, str], tuple[float, float | None]]


class AnswersError(Exception):
    """A file of answers that cannot be scored; the message states file, line
    and problem."""


def read(path: Path) -> Numbers:
    """Reads a file of values or answers."""
    found: Numbers = {}
    with path.open(newline="") as file:
        rows = csv.reader(file)
        header = next(rows, [])
        if header != HEADER:
            raise AnswersError(
                f"{path}:1: the header is {','.join(header)!r}; write "
                f"{','.join(HEADER)!r}"
            )
        for row in rows:
            where = f"{path}:{rows.line_num}"
            if len(row) != 4:
                raise AnswersError(f"{where}: {len(row)} columns; write 4")
            key = (row[0], row[1])
            if key in found:
                raise AnswersError(
                    f"{where}: {' '.join(key)} is answered twice; leave one out"
                )
            try:
                value = float(row[2])
                error = float(row[3]) if row[3] else None
            except ValueError as problem:
                raise AnswersError(
                    f"{where}: {problem}; write a number"
                ) from None
            if value - value != 0 or (error is not None and not error >= 0):
                raise AnswersError(
                    f"{where}: {row[2]} ± {row[3]} is no result; leave out what "
                    "is not known"
                )
            found[key] = (value, error)
    return found


@dataclass
class Score:
    """Answers of one class of cases."""

    asked: int = 0
    relative: list[float] = field(default_factory=list)
    deviations: list[float] = field(default_factory=list)

    def row(self, name: str) -> str:
        answered = f"{len(self.relative)} of {self.asked}"
        if not self.relative:
            return f"| {name} | {answered} | - | - | - | - | - |"
        within = (
            100 * sum(x <= 0.01 for x in self.relative) / len(self.relative)
        )
        sure, largest = "-", "-"
        if z := self.deviations:
            sure = f"{100 * sum(x <= 3 for x in z) / len(z):.0f} %"
            largest = f"{max(z):.1f}"
        return (
            f"| {name} | {answered} | {100 * median(self.relative):.3f} % | "
            f"{100 * max(self.relative):.3f} % | {within:.0f} % | {sure} | "
            f"{largest} |"
        )


def score(
    values: Numbers, answers: Numbers, classes: dict[str, str]
) -> dict[str, Score]:
    """Returns the score of each class and of all cases together.

    Raises AnswersError for an answer to a case or quantity that does not
    exist."""
    for key in answers:
        if key not in values:
            raise AnswersError(
                f"no case asks for {key[1]!r} of {key[0]!r}; the quantities of a "
                "case are in its file"
            )
    scores: dict[str, Score] = {}
    for key, (value, error) in values.items():
        both = [
            scores.setdefault(name, Score())
            for name in (classes[key[0]], "all")
        ]
        for each in both:
            each.asked += 1
        if key not in answers:
            continue
        given, uncertain = answers[key]
        of = abs(value)
        if classes[key[0]] not in ("energy", "assimilation"):
            of = max(of, LEAST)
        for each in both:
            each.relative.append(abs(given - value) / of)
        if uncertain is not None:
            # Values are rounded to eight digits, by up to 5e-8 of them.
            together = (
                (error or 0) ** 2 + uncertain**2 + (5e-8 * value) ** 2 + 1e-18
            ) ** 0.5
            for each in both:
                each.deviations.append(abs(given - value) / together)
    whole = scores.pop("all")
    return dict(sorted(scores.items())) | {"all": whole}


def classes_of(folder: Path) -> dict[str, str]:
    return {
        path.stem: json.loads(path.read_text())["class"]
        for path in folder.glob("*.json")
    }


def table(scores: dict[str, Score]) -> str:
    lines = [
        "| class | answers | median error | largest | within 1 % | within 3 s.e. "
        "| largest, s.e. |",
        "|---|---|---|---|---|---|---|",
        *(each.row(name) for name, each in scores.items()),
    ]
    return "\n".join(lines)


def main(paths: list[str]) -> int:
    if not paths or paths[0].startswith("-"):
        print(__doc__)
        return 0 if paths in (["-h"], ["--help"]) else 2
    values, classes = read(HERE / "values.csv"), classes_of(HERE / "cases")
    for path in paths:
        try:
            found = score(values, read(Path(path)), classes)
        except (AnswersError, OSError) as error:
            print(f"score: {error}", file=sys.stderr)
            return 1
        print(f"{Path(path).stem}\n\n{table(found)}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
