"""Which traits matter."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .case import Case
from .file import HistoryError
from .rows import Rows, join
from .traits import Traits

_ROWS_PER_PREDICTOR = 2
_SHOWN = 12
_INFLATION = 10.0
"""Variance inflation above which a coefficient is taken for collinear, as is
usual (Hair et al., Multivariate Data Analysis)."""
_NEAR_BOUND = 0.05
"""Of the range of a trait."""
_FITTEST = 10


@dataclass(frozen=True)
class Sensitivity:
    """Standardised regression of the objective on the free traits: by how
    many of its standard deviations it moves when a trait moves by one of its
    own and the others stay. A circular trait enters as cosine and sine, and
    its effect is the length of both coefficients, without a sign."""

    traits: tuple[str, ...]
    effect: NDArray[np.float64]
    standard_error: NDArray[np.float64]
    """Of ordinary least squares; takes plants as independent, though bred
    plants are relatives."""
    explained: float
    """R2, the part of the objective's variance that the regression takes."""
    plants: int
    inflation: NDArray[np.float64]
    """Variance inflation factor, for a circular trait the larger one: by how
    much a trait that goes together with others blurs its coefficient."""
    is_clear: NDArray[np.bool_]
    """The effect can be told from those of other traits. If not, it is not
    drawn as an effect."""


def evaluated(case: Case) -> Rows:
    """All evaluated plants of all seeds."""
    rows = join([history.evaluations().done for history in case.histories])
    if not len(rows):
        raise HistoryError("no plant is evaluated yet")
    return rows


def predictors(traits: Traits, rows: Rows) -> tuple[list[str], NDArray]:
    """Names and values [rows, columns] of the free traits that vary: in
    their unit, circular ones as cosine and sine, "cos leaf01_azimuth"."""
    names: list[str] = []
    columns: list[NDArray] = []
    for i in np.flatnonzero(traits.is_free):
        name, values = traits.names[i], rows.traits.values[:, i]
        if traits.is_circular[i]:
            # The bounds are one point of the circle: their distance is a turn.
            turn = traits.upper[i] - traits.lower[i]
            angle = 2 * np.pi * values / turn
            names += [f"cos {name}", f"sin {name}"]
            columns += [np.cos(angle), np.sin(angle)]
        else:
            names.append(name)
            columns.append(values)
    varies = [i for i, column in enumerate(columns) if np.ptp(column) > 1e-9]
    return [names[i] for i in varies], np.array([columns[i] for i in varies]).T


def sensitivity(case: Case) -> Sensitivity:
    """Of all evaluated plants. Raises HistoryError as regress does."""
    rows = evaluated(case)
    names, x = predictors(case.traits, rows)
    found = regress(names, x, rows.objectives.values[:, 0])
    against = contradicted(found, case.traits, case.top(_FITTEST))
    return replace(found, is_clear=found.is_clear & ~against)


def contradicted(
    found: Sensitivity, traits: Traits, fittest: Rows
) -> NDArray[np.bool_]:
    """Effects that point away from a bound which the fittest plants hold: at
    the optimum a trait at its upper bound can't have a negative effect, nor
    one at its lower bound a positive one."""
    at = [traits.names.index(name) for name in found.traits]
    lower, upper = traits.lower[at], traits.upper[at]
    mean = fittest.traits.values[:, at].mean(0)
    place = (mean - lower) / (upper - lower)
    is_against = np.where(
        found.effect < 0, place > 1 - _NEAR_BOUND, place < _NEAR_BOUND
    )
    return is_against & ~traits.is_circular[at]


def regress(names: Sequence[str], x: NDArray, y: NDArray) -> Sensitivity:
    """Of y [plants] on the columns of x [plants, names], named as predictors
    names them.

    Raises HistoryError if there are too few plants, or none differs."""
    if not names or len(y) < _ROWS_PER_PREDICTOR * (len(names) + 1):
        raise HistoryError(
            f"{len(y)} evaluated plants are too few for a regression on "
            f"{len(names)} columns of traits"
        )
    if np.ptp(y) == 0:
        raise HistoryError("all plants absorb the same")
    x = (x - x.mean(0)) / x.std(0)
    y = (y - y.mean()) / y.std()
    beta, *_ = np.linalg.lstsq(x, y, rcond=None)
    rest = y - x @ beta
    variance = rest @ rest / (len(y) - len(names) - 1)
    inverse = _inverse_diagonal(x)
    error = np.sqrt(variance * inverse)
    parts: dict[str, list[int]] = {}
    for i, name in enumerate(names):
        parts.setdefault(name.split(" ")[-1], []).append(i)
    # A single coefficient keeps its sign.
    effect = [
        beta[at[0]] if len(at) == 1 else np.linalg.norm(beta[at])
        for at in parts.values()
    ]
    inflation = np.array(
        [len(y) * inverse[at].max() for at in parts.values()]
    )
    return Sensitivity(
        tuple(parts),
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
    """The strongest effects with 95 % confidence intervals, and all of them
    by leaf rank and kind of trait; those that are not clear are hatched.

    Raises HistoryError if no effect is clear."""
    found = sensitivity(case)
    if not found.is_clear.any():
        raise HistoryError(
            f"the traits of its {found.plants} plants go together too closely "
            "for separate effects; a larger population or more generations "
            "would tell them apart"
        )
    figure = style.new_figure(style.WIDTH, 4.2)
    left, right = figure.subplots(1, 2)
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
        range(len(order)), [_words(found.traits[i]) for i in order]
    )
    left.set_xlabel("effect in standard deviations, 95 % confidence")
    _draw_by_rank(figure, right, found)
    figure.suptitle(
        f"{case.name}: {found.plants} plants, R² = {found.explained:.2f}",
        fontsize=10,
    )
    return figure


def _words(trait: str) -> str:
    """ "azimuth of leaf 3" of "leaf03_azimuth"."""
    match = re.fullmatch(r"leaf(\d+)_(.+)", trait)
    return f"{match[2]} of leaf {int(match[1])}" if match else trait


def _draw_by_rank(figure: Figure, axes: Axes, found: Sensitivity) -> None:
    shown = np.where(found.is_clear, found.effect, np.nan)
    effects = dict(zip(found.traits, shown))
    places = [re.fullmatch(r"leaf(\d+)_(.+)", name) for name in found.traits]
    kinds = list(dict.fromkeys(m[2] for m in places if m))
    ranks = sorted({int(m[1]) for m in places if m})
    table = np.array(
        [
            [effects.get(f"leaf{rank:02}_{kind}", np.nan) for kind in kinds]
            for rank in ranks
        ]
    )
    limit = np.nanmax(np.abs(table))
    image = axes.imshow(
        table, cmap="PuOr", vmin=-limit, vmax=limit, origin="lower",
        aspect="auto",
    )  # fmt: skip
    axes.grid(visible=False)
    # seen where the image is empty
    axes.patch.set(facecolor="#E8E8E8", hatch="////", edgecolor=style.QUIET)
    axes.set_title("hatched: no separate effect", fontsize=8)
    labels = [kind.replace("_", " ") for kind in kinds]
    axes.set_xticks(range(len(kinds)), labels, rotation=20)
    axes.set_yticks(range(len(ranks)), [str(rank) for rank in ranks])
    axes.set_ylabel("leaf rank (1 = lowest)")
    figure.colorbar(image, label="effect (azimuth: size only)")
