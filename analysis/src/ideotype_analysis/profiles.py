"""Where and when the leaves absorb: by hour, leaf rank and height."""

from __future__ import annotations

import re

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from . import style
from .case import Case
from .file import HistoryError
from .rows import Evaluation, HourProfile, LeafProfile

PLANTS = (
    ("baseline", style.BASELINE, "D", "--"),
    ("best", style.BEST, "o", "-"),
)


def families(plant: Evaluation, ending: str) -> list[str]:
    """First words of the diagnostics <words>_<ending>, in their order, such
    as "absorbed" of absorbed_leaf01; the ending is a regular expression."""
    found = plant.row.diagnostics.matching(rf"(.+)_{ending}")
    return list(dict.fromkeys(match[1] for match, _ in found))


def draw_hours(case: Case) -> Figure:
    """PAR absorbed by leaves at each hour, and best minus baseline. The error
    of the difference takes both as independent. Parts of the light, such as
    beam and sky, get a panel each if the history has them."""
    case.need_pairs()
    names = families(case.best, r"hour_\d\d_\d\d")
    if not names:
        raise HistoryError("the history has no figures by hour")
    figure = style.new_figure(max(6.4, 3.6 * len(names)), 5.2)
    grid = figure.subplots(
        2, len(names), sharex=True, height_ratios=(2, 1), squeeze=False
    )
    for (upper, lower), name in zip(grid.T, names):
        _draw_hours(upper, lower, case, name)
    kind = "" if case.best_pair.is_final else "provisional "
    gain = case.best_pair.gain.number().replace("+-", "±")
    figure.suptitle(
        f"{case.name}: {kind}gain over the day {gain} %", fontsize=10
    )
    return figure


def _draw_hours(upper: Axes, lower: Axes, case: Case, name: str) -> None:
    baseline, best = case.baseline.by_hour(name), case.best.by_hour(name)
    for profile, (label, color, marker, line) in zip((baseline, best), PLANTS):
        upper.errorbar(
            profile.hours,
            profile.values,
            profile.standard_error,
            color=color,
            marker=marker,
            markersize=3.5,
            linestyle=line,
            label=f"{label} ± standard error",
        )
    lower.axhline(0, color=style.QUIET, linewidth=1)
    lower.errorbar(
        best.hours,
        best.values - baseline.values,
        np.hypot(best.standard_error, baseline.standard_error),
        color=style.BEST,
        marker="o",
        markersize=3.5,
    )
    unit = style.unit_label(best.unit)
    words = "absorbed PAR" if name == "absorbed" else name.replace("_", " ")
    upper.set_ylabel(f"{words} [{unit} ground]")
    lower.set_ylabel(f"best − baseline\n[{unit}]")
    lower.set_xlabel("local clock time [h]")
    _set_hours(lower, best)
    upper.set_ylim(bottom=0)
    upper.legend()


def _set_hours(axes: Axes, profile: HourProfile) -> None:
    first, last = np.floor(profile.hours.min()), np.ceil(profile.hours.max())
    step = max(1, round((last - first) / 14))
    axes.set_xticks(np.arange(first, last + 1, step))


def draw_leaves(case: Case) -> Figure:
    """Diagnostics by leaf rank, such as absorbed PAR: baseline and best with
    standard errors, a panel each."""
    case.need_pairs()
    names = families(case.best, r"leaf\d+")
    if not names:
        raise HistoryError("the history has no figures by leaf rank")
    figure = style.new_figure(max(4.8, 3.4 * len(names)), 4.2)
    panels = figure.subplots(1, len(names), sharey=True, squeeze=False)[0]
    for axes, name in zip(panels, names):
        _draw_ranks(
            axes, case.baseline.by_leaf(name), case.best.by_leaf(name), name
        )
    panels[0].set_ylabel("leaf rank (1 = lowest)")
    panels[0].legend(fontsize=8)
    figure.suptitle(case.name, fontsize=10)
    return figure


def draw_layers(case: Case) -> Figure:
    """Diagnostics by height layer, lowest first, as by leaf rank."""
    case.need_pairs()
    names = families(case.best, r"layer\d+")
    if not names:
        raise HistoryError("the history has no figures by height layer")
    figure = style.new_figure(max(4.8, 3.4 * len(names)), 4.2)
    panels = figure.subplots(1, len(names), sharey=True, squeeze=False)[0]
    for axes, name in zip(panels, names):
        pattern = rf"{re.escape(name)}_layer(\d+)"
        _draw_ranks(
            axes,
            case.baseline.by_number(pattern),
            case.best.by_number(pattern),
            name,
        )
    panels[0].set_ylabel("height layer (lowest first)")
    panels[0].legend(fontsize=8)
    figure.suptitle(case.name, fontsize=10)
    return figure


def _draw_ranks(
    axes: Axes, baseline: LeafProfile, best: LeafProfile, name: str
) -> None:
    for profile, (label, color, marker, line) in zip((baseline, best), PLANTS):
        axes.errorbar(
            profile.values,
            profile.leaves,
            xerr=profile.standard_error,
            color=color,
            marker=marker,
            markersize=4,
            linestyle=line,
            label=f"{label} ± standard error",
        )
    words = "absorbed PAR" if name == "absorbed" else name
    axes.set_xlabel(style.axis_label(words, best.unit))
    axes.set_yticks(best.leaves)
    axes.set_xlim(left=min(0, axes.get_xlim()[0]))
