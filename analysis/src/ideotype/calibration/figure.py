# SPDX-License-Identifier: Apache-2.0
"""Draws prior and posterior, and predicted and measured values."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure
from scipy.stats import norm

from ..figures import style
from .answers import Predictions
from .calibration import Calibration

_COLUMNS = 3


def draw_posterior(calibration: Calibration) -> Figure:
    """Draws the prior density and the posterior samples of each parameter."""
    parameters, values = calibration.parameters, calibration.values
    lines = math.ceil(len(parameters) / _COLUMNS)
    figure = style.new_figure(style.WIDTH * 1.6, 2.2 * lines)
    panels = figure.subplots(lines, _COLUMNS, squeeze=False).ravel()
    for axes, parameter, column in zip(panels, parameters, values.T):
        axes.hist(column, bins=40, density=True, color=style.BEST, alpha=0.6,
                  label="posterior")  # fmt: skip
        if parameter.is_uniform:
            low, high = parameter.low, parameter.high
        else:
            low = max(parameter.low, parameter.mean - 3 * parameter.deviation)
            high = min(
                parameter.high, parameter.mean + 3 * parameter.deviation
            )
        x = np.linspace(low, high, 200)
        # z is standard normal, so the density of the value is that of z times
        # dz / dx.
        z = parameter.z(x)
        with np.errstate(invalid="ignore"):
            density = norm.pdf(z) * np.gradient(z, x)
        if parameter.is_uniform:
            density = np.full(x.size, 1 / (high - low))
        axes.plot(x, density, color=style.BASELINE, label="prior")
        axes.set_xlabel(parameter.key)
        axes.set_yticks([])
    for axes in panels[len(parameters) :]:
        axes.set_visible(False)
    panels[0].legend()
    return figure


def draw_predictions(predictions: Predictions) -> Figure:
    """Draws computed over measured values of each quantity, with 90 %
    intervals of the computed values."""
    table = predictions.table[predictions.table.measured.notna()]
    names = list(dict.fromkeys(table.quantity))
    lines = max(math.ceil(len(names) / _COLUMNS), 1)
    figure = style.new_figure(style.WIDTH * 1.6, 2.6 * lines)
    panels = figure.subplots(lines, _COLUMNS, squeeze=False).ravel()
    for axes, name in zip(panels, names):
        rows = table[table.quantity == name]
        for held, color, label in (
            (False, style.BEST, "fitted"),
            (True, style.ACCENT, "held out"),
        ):
            part = rows[rows.is_held_out == held]
            if len(part):
                axes.errorbar(
                    part.measured, part["mean"],
                    [part["mean"] - part.low, part.high - part["mean"]],
                    1.645 * part.error, fmt="o", color=color, label=label,
                )  # fmt: skip
        axes.scatter(
            rows.measured, rows.before, marker="x", color=style.QUIET,
            label="before",
        )  # fmt: skip
        axes.axline((rows.measured.mean(),) * 2, slope=1, color=style.QUIET,
                    linewidth=0.8)  # fmt: skip
        axes.set_xlabel(f"measured {name} [{rows.unit.iloc[0]}]")
        axes.set_ylabel("computed")
    for axes in panels[len(names) :]:
        axes.set_visible(False)
    if names:
        panels[0].legend()
    return figure
