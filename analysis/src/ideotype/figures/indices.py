# SPDX-License-Identifier: Apache-2.0
"""Draws the indices of a sensitivity study."""

from __future__ import annotations

import numpy as np
import pandas
from matplotlib.figure import Figure

from ..history.case import Case
from ..history.file import HistoryError
from ..history.indices import MORRIS, NORMAL, OF_NOISE, SOBOL, indices_of
from . import style

_SHOWN = 15
_LABELS = {
    "first": "first order",
    "total": "total",
    "mu_star": "mean absolute effect μ*",
    "sigma": "standard deviation σ",
}


def draw_indices(case: Case) -> Figure:
    """Draws bars of the factors that matter most to the first objective, with
    95 % intervals, for the first seed.

    Raises HistoryError if the study is not finished or has no indices."""
    history = case.histories[0]
    name = history.objectives[0].name
    indices = indices_of(history).get(name)
    if indices is None:
        raise HistoryError("the sensitivity study is not finished yet")
    shown = SOBOL if "total" in indices.index else MORRIS
    main = indices.main
    if not np.isfinite(main).any():
        raise HistoryError(
            f"the variation of {style.words(name)} does not exceed noise"
        )
    order = np.argsort(-np.nan_to_num(main, nan=-np.inf))[:_SHOWN][::-1]
    figure = style.new_figure(style.WIDTH, 1.3 + 0.32 * len(order))
    axes = figure.subplots()
    labels = [style.words(indices.factors[k]) for k in order]
    bars, errors = (
        pandas.DataFrame({_LABELS[x]: of[x][order] for x in shown}, labels)
        for of in (indices.index, indices.standard_error)
    )
    bars.plot.barh(
        ax=axes, xerr=NORMAL * errors, width=0.8, capsize=2,
        color=[style.series(i)[0] for i in range(len(shown))],
    )  # fmt: skip
    if shown == MORRIS:
        axes.axvline(
            float(np.nanmax(indices.index[OF_NOISE])),
            color=style.BASELINE,
            linewidth=1,
            linestyle="--",
            label="μ* of noise alone",
        )
    axes.axvline(0, color=style.BASELINE, linewidth=1)
    axes.grid(visible=False, axis="y")
    axes.set_xlabel(
        f"fraction of the variance of {style.words(name)}, 95 % confidence intervals"
        if shown == SOBOL
        else f"change of {style.axis_label(name, indices.unit)} over the range"
    )
    axes.legend(loc="lower right")
    first = style.words(indices.factors[order[-1]])
    style.set_answer(
        figure,
        f"Mainly on {first} ({indices.samples} samples; mean {indices.mean:.4g}, "
        f"standard deviation {indices.standard_deviation:.2g} "
        f"{style.unit_label(indices.unit)}).",
    )
    return figure
