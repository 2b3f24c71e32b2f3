# SPDX-License-Identifier: Apache-2.0
"""What a sensitivity study found: Sobol' indices, or elementary effects by
Morris."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .datasets import Datasets
from .file import HistoryError

if TYPE_CHECKING:
    from .case import Case

GROUP = "sensitivity"
_SOBOL = ("first", "total")
_MORRIS = ("mu_star", "sigma")
_SHOWN = 15
_LABELS = {
    "first": "first order",
    "total": "total",
    "mu_star": "mean size μ*",
    "sigma": "standard deviation σ",
}


@dataclass(frozen=True)
class Indices:
    """How a quantity depends on the factors of a study; NaN is not known."""

    quantity: str
    unit: str
    factors: tuple[str, ...]
    mean: float
    standard_deviation: float
    """Without that of noise."""
    noise: float
    """Standard deviation of noise."""
    samples: int
    """Of which no row failed."""
    index: dict[str, NDArray[np.float64]]
    """first and total by factor; or mu, mu_star, sigma, mu_star_of_noise."""
    standard_error: dict[str, NDArray[np.float64]]


def read_indices(data: Datasets) -> dict[str, Indices]:
    """By quantity; none if the history is of no sensitivity study, or that is
    not finished yet."""
    if GROUP not in data.names("/") or not data.read("state/finished"):
        return {}

    def read(name: str) -> NDArray:
        return data.read(f"{GROUP}/{name}")

    suffix = "_standard_error"
    names = [
        name.removesuffix(suffix)
        for name in data.names(GROUP)
        if name.endswith(suffix)
    ]
    index = {name: read(name) for name in names}
    error = {name: read(name + suffix) for name in names}
    numbers = ("mean", "standard_deviation", "noise_standard_deviation")
    mean, deviation, noise, samples = map(read, (*numbers, "samples"))
    factors = tuple(data.texts(f"{GROUP}/factor"))
    units = data.texts(f"{GROUP}/unit")
    return {
        quantity: Indices(
            quantity,
            units[i],
            factors,
            float(mean[i]),
            float(deviation[i]),
            float(noise[i]),
            int(samples[i]),
            {name: values[i] for name, values in index.items()},
            {name: values[i] for name, values in error.items()},
        )
        for i, quantity in enumerate(data.texts(f"{GROUP}/quantity"))
    }


def draw_indices(case: Case) -> Figure:
    """Bars of the factors that matter most to the first objective, with
    95 % intervals, of the first seed.

    Raises HistoryError if the study is not finished, or tells nothing."""
    history = case.histories[0]
    name = history.objectives[0].name
    found = history.sensitivity().get(name)
    if found is None:
        raise HistoryError("the sensitivity study is not finished yet")
    shown = _SOBOL if "total" in found.index else _MORRIS
    main = found.index["total" if "total" in found.index else "mu_star"]
    if not np.isfinite(main).any():
        raise HistoryError(f"{style.words(name)} varies by no more than noise")
    order = np.argsort(-np.nan_to_num(main, nan=-np.inf))[:_SHOWN][::-1]
    figure = style.new_figure(style.WIDTH, 1.3 + 0.32 * len(order))
    axes = figure.subplots()
    height = 0.8 / len(shown)
    for i, index in enumerate(shown):
        color, _ = style.series(i)
        axes.barh(
            np.arange(len(order)) + height * (0.5 - i),
            found.index[index][order],
            height,
            xerr=1.96 * found.standard_error[index][order],
            color=color,
            label=_LABELS[index],
            error_kw={"capsize": 2},
        )
    if shown == _MORRIS:
        axes.axvline(
            float(np.nanmax(found.index["mu_star_of_noise"])),
            color=style.BASELINE,
            linewidth=1,
            linestyle="--",
            label="μ* of noise alone",
        )
    axes.axvline(0, color=style.BASELINE, linewidth=1)
    axes.set_yticks(
        range(len(order)), [found.factors[k].replace("_", " ") for k in order]
    )
    axes.grid(visible=False, axis="y")
    axes.set_xlabel(
        f"share of the variance of {style.words(name)}, 95 % intervals"
        if shown == _SOBOL
        else f"change of {style.axis_label(name, found.unit)} over the range"
    )
    axes.legend(loc="lower right")
    figure.suptitle(
        f"{case.name}: {found.samples} samples, "
        f"{found.mean:.4g} ± {found.standard_deviation:.2g} "
        f"{style.unit_label(found.unit)} (standard deviation)",
        fontsize=10,
    )
    return figure
