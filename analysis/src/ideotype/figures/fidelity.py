# SPDX-License-Identifier: Apache-2.0
"""Draws the measurements of `ideotype fidelity`: speed against accuracy."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure

from . import style


def draw_fidelity(measured: dict[str, Any]) -> Figure:
    """Draws error against cost of each key alone, and of combinations of
    keys."""
    figure = style.new_figure(style.WIDTH, 3.4)
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    groups = {
        "one key": [row for rows in measured["keys"] for row in rows],
        "keys together": [r for r in measured["settings"] if r["settings"]],
        "the campaign": [r for r in measured["settings"] if not r["settings"]],
    }
    titles = {
        "value": "one canopy",
        "difference": "difference of two canopies",
    }
    for axes, (quantity, title) in zip(panels, titles.items(), strict=True):
        for index, (label, rows) in enumerate(groups.items()):
            color, marker = style.series(index)
            errors = [
                [100 * x for x in row[quantity]["error"]] for row in rows
            ]
            axes.errorbar(
                [1e3 * row["seconds"] for row in rows],
                [mean for mean, _ in errors],
                style.half_width([error for _, error in errors]),
                color=color,
                marker=marker,
                linestyle="",
                label=label,
            )
        axes.axhline(100 * measured["tolerance"], color=style.QUIET)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(title)
        axes.set_xlabel("cost of one evaluation [ms]")
    panels[0].set_ylabel(f"error [% of {measured['objective']}]")
    panels[0].legend()
    return figure
