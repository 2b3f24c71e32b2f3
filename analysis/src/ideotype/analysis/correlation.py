# SPDX-License-Identifier: Apache-2.0
"""Draws which traits go together."""

from __future__ import annotations

import numpy as np
import pandas
from matplotlib.figure import Figure

from . import style
from .case import Case
from .file import HistoryError
from .rows import join


def columns_of(case: Case) -> pandas.DataFrame:
    """Returns the free genes that vary, of all evaluated plants, by the number
    of the gene and its wave. They are in their unit, or cos and sin of
    circular ones, less the mean of their seed, so that differences between
    seeds do not correlate traits.

    Raises HistoryError if no plant is evaluated."""
    parts = [history.evaluations().done for history in case.histories]
    genome, genes = join(parts).genome, case.genes
    if not len(genome):
        raise HistoryError("no plant is evaluated yet")
    columns = {}
    for i in np.flatnonzero(genes.is_free).tolist():
        if genes.is_circular[i]:
            # The bounds are one point of the circle: the distance between them
            # is a turn.
            turn = 2 * np.pi / (genes.upper[i] - genes.lower[i])
            columns[i, "cos"] = np.cos(turn * genome[:, i])
            columns[i, "sin"] = np.sin(turn * genome[:, i])
        else:
            columns[i, ""] = genome[:, i]
    varying = {k: x for k, x in columns.items() if np.ptp(x) > 1e-9}
    if len(varying) < 2:
        raise HistoryError("fewer than two traits vary")
    table = pandas.DataFrame(varying)
    seed = np.repeat(np.arange(len(parts)), [len(part) for part in parts])
    return table - table.groupby(seed).transform("mean")


def draw_correlation(case: Case) -> Figure:
    """Draws Spearman's rank correlation between the free traits of all
    evaluated plants; circular ones are there as cosine and sine."""
    columns = columns_of(case)
    names = [
        f"{wave} {case.genes.traits[gene]}".strip().replace("_", " ")
        for gene, wave in columns
    ]
    blocks = list(dict.fromkeys(names))
    order = sorted(range(len(names)), key=lambda i: blocks.index(names[i]))
    table = columns.iloc[:, order].corr(method="spearman")
    figure = style.new_figure(7.2, 6.6)
    axes = figure.add_subplot()
    image = axes.imshow(table, cmap="PuOr", vmin=-1, vmax=1)
    axes.grid(visible=False)
    kinds = [names[i] for i in order]
    starts = [i for i, k in enumerate(kinds) if i == 0 or kinds[i - 1] != k]
    for start in starts[1:]:
        axes.axhline(start - 0.5, color=style.BASELINE, linewidth=0.8)
        axes.axvline(start - 0.5, color=style.BASELINE, linewidth=0.8)
    ends = [*starts[1:], len(kinds)]
    middles = [(a + b - 1) / 2 for a, b in zip(starts, ends)]
    numbers = [case.genes.number(gene) for gene, _ in table]
    # A trait of the plant is a block of one, which has its name in small
    # print.
    labels = [kinds[start] if numbers[start] else "" for start in starts]
    ranks = [str(number or kind) for number, kind in zip(numbers, kinds)]
    for axis in (axes.xaxis, axes.yaxis):
        # A block's name stays where it meets a leaf's number.
        axis.remove_overlapping_locs = False
        axis.set_ticks(middles, labels)
        axis.set_ticks(range(len(ranks)), ranks, minor=True, fontsize=5)
        axis.set_tick_params(which="minor", length=1.5, pad=1)
        axis.set_tick_params(which="major", length=0, pad=11)
    axes.tick_params(axis="x", which="both", labelrotation=90)
    axes.set_title(
        f"{case.name}\n"
        "numbers are leaf ranks or points of profiles, 1 = lowest"
    )
    figure.colorbar(image, label="Spearman's rank correlation", shrink=0.8)
    return figure
