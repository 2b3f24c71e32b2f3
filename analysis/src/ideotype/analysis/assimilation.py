# SPDX-License-Identifier: Apache-2.0
"""What leaves make of light: assimilation by hour and leaf, and how much of
them the sun shines on."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from . import style
from .case import Case
from .file import HistoryError
from .profiles import PLANTS, Looks, set_hours
from .quantity import Profile

_SUNLIT = "sunlit_lai_by_hour"
_BY_HOUR = "assimilation_by_hour"
_BY_LEAF = {"gross": "assimilation_by_leaf", "net": "net_assimilation_by_leaf"}


def draw_sunlit(case: Case) -> Figure:
    """Sunlit over all leaf area by hour [%], baseline and best.

    Raises HistoryError if the history does not tell it."""
    case.need_pairs()
    figure = style.new_figure(5.4, 3.2)
    axes = figure.add_subplot()
    for plant, looks in zip((case.baseline, case.best), PLANTS):
        share = 100 / plant.estimate("lai").mean
        _draw_hours(axes, plant.profile(_SUNLIT), looks, share)
    axes.set_ylabel("sunlit part of the leaf area [%]")
    axes.set_ylim(bottom=0)
    axes.legend(fontsize=8)
    figure.suptitle(case.name, fontsize=10)
    return figure


def draw_assimilation(case: Case) -> Figure:
    """Gross assimilation by hour above, gross and net by leaf rank below, as
    far as the history tells them; baseline and best.

    Raises HistoryError if it tells none."""
    case.need_pairs()
    known = case.best.row.quantities
    by_leaf = {kind: n for kind, n in _BY_LEAF.items() if n in known}
    has_hours = _BY_HOUR in known
    count = has_hours + bool(by_leaf)
    if not count:
        raise HistoryError("the history has no assimilation by leaf or hour")
    figure = style.new_figure(5.4, 0.8 + 3.0 * count)
    panels = list(figure.subplots(count, 1, squeeze=False)[:, 0])
    pair = (case.baseline, case.best)
    if has_hours:
        axes = panels.pop(0)
        for plant, looks in zip(pair, PLANTS):
            _draw_hours(axes, plant.profile(_BY_HOUR), looks)
        unit = style.unit_label(known[_BY_HOUR].unit).replace("umol", "µmol")
        axes.set_ylabel(f"gross assimilation\n[{unit} of ground]")
        axes.set_ylim(bottom=0)
        axes.legend(fontsize=8)
    for axes in panels:
        for plant, looks in zip(pair, PLANTS):
            for kind, name in by_leaf.items():
                _draw_leaves(axes, plant.profile(name), looks, kind)
        unit = style.unit_label(known[next(iter(by_leaf.values()))].unit)
        axes.set_xlabel(f"assimilation [{unit} of ground]")
        axes.set_ylabel("leaf rank (1 = lowest)")
        axes.set_xlim(left=min(0, axes.get_xlim()[0]))
        axes.legend(fontsize=8)
    figure.suptitle(case.name, fontsize=10)
    return figure


def _draw_hours(
    axes: Axes, found: Profile, looks: Looks, scale: float = 1.0
) -> None:
    label, color, marker, line = looks
    axes.errorbar(
        found.labels, scale * found.values, scale * found.standard_error,
        color=color, marker=marker, markersize=3.5, linestyle=line,
        label=label,
    )  # fmt: skip
    set_hours(axes, found)


def _draw_leaves(axes: Axes, found: Profile, looks: Looks, kind: str) -> None:
    label, color, marker, line = looks
    axes.errorbar(
        found.values, found.labels, xerr=found.standard_error,
        color=color, marker=marker, markersize=4, linestyle=line,
        alpha=1.0 if kind == "gross" else 0.55,
        fillstyle="full" if kind == "gross" else "none",
        label=f"{label}, {kind}",
    )  # fmt: skip
    axes.set_yticks(found.labels)
