# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype validate`: compares the program with measurements."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..common.output import REFUSED, OutputRefused, save_figure, write_file
from ..common.progress import Progress
from ..common.settings import number_within
from ..errors import Error, printable_lines
from ..validation.comparison import Result, compare, effective_error
from ..validation.facts import (
    Fact,
    Intervention,
    Verdict,
    facts_from_table,
    read_facts,
    shipped_facts,
)
from ..validation.page import describe_conditions, format_page

WORSE = 1
"""The exit code if a fact that passes according to its file now misses."""


def to_json(result: Result) -> dict[str, Any]:
    """Returns a fact and its points, in their units, for JSON."""
    fact = result.fact
    return {
        "name": fact.name,
        "question": fact.question,
        "source": fact.source.citation,
        "read": str(fact.source.read),
        "verdict": str(result.verdict),
        "is_assumption": fact.is_assumption,
        "points": [
            {
                "at": describe_conditions(point.measurement),
                "quantity": point.measurement.quantity,
                "unit": point.measurement.unit,
                "measured": [
                    _json(point.measurement.low),
                    _json(point.measurement.high),
                ],
                "measured_standard_error": _json(
                    effective_error(point.measurement)
                ),
                "computed": point.computed,
                "ours_standard_error": point.standard_error,
                "tolerance": point.tolerance,
                "agrees": point.agrees,
            }
            for point in result.points
        ],
    }


def _json(number: float) -> float | None:
    return number if abs(number) < float("inf") else None


def try_interventions(
    results: Sequence[Result], seeds: int
) -> list[tuple[Result, Intervention, Result]]:
    """Evaluates the interventions of the facts that miss, and returns each
    with the results before and after it."""
    return [
        (
            result,
            change,
            compare(result.fact, seeds, change.keys),
        )
        for result in results
        if result.verdict == Verdict.misses
        for change in result.fact.interventions
    ]


def _facts(options: argparse.Namespace) -> list[Fact]:
    path = options.facts
    if path and path.suffix.lower() == ".csv":
        if options.campaign is None:
            raise Error(
                f"{path} is a table of measurements; name the campaign of its "
                "field with --campaign FILE.toml"
            )
        facts = facts_from_table(path, options.campaign)
    else:
        facts = read_facts(path or shipped_facts())
    return facts.named(options.only or [])


def read_keys(words: Sequence[str]) -> dict[str, Any]:
    """Returns the settings of the command line; texts need no quotes."""
    import tomllib

    keys: dict[str, Any] = {}
    for word in words:
        name, is_set, value = word.partition("=")
        if not is_set:
            raise Error(f"--set {word}: give KEY=VALUE")
        try:
            keys[name] = tomllib.loads(f"x = {value}")["x"]
        except tomllib.TOMLDecodeError:
            keys[name] = value
    return keys


def main(arguments: Sequence[str] | None = None) -> int:
    """Compares facts and returns the exit code: 0, 1 if a fact that passes
    according to its file now misses or a file cannot be written, 2 for a wrong
    command line, 3 for invalid facts, 4 for an output that is a symbolic
    link."""
    parser = argparse.ArgumentParser(
        prog="ideotype validate",
        description="Simulates the conditions of field measurements and "
        "compares the results with the measurements. FACTS is a file of facts, "
        "by default the one that comes with the program, or a CSV table of "
        "measurements of one field. docs/validation.md describes both.",
    )
    add = parser.add_argument
    add("facts", nargs="?", type=Path, metavar="FACTS", help="TOML or CSV")
    add(
        "--campaign",
        type=Path,
        metavar="FILE",
        help="campaign of the field of a CSV table",
    )
    add("--only", nargs="+", metavar="NAME", help="facts to compare")
    add(
        "--set", action="append", default=[], metavar="KEY=VALUE",
        help="replace a key of the campaign of all facts, and leave out "
        "interventions",
    )  # fmt: skip
    add(
        "--seeds", type=number_within(int, 2, 1000), default=8, metavar="N",
        help="number of seeds for each condition (default: 8)",
    )  # fmt: skip
    add("--json", action="store_true", help="print JSON instead of tables")
    add(
        "-o", "--out", type=Path, metavar="FOLDER",
        help="folder for the tables and a figure of each fact",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    try:
        chosen = _facts(options)
        keys = read_keys(options.set)
        results = []
        with Progress("compared") as progress:
            for done, fact in enumerate(chosen):
                progress.show(done, len(chosen), fact.name)
                results.append(compare(fact, options.seeds, keys))
        # Interventions change the plants of the file, not those of --set.
        changes = [] if keys else try_interventions(results, options.seeds)
    except Error as error:
        return _fail(3, error)
    page = format_page(results, changes)
    if options.json:
        print(json.dumps([to_json(x) for x in results], indent=1))
    else:
        print(page)
    if options.out:
        try:
            _write(options.out, page, results)
        except OutputRefused as error:
            return _fail(REFUSED, error)
        except OSError as error:
            return _fail(1, error)
    worse = [
        x.fact.name
        for x in results
        if x.fact.verdict == Verdict.passes and x.verdict == Verdict.misses
    ]
    if worse:
        print(
            "ideotype validate: these facts passed before and miss now: "
            + ", ".join(worse),
            file=sys.stderr,
        )
    return WORSE if worse else 0


def _write(folder: Path, page: str, results: Sequence[Result]) -> None:
    from ..validation.figure import draw_fact

    folder.mkdir(parents=True, exist_ok=True)
    write_file(folder / "facts.md", page + "\n", folder)
    for result in results:
        if result.points:
            save_figure(draw_fact(result), folder / f"{result.fact.name}.png")


def _fail(code: int, error: Exception) -> int:
    print(printable_lines(f"ideotype validate: {error}"), file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
