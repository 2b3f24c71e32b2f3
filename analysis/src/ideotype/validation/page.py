# SPDX-License-Identifier: Apache-2.0
"""Formats comparisons with facts as tables in Markdown."""

from __future__ import annotations

from collections.abc import Sequence

from ..common.markdown import markdown_table
from ..history.estimate import NORMAL, with_interval
from .comparison import Point, Result, effective_error
from .facts import Intervention, Read, Verdict
from .table import Measurement


def describe_conditions(row: Measurement) -> str:
    """Returns the conditions that distinguish a row from the other rows of its
    fact."""
    parts = [f"{key} {value:g}" if isinstance(value, int | float)
             else f"{key} {value}" for key, value in row.keys.items()]  # fmt: skip
    if row.date:
        parts.append(str(row.date))
    if row.hours:
        parts.append(row.hours_text)
    if row.leaves:
        is_rank = row.leaves.isdecimal()
        parts.append(
            f"leaf {row.leaves}" if is_rank else f"{row.leaves} third"
        )
    if row.position == row.position or row.quantity == "light":
        parts.append(f"{row.height:g} m high")
    return ", ".join(parts)


def format_measured(row: Measurement) -> str:
    """Returns the measured value ± half of its 95 % confidence interval, or
    the measured range."""
    if not row.is_measured:
        return ""
    if row.low != row.high:
        if abs(row.low) == float("inf"):
            return f"at most {row.high:g}"
        if abs(row.high) == float("inf"):
            return f"at least {row.low:g}"
        return f"{row.low:g} to {row.high:g}"
    given = "" if row.error == row.error else " (E)"
    return f"{_with_interval(row.value, effective_error(row))}{given}"


def format_computed(point: Point) -> str:
    """Returns the computed value ± half of its 95 % confidence interval."""
    return _with_interval(point.computed, point.standard_error)


def _with_interval(mean: float, standard_error: float) -> str:
    half_width = NORMAL * standard_error
    return with_interval(mean, half_width, half_width)


def points_table(results: Sequence[Result]) -> list[str]:
    """Returns one row for each point of the facts."""
    rows = []
    for result in results:
        for point in result.points:
            row = point.measurement
            side = "lower" if point.apart < 0 else "higher"
            verdict = "agrees" if point.agrees else side
            rows.append(
                [
                    result.fact.name,
                    describe_conditions(row),
                    row.quantity,
                    row.unit,
                    format_measured(row),
                    format_computed(point),
                    verdict if row.is_measured else "",
                ]
            )
    titles = ["fact", "at", "quantity", "unit", "measured", "computed", ""]
    return markdown_table(titles, rows)


def facts_table(results: Sequence[Result]) -> list[str]:
    """Returns one row for each compared fact."""
    rows = []
    for result in results:
        fact = result.fact
        measured = [p for p in result.points if p.measurement.is_measured]
        agree = sum(point.agrees for point in measured)
        rows.append(
            [
                fact.name,
                fact.question,
                str(result.verdict),
                f"{agree} of {len(measured)}",
                str(fact.source.read),
                fact.source.citation,
                fact.note,
            ]
        )
    titles = ["fact", "measurement", "computed", "points that agree"]
    return markdown_table([*titles, "read", "source", "note"], rows)


def score(results: Sequence[Result]) -> str:
    """Returns a sentence with the numbers of facts that pass."""
    compared = [x for x in results if x.verdict != Verdict.none]
    good = [x for x in compared if x.verdict == Verdict.passes]
    abstracts = [x for x in compared if x.fact.source.read == Read.abstract]
    good_abstracts = [x for x in good if x in abstracts]
    return (
        f"{len(good)} of {len(compared)} facts pass; {len(abstracts)} of them "
        f"({len(good_abstracts)} pass) are known from an abstract only."
    )


def format_page(
    results: Sequence[Result],
    interventions: Sequence[tuple[Result, Intervention, Result]] = (),
) -> str:
    """Returns all tables as one text.

    interventions: result of a fact, change of its plants, and result with the
        change."""
    facts = [x for x in results if not x.fact.is_assumption]
    compared = [x for x in facts if x.verdict != Verdict.none]
    others = [x for x in facts if x.verdict == Verdict.none]
    assumed = [x for x in results if x.fact.is_assumption]
    lines = []
    if compared:
        lines += [score(facts), "", *facts_table(compared), ""]
        lines += [*points_table(compared), ""]
    if interventions:
        rows = [
            [
                before.fact.name,
                change.name,
                "; ".join(map(format_computed, before.points)),
                "; ".join(map(format_computed, after.points)),
                str(after.verdict),
                change.sources,
            ]
            for before, change, after in interventions
        ]
        titles = ["fact", "change", "computed", "with the change", "verdict"]
        header = [*titles, "do sources allow it?"]
        lines += [*markdown_table(header, rows), ""]
    if others:
        rows = [
            [
                x.fact.name, x.fact.question,
                x.fact.cannot or "it has no measured value",
                x.fact.source.citation,
            ]
            for x in others
        ]  # fmt: skip
        titles = ["not compared", "measurement", "reason", "source"]
        lines += [*markdown_table(titles, rows), ""]
    if assumed:
        lines += ["What models assume:", ""]
        lines += [*points_table(assumed), ""]
    lines.append(
        "± is half of a 95 % interval; (E): the source gives no error, and a "
        "standard error of 5 % is taken."
    )
    return "\n".join(lines)
