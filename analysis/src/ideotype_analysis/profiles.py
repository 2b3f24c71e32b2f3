"""Where and when the leaves absorb: by hour, leaf rank and height."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .case import Case
from .file import HistoryError
from .photons import label_light
from .rows import Evaluation, HourProfile

Looks = tuple[str, str, str, str]
"""Label, colour, marker, line."""

PLANTS: tuple[Looks, Looks] = (
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
    names = _names(case, r"hour_\d\d_\d\d", "hour")
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
    label_light(upper, "y", _title(name), best.unit)
    lower.set_ylabel(style.axis_label("best − baseline\n", best.unit))
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
    names = _names(case, r"leaf\d+", "leaf rank")
    figure, panels = _panels(case, len(names))
    for axes, name in zip(panels, names):
        for plant, looks in zip((case.baseline, case.best), PLANTS):
            leaf = plant.by_leaf(name)
            _draw(axes, leaf.values, leaf.standard_error, leaf.leaves, looks)
            axes.set_yticks(leaf.leaves)
        label_light(axes, "x", _title(name), leaf.unit)
        axes.set_xlim(left=min(0, axes.get_xlim()[0]))
    panels[0].set_ylabel("leaf rank (1 = lowest)")
    panels[0].legend(fontsize=8)
    return figure


def draw_layers(case: Case) -> Figure:
    """Diagnostics by height above the soil, as by leaf rank; points are at
    the middle of their layers."""
    names = _names(case, r"layer_\d+_\d+cm", "height layer")
    figure, panels = _panels(case, len(names))
    for axes, name in zip(panels, names):
        for plant, looks in zip((case.baseline, case.best), PLANTS):
            layer = plant.by_layer(name)
            middle = (layer.lower + layer.upper) / 2
            _draw(axes, layer.values, layer.standard_error, middle, looks)
        label_light(axes, "x", _title(name), layer.unit)
        axes.set_xlim(left=min(0, axes.get_xlim()[0]))
        axes.set_ylim(bottom=0)
    panels[0].set_ylabel("height above the soil [m]")
    panels[0].legend(fontsize=8)
    return figure


def draw_parts(case: Case) -> Figure:
    """Absorbed PAR by origin, face of the leaf, or whatever a diagnostic
    absorbed_<word> in the objective's unit tells apart."""
    case.need_pairs()
    unit = case.best.objective.unit
    table = case.best.row.diagnostics
    names = [
        match[0]
        for match, i in table.matching(r"absorbed_[a-z]+")
        if table.units[i] == unit
    ]
    if not names:
        raise HistoryError("the history does not tell parts of the light")
    figure, (axes,) = _panels(case, 1, 1.6 + 0.45 * len(names))
    place = np.arange(len(names))
    for plant, looks, shift in zip(
        (case.baseline, case.best), PLANTS, (-0.15, 0.15)
    ):
        parts = [plant.estimate(name) for name in names]
        _draw(
            axes,
            np.array([part.mean for part in parts]),
            np.array([part.standard_error for part in parts]),
            place + shift,
            (*looks[:3], "none"),
        )
    words = [name.removeprefix("absorbed_") for name in names]
    axes.set_yticks(place, words)
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.set_xlim(left=0)
    label_light(axes, "x", _title("absorbed"), unit)
    axes.legend(fontsize=8)
    return figure


def _names(case: Case, ending: str, what: str) -> list[str]:
    case.need_pairs()
    names = families(case.best, ending)
    if not names:
        raise HistoryError(f"the history has no figures by {what}")
    return names


def _panels(
    case: Case, count: int, height: float = 4.2
) -> tuple[Figure, NDArray]:
    figure = style.new_figure(max(5.2, 3.4 * count), height)
    panels = figure.subplots(1, count, sharey=True, squeeze=False)[0]
    figure.suptitle(case.name, fontsize=10)
    return figure, panels


def _draw(
    axes: Axes, x: NDArray, error: NDArray, y: NDArray, looks: Looks
) -> None:
    label, color, marker, line = looks
    axes.errorbar(
        x,
        y,
        xerr=error,
        color=color,
        marker=marker,
        markersize=4,
        linestyle=line,
        label=f"{label} ± standard error",
    )


def _title(name: str) -> str:
    return "absorbed PAR" if name == "absorbed" else name
