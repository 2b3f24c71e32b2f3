"""The light of the day, best against baseline."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from . import style
from .file import HistoryError
from .history import History


def draw_hours(history: History) -> Figure:
    """PAR absorbed by leaves at each hour, and best minus baseline. The error
    of the difference takes both as independent."""
    pair = history.comparison()
    if pair is None:
        raise HistoryError("baseline and best are not evaluated yet")
    baseline, best = pair.baseline.by_hour(), pair.best.by_hour()
    if not len(baseline.hours):
        raise HistoryError("the history has no figures by hour")
    figure = style.new_figure(6.4, 5.2)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
    for profile, color, marker, line, label in (
        (baseline, style.BASELINE, "D", "--", "baseline"),
        (best, style.BEST, "o", "-", "best"),
    ):
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
    error = np.hypot(best.standard_error, baseline.standard_error)
    lower.axhline(0, color=style.QUIET, linewidth=1)
    lower.errorbar(
        best.hours,
        best.values - baseline.values,
        error,
        color=style.BEST,
        marker="o",
        markersize=3.5,
    )
    unit = style.unit_label(best.unit)
    upper.set_ylabel(f"absorbed PAR [{unit} ground]")
    lower.set_ylabel(f"best − baseline\n[{unit}]")
    lower.set_xlabel("local clock time [h]")
    first, last = np.floor(best.hours.min()), np.ceil(best.hours.max())
    lower.set_xticks(np.arange(first, last + 1))
    upper.set_ylim(bottom=0)
    upper.legend()
    case = history.attributes.get("case", history.path.stem)
    kind = "" if pair.is_final else "provisional "
    gain = pair.gain.number().replace("+-", "±")
    upper.set_title(f"{case}: {kind}gain over the day {gain} %")
    return figure
