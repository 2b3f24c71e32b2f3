# SPDX-License-Identifier: Apache-2.0
"""Which traits go together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pandas
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .case import Case
from .file import HistoryError
from .genes import Genes
from .rows import Rows, join


@dataclass(frozen=True)
class Column:
    """A column of the table: a gene, or the cosine or sine of a circular
    one."""

    gene: int
    wave: str = ""
    """cos, sin, or empty"""


def evaluated(case: Case) -> tuple[Rows, NDArray[np.int64]]:
    """All evaluated plants of all seeds, and the seed of each."""
    parts = [history.evaluations().done for history in case.histories]
    rows = join(parts)
    if not len(rows):
        raise HistoryError("no plant is evaluated yet")
    return rows, np.repeat(np.arange(len(parts)), [len(p) for p in parts])


def centred(values: NDArray, seed: NDArray) -> NDArray:
    """Less the mean of their seed, so that differences between seeds correlate
    nothing."""
    means = [values[seed == s].mean(0) for s in range(seed.max() + 1)]
    return values - np.array(means)[seed]


def columns_of(genes: Genes, rows: Rows) -> tuple[list[Column], NDArray]:
    """The free genes that vary, with values [rows, columns]: in their unit,
    circular ones as cosine and sine."""
    found: list[Column] = []
    columns: list[NDArray] = []
    for i in np.flatnonzero(genes.is_free):
        values = rows.genome[:, i]
        if genes.is_circular[i]:
            # The bounds are one point of the circle: their distance is a turn.
            angle = 2 * np.pi * values / (genes.upper[i] - genes.lower[i])
            found += [Column(int(i), "cos"), Column(int(i), "sin")]
            columns += [np.cos(angle), np.sin(angle)]
        else:
            found.append(Column(int(i)))
            columns.append(values)
    varies = [i for i, column in enumerate(columns) if np.ptp(column) > 1e-9]
    return [found[i] for i in varies], np.array([columns[i] for i in varies]).T


def rank_correlation(x: NDArray) -> NDArray:
    """Spearman's, between the columns of x [plants, columns]; equal values
    share their mean rank."""
    return pandas.DataFrame(x).corr(method="spearman").to_numpy()


def draw_correlation(case: Case) -> Figure:
    """Spearman's rank correlation between the free traits of all evaluated
    plants; circular ones as cosine and sine."""
    rows, seed = evaluated(case)
    columns, x = columns_of(case.genes, rows)
    if len(columns) < 2:
        raise HistoryError("fewer than two traits vary")
    kinds = [_kind(case, column) for column in columns]
    blocks = list(dict.fromkeys(kinds))
    order = sorted(range(len(kinds)), key=lambda i: blocks.index(kinds[i]))
    table = rank_correlation(centred(x, seed)[:, order])
    figure = style.new_figure(7.2, 6.6)
    axes = figure.add_subplot()
    image = axes.imshow(table, cmap="PuOr", vmin=-1, vmax=1)
    axes.grid(visible=False)
    kinds = [kinds[i] for i in order]
    starts = [i for i, k in enumerate(kinds) if i == 0 or kinds[i - 1] != k]
    for start in starts[1:]:
        axes.axhline(start - 0.5, color=style.BASELINE, linewidth=0.8)
        axes.axvline(start - 0.5, color=style.BASELINE, linewidth=0.8)
    ends = [*starts[1:], len(kinds)]
    middles = [(a + b - 1) / 2 for a, b in zip(starts, ends)]
    numbers = [case.genes.number(columns[i].gene) for i in order]
    # A trait of the plant is a block of one, which has its name in small.
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


def _kind(case: Case, column: Column) -> str:
    """ "cos azimuth" or "insertion angle"."""
    trait = case.genes.traits[column.gene].replace("_", " ")
    return f"{column.wave} {trait}".strip()
