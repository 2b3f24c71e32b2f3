# SPDX-License-Identifier: Apache-2.0
"""Compares cases with each other: gains, energy."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from . import style
from .case import Case
from .cross import Cross
from .file import HistoryError
from .interval import Interval, meaning

ELITE = "elite"
"""The name of the elite plant in a cross-evaluation."""

_PARTS = {
    "leaves": (style.MEAN, ""),
    "stalks": ("#E69F00", "//"),
    "sheaths": ("#F0E442", "xx"),
    "other organs": (style.ANEW, "--"),
    "soil": ("#CC79A7", ".."),
    "reflected": ("#56B4E9", "\\\\"),
}
"""The parts of the light: colour and hatch."""

_ORGANS = {"stalk": "stalks", "sheath": "sheaths"}


def known_cases(cases: Sequence[Case]) -> list[Case]:
    """Returns the cases with baseline and best. Raises HistoryError if there
    is none."""
    known = [case for case in cases if case.pairs]
    if not known:
        raise HistoryError("baseline and best are not evaluated yet")
    return known


def intervals_of(cases: Sequence[Case]) -> str:
    """Tells the meaning of the intervals of cases, which have these numbers of
    seeds."""
    return meaning(len(case.pairs) for case in cases if case.pairs)


def draw_gains(cases: Sequence[Case], cross: Cross | None = None) -> Figure:
    """Draws by case best minus baseline, and minus the elite plant where a
    cross-evaluation has it, in %: mean of seeds with its interval, and the
    seeds."""
    known = known_cases(cases)
    figure = style.new_figure(style.WIDTH, 1.4 + 0.42 * len(known))
    axes = figure.add_subplot()
    for y, case in enumerate(known):
        seeds = [pair.gain.mean for pair in case.pairs]
        axes.plot(
            seeds, [y] * len(seeds), "|", color=style.QUIET, markersize=9,
            label="one seed" if y == 0 else None,
        )  # fmt: skip
        _draw_interval(
            axes, case.relative_gain(), y, style.BEST, "o",
            "over the baseline" if y == 0 else None,
        )  # fmt: skip
    elite = [
        (y, gain)
        for y, case in enumerate(known)
        if cross and (gain := cross.relative_gain(case, ELITE))
    ]
    for i, (y, gain) in enumerate(elite):
        _draw_interval(
            axes, gain, y + 0.2, style.ANEW, "s",
            "over the elite plant" if i == 0 else None,
        )  # fmt: skip
    axes.axvline(0, color=style.BASELINE, linewidth=1, linestyle="--")
    axes.set_yticks(range(len(known)), [_with_leaf_area(c) for c in known])
    axes.set_ylim(len(known) - 0.5, -0.5)
    names = {case.best.row.goals[0].name for case in known}
    what = style.words(names.pop()) if len(names) == 1 else "the objective"
    axes.set_xlabel(f"gain in {what} [%]")
    figure.legend(loc="outside lower center", ncols=3, fontsize=8)
    style.say(figure, intervals_of(known))
    return figure


def _with_leaf_area(case: Case) -> str:
    """Returns the case's name, and how far a gain is one of more leaves."""
    try:
        lais = [case.mean(who, "lai").mean for who in ("baseline", "best")]
    except HistoryError:
        return case.name
    return f"{case.name}\nLAI {lais[0]:.2f} \N{RIGHTWARDS ARROW} {lais[1]:.2f}"


def _draw_interval(
    axes: Axes, x: Interval, y: float, color: str, marker: str,
    label: str | None,
) -> None:  # fmt: skip
    axes.errorbar(
        [x.mean], [y], xerr=[np.nan_to_num(x.half_width)],
        color=color, marker=marker, linestyle="none", label=label,
    )  # fmt: skip


def draw_energy(cases: Sequence[Case]) -> Figure:
    """Draws where the incident PAR goes, for baseline and best of each case,
    with the interval of each part. Isolated plots have a panel of their own:
    light from their sides adds to what falls on their ground."""
    known = known_cases(cases)
    panels = [
        [case for case in known if case.is_isolated is alone]
        for alone in (False, True)
    ]
    panels = [panel for panel in panels if panel]
    figure = style.new_figure(
        style.WIDTH, 1.2 + 0.5 * len(panels) + 0.5 * len(known)
    )
    grid = figure.subplots(
        len(panels), 1, squeeze=False, height_ratios=[*map(len, panels)]
    )
    for (axes,), members in zip(grid, panels):
        _draw_balance(axes, members)
    bars = {
        label: handle
        for (axes,) in grid
        for handle, label in zip(*axes.get_legend_handles_labels())
    }
    shown = [part for part in _PARTS if part in bars]
    figure.legend(
        [bars[part] for part in shown], shown,
        loc="outside lower center", ncols=len(shown), fontsize=8,
    )  # fmt: skip
    style.say(figure, intervals_of(known))
    return figure


def shares(case: Case, who: str) -> dict[str, Interval]:
    """Returns parts of the incident PAR in the order of the figure; organs
    other than leaves, stalks and sheaths are together, with at most the sum of
    their errors."""
    found = {"leaves": case.mean(who, "absorbed_fraction")}
    for organ, share in case.light_by_organ(who).items():
        part = _ORGANS.get(organ, "other organs")
        found[part] = share.plus(found[part]) if part in found else share
    for part in ("soil", "reflected"):
        found[part] = case.mean(who, f"{part}_fraction")
    return found


def _draw_balance(axes: Axes, known: Sequence[Case]) -> None:
    ticks: list[float] = []
    labels: list[str] = []
    for i, case in enumerate(known):
        for j, who in enumerate(("baseline", "best")):
            y = i + 0.4 * j
            start = 0.0
            for part, share in shares(case, who).items():
                color, hatch = _PARTS[part]
                axes.barh(
                    y, share.mean, 0.34, left=start, color=color, hatch=hatch,
                    edgecolor="white", linewidth=0.5,
                    xerr=np.nan_to_num(share.half_width),
                    error_kw={"elinewidth": 1, "capsize": 2}, label=part,
                )  # fmt: skip
                start += share.mean
            ticks.append(y)
            labels.append(f"{case.name} {who}")
    axes.set_yticks(ticks, labels)
    axes.set_ylim(len(known) - 0.4, -0.4)
    if known[0].is_isolated:
        axes.set_xlabel(
            "PAR in an isolated plot, over the incident on its ground"
        )
    else:
        axes.set_xlim(0, 1.02)
        axes.set_xlabel("part of the incident PAR")
    axes.grid(axis="y", visible=False)
