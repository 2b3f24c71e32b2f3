# SPDX-License-Identifier: Apache-2.0
"""A history in words."""

from __future__ import annotations

import math
from datetime import timedelta

from .._errors import printable
from .estimate import Estimate
from .file import HistoryError
from .history import History
from .interval import ONE_SEED
from .pair import Pair

_INDENT = 13
_HARDLY_EVER = 8
"""Leaf area index of a field, as the program warns of it."""


def summarize(history: History) -> str:
    """Case, site, program, state, counts, and baseline against best, as lines
    of text."""
    generations, rows = history.generations(), history.evaluations()
    state = history.state()
    has = history.attributes
    lines = [
        ("case", f"{has.get('case', '?')} of campaign {has.get('campaign', '?')}"),
        ("site", _site(history)),
        ("program", _program(history)),
        ("state", str(state)),
        ("generations", f"{len(generations)} of at most {has.get('generations', '?')}"),
        ("evaluations", f"{len(rows)} complete, {_count(len(rows.failed), 'failure')}"),
        ("wall time", duration(state.wall_time)),
    ]  # fmt: skip
    text = [_field(name, value) for name, value in lines]
    if len(rows.failed):
        text.append(_field("last failure", str(rows.failed.message[-1])))
    front = history.front()
    if front is not None and front.is_final:
        kept = int(front.is_kept.sum())
        counts = f"{kept} of {len(front.members)} plants are still in it"
        text.append(_field("front", f"{counts}, evaluated again"))
    if unchecked := history.unchecked():
        text.append(
            _field(
                "unchecked",
                f"{unchecked} of the evaluations: a generation has a checksum "
                "once it is complete",
            )
        )
    pair = history.comparison()
    text.append("")
    text += (
        ["baseline and best are not evaluated yet"]
        if pair is None
        else _pair(pair)
    )
    return "\n".join(map(printable, text))


def _field(name: str, value: str) -> str:
    return f"{name:<{_INDENT}}{value}"


def duration(seconds: float) -> str:
    """ "1:02:03", or "unknown" for NaN."""
    if not math.isfinite(seconds):
        return "unknown"
    return str(timedelta(seconds=round(seconds)))


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" + ("" if number == 1 else "s")


def _site(history: History) -> str:
    has = history.attributes
    parts = [str(has.get("site", "?"))]
    if "latitude" in has and "longitude" in has:
        parts.append(
            _side(float(has["latitude"]), "N", "S")
            + " "
            + _side(float(has["longitude"]), "E", "W")
        )
    if "day" in has:
        parts.append(f"day {has['day']}")
    if "row_spacing" in has and "plant_spacing" in has:
        parts.append(
            f"rows {float(has['row_spacing']):.4g} m and plants "
            f"{float(has['plant_spacing']):.4g} m apart"
        )
    if "trait_set" in has:
        parts.append(f"traits {has['trait_set']}")
    return ", ".join(parts)


def _side(angle: float, positive: str, negative: str) -> str:
    return f"{abs(angle):.2f} {positive if angle >= 0 else negative}"


def _program(history: History) -> str:
    has = history.attributes
    name = f"{has.get('program', '?')} {has.get('program_version', '?')}"
    commit = str(has.get("git_sha", "unknown"))[:10]
    changed = ", changed" if has.get("git_dirty") == "yes" else ""
    isa = f", {has['isa']}" if "isa" in has else ""
    return f"{name} (commit {commit}{changed}{isa})"


def _pair(pair: Pair) -> list[str]:
    baseline, best = pair.baseline.objective, pair.best.objective
    name = pair.best.row.goals[0].name.replace("_", " ")
    name = name.replace(" par", " PAR")
    table = [(name, "baseline", "best")]
    for was, now in zip(baseline.in_common_units(), best.in_common_units()):
        table.append((f"  {was.unit}", was.number(), now.number()))
    lines = [f"{a:<20}{b:>22}{c:>22}" for a, b, c in table]
    lines.append(_gain("gain", pair.gain))
    lines += _leaf_area(pair)
    lines.append("")
    lines.append(
        f"All errors are standard errors; {_error_of_gain(pair)}; both plants "
        "were evaluated again."
        if pair.is_final
        else "Provisional: the best of a generation (not evaluated again) is too high "
        "on average; the final evaluation is not complete."
    )
    return [*lines, f"{ONE_SEED[0].upper()}{ONE_SEED[1:]}."]


def _error_of_gain(pair: Pair) -> str:
    if pair.is_paired:
        return "that of the gain is paired by randomisation"
    return "that of the gain takes both plants as independent"


def _gain(name: str, gain: Estimate) -> str:
    error = f"{gain.standard_error:.2f} %"
    return f"{name:<20}{'':22}{f'{gain.mean:+.2f}':>12} +- {error}"


def _leaf_area(pair: Pair) -> list[str]:
    """Whether the gain is one of more leaves or of better ones."""
    if "lai" not in pair.best.row.quantities:
        return []
    lais = [each.estimate("lai").mean for each in (pair.baseline, pair.best)]
    lines = [f"{'LAI':<20}{lais[0]:>22.3f}{lais[1]:>22.3f}"]
    if lais[1] > _HARDLY_EVER:
        lines.append(
            f"warning: the best plant has a leaf area index of {lais[1]:.2f}, "
            f"and fields hardly ever have more than {_HARDLY_EVER}"
        )
    try:
        was, now = pair.baseline.per_leaf_area, pair.best.per_leaf_area
    except HistoryError:
        return lines
    return [
        *lines,
        "absorbed PAR per leaf area",
        f"{f'  {was.unit}':<20}{was.number():>22}{now.number():>22}",
        _gain("  gain", pair.gain_per_leaf_area),
    ]
