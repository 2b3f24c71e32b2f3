# SPDX-License-Identifier: Apache-2.0
"""Compares the gains and the light budgets of cases."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..history.case import Case
from ..history.coordinates import short_names
from ..history.file import HistoryError
from ..history.interval import Interval, bars, interval, meaning
from . import style
from .cross import Cross

OVER_BASELINE = "over the baseline"
"""The label of gains over the baseline."""

ELITE = "elite"
"""The name of the elite plant in a cross-evaluation."""

_MANY = 12
"""The number of cases from which on figures have their greatest density."""

_PARTS = {
    "leaves": (style.MEAN, ""),
    "stalks": ("#E69F00", "//"),
    "sheaths": ("#F0E442", "xx"),
    "other organs": (style.ACCENT, "--"),
    "soil": ("#CC79A7", ".."),
    "reflected": ("#56B4E9", "\\\\"),
}
"""The parts of the light: colour and hatch."""

_SEEN = 0.01
"""Half of the shortest interval that is drawn on a part of the light: shorter
ones are dots on the bar."""

_ORGANS = {"stalk": "stalks", "sheath": "sheaths"}


def select_known(cases: Sequence[Case]) -> list[Case]:
    """Returns the cases with a baseline and a best plant. Raises HistoryError
    if there is no such case."""
    known = [case for case in cases if case.pairs]
    if not known:
        raise HistoryError("baseline and best are not evaluated yet")
    return known


def describe_intervals(cases: Sequence[Case]) -> str:
    """Explains the intervals of cases, which depend on their numbers of
    searches."""
    return meaning(len(case.pairs) for case in cases if case.pairs)


def draw_gains(cases: Sequence[Case], cross: Cross | None = None) -> Figure:
    """Draws the gain of the best plant of each case over the baseline [%], and
    over the elite plant if a cross-evaluation contains it: the mean over
    searches with its interval, and each search."""
    known = select_known(cases)
    figure = style.new_figure(style.WIDTH, 1.5 + measure_gains(known, cross))
    axes = figure.add_subplot()
    draw_gain_axes(axes, known, cross)
    handles, labels = axes.get_legend_handles_labels()
    entries = dict(zip(labels, handles))
    figure.legend(
        entries.values(), entries.keys(), loc="outside lower center", ncols=1
    )
    style.set_answer(figure, _describe_gains(known))
    return figure


def measure_gains(known: Sequence[Case], cross: Cross | None = None) -> float:
    """Returns the height of the lines of draw_gain_axes() [inches]."""
    rows = {y for y, *_ in _list_gain_lines(known, cross)}
    return (0.27 if len(rows) > _MANY else 0.5) * len(rows)


def draw_gain_axes(
    axes: Axes, known: Sequence[Case], cross: Cross | None = None
) -> None:
    """Draws the gains of draw_gains() into axes, without a legend."""
    lines = _list_gain_lines(known, cross)
    for y, _, gain, color, marker, label in lines:
        _draw_interval(axes, gain, y, color, marker, label)
    for y, case in enumerate(known):
        if len(known) > 1 and len(case.pairs) > 1:
            axes.plot(
                [pair.gain.mean for pair in case.pairs],
                [y] * len(case.pairs), "|", color=style.QUIET, markersize=9,
                label="single search",
            )  # fmt: skip
    axes.axvline(0, color=style.BASELINE, linewidth=1, linestyle="--")
    ticks = {y: name for y, name, *_ in lines if name}
    axes.set_yticks([*ticks], [*ticks.values()])
    axes.set_ylim(max(ticks) + 0.5, -0.5)
    goals = {case.best.row.goals[0].name for case in known}
    quantity = style.words(goals.pop()) if len(goals) == 1 else "the objective"
    axes.set_xlabel(f"gain in {quantity} [%]")


_Line = tuple[float, str, Interval, str, str, str]
"""A mark in the figure of gains: position, name of the line, gain, colour,
marker and label."""


def _list_gain_lines(
    known: Sequence[Case], cross: Cross | None
) -> list[_Line]:
    """Returns the gain of each case. For a single case it also returns the
    gain of each search, with an interval of evaluation noise only."""
    names = short_names(known)
    lines: list[_Line] = []
    if len(known) == 1 and len(known[0].pairs) > 1:
        for search, pair in enumerate(known[0].pairs, start=1):
            gain = interval([pair.gain])
            lines.append(
                (search, f"search {search}", gain, style.QUIET, "|",
                 "single search, interval of evaluation noise only")
            )  # fmt: skip
        names = {known[0].name: "mean of searches"}
    elif len(known) == 1:
        names = {known[0].name: "single search"}
    for y, case in enumerate(known):
        lines.append(
            (y, names[case.name], case.relative_gain(), style.BEST, "o",
             OVER_BASELINE)
        )  # fmt: skip
        if elite := cross and cross.relative_gain(case, ELITE):
            lines.append(
                (y + 0.2, "", elite, style.ACCENT, "s", "over the elite plant")
            )
    return lines


def _describe_gains(known: Sequence[Case]) -> str:
    gains = [case.relative_gain() for case in known]
    if len(gains) == 1:
        return f"By {gains[0].number()} %."
    significant = sum(gain.is_sure for gain in gains)
    low, high = min(x.mean for x in gains), max(x.mean for x in gains)
    return (
        f"By {low:.1f} to {high:.1f} %. The 95 % confidence interval excludes 0 "
        f"in {significant} of {len(gains)} cases."
    )


def _draw_interval(
    axes: Axes, x: Interval, y: float, color: str, marker: str,
    label: str,
) -> None:  # fmt: skip
    axes.errorbar(
        [x.mean], [y], xerr=bars([x]),
        color=color, marker=marker, linestyle="none", label=label,
    )  # fmt: skip


def draw_energy(cases: Sequence[Case]) -> Figure:
    """Draws the parts of the incident PAR with their intervals, for the
    baseline and the best plant of each case, or of the cases with the largest
    and smallest gains. Isolated plots have a separate panel, since they also
    receive light from the sides."""
    every = select_known(cases)
    known = every
    if len(every) > _MANY:
        ranked = sorted(every, key=lambda case: case.relative_gain().mean)
        shown = [*ranked[: _MANY // 2], *ranked[-_MANY // 2 :]]
        known = [case for case in every if case in shown]
    panels = [
        [case for case in known if case.is_isolated is alone]
        for alone in (False, True)
    ]
    panels = [panel for panel in panels if panel]
    figure = style.new_figure(
        style.WIDTH, 1.6 + 0.5 * len(panels) + 0.6 * len(known)
    )
    grid = figure.subplots(
        len(panels), 1, squeeze=False, height_ratios=[*map(len, panels)]
    )
    names = short_names(known)
    for (axes,), members in zip(grid, panels):
        _draw_balance(axes, members, names)
    bars = {
        label: handle
        for (axes,) in grid
        for handle, label in zip(*axes.get_legend_handles_labels())
    }
    parts = [part for part in _PARTS if part in bars]
    figure.legend(
        [bars[part] for part in parts], parts,
        loc="outside lower center", ncols=3,
    )  # fmt: skip
    style.set_answer(figure, _describe_leaves(every))
    return figure


def _describe_leaves(known: Sequence[Case]) -> str:
    texts = []
    for who in ("best", "baseline"):
        parts = [case.number(who, "absorbed_fraction") for case in known]
        low, high = (f(100 * x.mean for x in parts) for f in (min, max))
        texts.append(
            f"{parts[0].scaled(100, '%')}"
            if len(parts) == 1
            else f"{low:.0f} to {high:.0f} %"
        )
    return (
        f"The leaves of the best plants absorb {texts[0]} of the incident PAR; "
        f"those of the baseline absorb {texts[1]}."
    )


def compute_shares(case: Case, who: str) -> dict[str, Interval]:
    """Returns parts of the incident PAR in the order of the figure. Organs
    other than leaves, stalks and sheaths are combined; the sum of their errors
    is an upper bound of the combined error."""
    parts = {"leaves": case.number(who, "absorbed_fraction")}
    for organ, share in case.light_by_organ(who).items():
        part = _ORGANS.get(organ, "other organs")
        parts[part] = share.plus(parts[part]) if part in parts else share
    for part in ("soil", "reflected"):
        parts[part] = case.number(who, f"{part}_fraction")
    return parts


def _draw_balance(
    axes: Axes, known: Sequence[Case], names: dict[str, str]
) -> None:
    ticks: list[float] = []
    labels: list[str] = []
    for i, case in enumerate(known):
        for j, who in enumerate(("baseline", "best")):
            y = i + 0.4 * j
            start = 0.0
            for part, share in compute_shares(case, who).items():
                color, hatch = _PARTS[part]
                axes.barh(
                    y, share.mean, 0.34, left=start, color=color, hatch=hatch,
                    edgecolor="white", linewidth=0.5,
                    xerr=bars([share]) if share.above > _SEEN else None,
                    error_kw={"elinewidth": 1, "capsize": 2}, label=part,
                )  # fmt: skip
                start += share.mean
            ticks.append(y)
            name = names[case.name] if len(names) > 1 else ""
            labels.append(f"{name}\n{who}" if name and not j else who)
    axes.set_yticks(ticks, labels)
    axes.set_ylim(len(known) - 0.4, -0.4)
    if known[0].is_isolated:
        axes.set_xlabel(
            "PAR in an isolated plot,\nrelative to incident PAR on its ground"
        )
    else:
        axes.set_xlim(0, 1.02)
        axes.set_xlabel("fraction of incident PAR")
    axes.grid(axis="y", visible=False)
