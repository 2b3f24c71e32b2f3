# SPDX-License-Identifier: Apache-2.0
"""Which traits matter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .case import Case
from .file import HistoryError
from .genes import Genes
from .rows import Rows, join

_ROWS_PER_PREDICTOR = 2
_SHOWN = 12
_INFLATION = 10.0
"""Variance inflation above which a coefficient is taken for collinear, as is
usual (Hair et al., Multivariate Data Analysis)."""
_NEAR_BOUND = 0.05
"""Of the range of a trait."""
_FITTEST = 10


@dataclass(frozen=True)
class Predictor:
    """A column of a regression: a gene, or the cosine or sine of a circular
    one."""

    gene: int
    wave: str = ""
    """cos, sin, or empty"""


@dataclass(frozen=True)
class Sensitivity:
    """Standardised regression of the objective on the free genes: by how
    many of its standard deviations it moves when a gene moves by one of its
    own and the others stay. A circular gene enters as cosine and sine, and
    its effect is the length of both coefficients, without a sign."""

    genes: NDArray[np.int64]
    """Their places in a genome."""
    effect: NDArray[np.float64]
    standard_error: NDArray[np.float64]
    """Of ordinary least squares; takes plants as independent, though bred
    plants are relatives."""
    explained: float
    """R2, the part of the objective's variance that the regression takes."""
    plants: int
    inflation: NDArray[np.float64]
    """Variance inflation factor, for a circular gene the larger one: by how
    much a gene that goes together with others blurs its coefficient."""
    is_clear: NDArray[np.bool_]
    """The effect can be told from those of other genes. If not, it is not
    drawn as an effect."""


def evaluated(case: Case) -> tuple[Rows, NDArray[np.int64]]:
    """All evaluated plants of all seeds, and the seed of each."""
    parts = [history.evaluations().done for history in case.histories]
    rows = join(parts)
    if not len(rows):
        raise HistoryError("no plant is evaluated yet")
    return rows, np.repeat(np.arange(len(parts)), [len(p) for p in parts])


def centred(values: NDArray, seed: NDArray) -> NDArray:
    """Less the mean of their seed, so that differences between seeds are no
    effects of genes."""
    means = [values[seed == s].mean(0) for s in range(seed.max() + 1)]
    return values - np.array(means)[seed]


def predictors(genes: Genes, rows: Rows) -> tuple[list[Predictor], NDArray]:
    """The free genes that vary, with values [rows, columns]: in their unit,
    circular ones as cosine and sine."""
    found: list[Predictor] = []
    columns: list[NDArray] = []
    for i in np.flatnonzero(genes.is_free):
        values = rows.genome[:, i]
        if genes.is_circular[i]:
            # The bounds are one point of the circle: their distance is a turn.
            angle = 2 * np.pi * values / (genes.upper[i] - genes.lower[i])
            found += [Predictor(int(i), "cos"), Predictor(int(i), "sin")]
            columns += [np.cos(angle), np.sin(angle)]
        else:
            found.append(Predictor(int(i)))
            columns.append(values)
    varies = [i for i, column in enumerate(columns) if np.ptp(column) > 1e-9]
    return [found[i] for i in varies], np.array([columns[i] for i in varies]).T


def sensitivity(case: Case) -> Sensitivity:
    """Of all evaluated plants. Raises HistoryError as regress does."""
    rows, seed = evaluated(case)
    columns, x = predictors(case.genes, rows)
    y = rows.objectives[:, 0]
    found = regress(columns, centred(x, seed), centred(y, seed))
    against = contradicted(found, case.genes, case.top(_FITTEST))
    return replace(found, is_clear=found.is_clear & ~against)


def contradicted(
    found: Sensitivity, genes: Genes, fittest: Rows
) -> NDArray[np.bool_]:
    """Effects that point away from a bound which the fittest plants hold: at
    the optimum a gene at its upper bound can't make the objective worse, nor
    can one at its lower bound make it better."""
    at = found.genes
    lower, upper = genes.lower[at], genes.upper[at]
    mean = fittest.genome[:, at].mean(0)
    place = (mean - lower) / (upper - lower)
    better = fittest.goals[0].sign * found.effect
    is_against = np.where(
        better < 0, place > 1 - _NEAR_BOUND, place < _NEAR_BOUND
    )
    return is_against & ~genes.is_circular[at]


def regress(
    columns: Sequence[Predictor], x: NDArray, y: NDArray
) -> Sensitivity:
    """Of y [plants] on the columns of x [plants, columns].

    Raises HistoryError if there are too few plants, or none differs."""
    if not columns or len(y) < _ROWS_PER_PREDICTOR * (len(columns) + 1):
        raise HistoryError(
            f"{len(y)} evaluated plants are too few for a regression on "
            f"{len(columns)} columns of traits"
        )
    if np.ptp(y) == 0:
        raise HistoryError("all plants absorb the same")
    x = (x - x.mean(0)) / x.std(0)
    y = (y - y.mean()) / y.std()
    beta, *_ = np.linalg.lstsq(x, y, rcond=None)
    rest = y - x @ beta
    variance = rest @ rest / (len(y) - len(columns) - 1)
    inverse = _inverse_diagonal(x)
    error = np.sqrt(variance * inverse)
    parts: dict[int, list[int]] = {}
    for i, column in enumerate(columns):
        parts.setdefault(column.gene, []).append(i)
    # A single coefficient keeps its sign.
    effect = [
        beta[at[0]] if len(at) == 1 else np.linalg.norm(beta[at])
        for at in parts.values()
    ]
    inflation = np.array([len(y) * inverse[at].max() for at in parts.values()])
    return Sensitivity(
        np.array([*parts]),
        np.array(effect),
        np.array([np.linalg.norm(error[at]) for at in parts.values()]),
        float(1 - rest @ rest / (y @ y)),
        len(y),
        inflation,
        inflation <= _INFLATION,
    )


def _inverse_diagonal(x: NDArray) -> NDArray:
    """Of the inverse of x' x; very large, not 0, where columns depend on
    each other."""
    _, singular, right = np.linalg.svd(x, full_matrices=False)
    singular = np.maximum(singular, 1e-8 * singular[0])
    return np.sum((right.T / singular) ** 2, axis=1)


def draw_sensitivity(case: Case) -> Figure:
    """The strongest effects with 95 % confidence intervals, and those of
    leaves by rank and trait; those that are not clear are hatched.

    Raises HistoryError if no effect is clear."""
    found = sensitivity(case)
    if not found.is_clear.any():
        raise HistoryError(
            f"the traits of its {found.plants} plants go together too closely "
            "for separate effects; a larger population or more generations "
            "would tell them apart"
        )
    has_leaves = case.genes.leaves[found.genes[found.is_clear]].any()
    figure = style.new_figure(style.WIDTH, 4.2)
    left, *rest = np.atleast_1d(figure.subplots(1, 1 + int(has_leaves)))
    clear = np.flatnonzero(found.is_clear)
    strongest = np.argsort(-np.abs(found.effect[clear]))[:_SHOWN]
    order = clear[strongest][::-1]
    left.errorbar(
        found.effect[order],
        range(len(order)),
        xerr=1.96 * found.standard_error[order],
        color=style.BEST,
        marker="o",
        linestyle="none",
    )
    left.axvline(0, color=style.BASELINE, linewidth=1, linestyle="--")
    left.set_yticks(
        range(len(order)), [case.genes.words(found.genes[i]) for i in order]
    )
    left.set_xlabel("effect in standard deviations, 95 % confidence")
    for right in rest:
        _draw_by_rank(figure, right, case.genes, found)
    figure.suptitle(
        f"{case.name}: {found.plants} plants, R² = {found.explained:.2f}",
        fontsize=10,
    )
    return figure


def _draw_by_rank(
    figure: Figure, axes: Axes, genes: Genes, found: Sensitivity
) -> None:
    at = [i for i in found.genes if genes.leaves[i]]
    traits = list(dict.fromkeys(genes.traits[i] for i in at))
    ranks = sorted({int(genes.leaves[i]) for i in at})
    table = np.full((len(ranks), len(traits)), np.nan)
    for i, effect, is_clear in zip(found.genes, found.effect, found.is_clear):
        if is_clear and genes.leaves[i]:
            row = ranks.index(genes.leaves[i])
            table[row, traits.index(genes.traits[i])] = effect
    limit = np.nanmax(np.abs(table))
    image = axes.imshow(
        table, cmap="PuOr", vmin=-limit, vmax=limit, origin="lower",
        aspect="auto",
    )  # fmt: skip
    axes.grid(visible=False)
    # seen where the image is empty
    axes.patch.set(facecolor="#E8E8E8", hatch="////", edgecolor=style.QUIET)
    axes.set_title("hatched: no separate effect", fontsize=8)
    labels = [trait.replace("_", " ") for trait in traits]
    axes.set_xticks(range(len(traits)), labels, rotation=20)
    axes.set_yticks(range(len(ranks)), [str(rank) for rank in ranks])
    axes.set_ylabel("leaf rank (1 = lowest)")
    figure.colorbar(image, label="effect (circular: size only)")
