# SPDX-License-Identifier: Apache-2.0
"""The results of a sensitivity study: Sobol' indices, or elementary effects
(Morris). SALib computes them from the rows of the study; the noise variance of
rows is subtracted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .file import HistoryError
from .history import History

SOBOL = ("first", "total")
MORRIS = ("mu_star", "sigma")
OF_NOISE = "mu_star_of_noise"
NORMAL = 1.959963984540054
"""The half-width of a 95 % confidence interval in standard errors."""
_DRAWS = {"num_resamples": 500, "seed": 1}

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Indices:
    """The sensitivity of a quantity to the factors of a study; unknown numbers
    are NaN."""

    quantity: str
    unit: str
    factors: tuple[str, ...]
    mean: float
    standard_deviation: float
    """The standard deviation of the quantity without noise."""
    noise: float
    """The standard deviation of the noise of a row."""
    samples: int
    """The number of samples without failed rows."""
    index: dict[str, Floats]
    """The indices by name [factors]: first and total; or mu, mu_star, sigma
    and mu_star_of_noise."""
    standard_error: dict[str, Floats]
    """The standard errors of first and total, or of mu_star [factors], by
    bootstrap over samples."""

    @property
    def main(self) -> Floats:
        """The index by which factors are ranked: total, or mu_star."""
        return self.index["total" if "total" in self.index else "mu_star"]


class _Design(NamedTuple):
    """The rows of a study."""

    is_sobol: bool
    levels: int
    factors: tuple[str, ...]
    problem: dict[str, Any]
    """The problem in the form of SALib: a variable for each free gene, a group
    for each factor."""
    points: Floats
    """The points [samples, rows of a sample, free genes], scaled to 0 .. 1 by
    the ranges of genes."""


def indices_of(history: History) -> dict[str, Indices]:
    """Computes the indices of all quantities without axes, by name. The result
    is empty unless the history is a finished sensitivity study.

    Raises HistoryError if SALib is not installed."""
    if not history.is_sensitivity or not history.state().finished:
        return {}
    try:
        import SALib  # noqa: F401
    except ImportError as error:
        raise HistoryError(
            "indices need SALib, which is not installed; run "
            "pip install 'SALib>=1.5'"
        ) from error
    rows = history.evaluations()
    design = _design(history, rows.genome)
    names = [objective.name for objective in history.objectives]
    names += [name for name, q in rows.quantities.items() if q.axis is None]
    indices = {}
    for name in dict.fromkeys(names):
        quantity = rows[name]
        shape = design.points.shape[:2]
        values = quantity.values.reshape(shape)
        noise = quantity.standard_error.reshape(shape) ** 2
        indices[name] = _analyse(name, quantity.unit, design, values, noise)
    return indices


def _design(history: History, genomes: Floats) -> _Design:
    settings = history.resolved["sensitivity"]
    genes, free = history.genes, history.genes.is_free
    by_gene = settings["groups"] == "gene"
    groups = np.array(genes.names if by_gene else genes.traits)[free].tolist()
    factors = tuple(dict.fromkeys(groups))
    is_sobol = settings["method"] == "sobol"
    size = len(factors) + (2 if is_sobol else 1)
    width = (genes.upper - genes.lower)[free]
    points = (genomes[:, free] - genes.lower[free]) / width
    problem = {
        "num_vars": len(groups),
        "names": [f"x{i}" for i in range(len(groups))],
        "groups": groups,
        "bounds": [[0, 1]] * len(groups),
    }
    return _Design(
        is_sobol,
        settings["levels"],
        factors,
        problem,
        points.reshape(-1, size, len(groups)),
    )


def _analyse(
    name: str, unit: str, design: _Design, values: Floats, noise: Floats
) -> Indices:
    """Computes the indices from the samples without failed rows. values,
    noise: values and their noise variances [samples, rows]."""
    known = np.isfinite(values + noise).all(1)
    samples = int(known.sum())
    y, noise = values[known], noise[known]
    if not samples:
        y = noise = np.full((1, values.shape[1]), np.nan)
    ends = [0, -1] if design.is_sobol else slice(None)
    error, variance = noise[:, ends].mean(), y[:, ends].var()
    index: dict[str, Floats] = {}
    errors: dict[str, Floats] = {}
    # Rounding makes even constant quantities vary.
    varies = variance - error > (1e-12 * y.mean()) ** 2
    if design.is_sobol and samples > 1 and varies:
        index, errors = _sobol(design, y, noise)
    elif not design.is_sobol and samples > 1:
        index, errors = _morris(design, design.points[known], y, noise)
    empty = np.full(len(design.factors), np.nan)
    names = SOBOL if design.is_sobol else ("mu", *MORRIS, OF_NOISE)
    return Indices(
        name,
        unit,
        design.factors,
        float(y.mean()),
        float(np.sqrt(np.maximum(0, variance - error))),
        float(np.sqrt(error)),
        samples,
        {key: index.get(key, empty) for key in names},
        {key: errors.get(key, empty) for key in names},
    )


def _sobol(
    design: _Design, y: Floats, noise: Floats
) -> tuple[dict[str, Floats], dict[str, Floats]]:
    """Computes first-order indices (Saltelli et al. 2010,
    doi:10.1016/j.cpc.2009.09.018), total indices (Jansen 1999,
    doi:10.1016/S0010-4655(98)00154-4) and their standard errors. Rows have
    independent noise. Its variance inflates the variance of the rows and the
    squared differences of a total index, but not the products of a first-order
    index."""
    from SALib.analyze import sobol

    estimates = sobol.analyze(
        design.problem, y.ravel(), calc_second_order=False, **_DRAWS
    )
    variance = y[:, [0, -1]].var()
    scale = variance / (variance - noise[:, [0, -1]].mean())
    of_pairs = (noise[:, :1] + noise[:, 1:-1]).mean(0) / 2 / variance
    return {
        "first": scale * estimates["S1"],
        "total": scale * (estimates["ST"] - of_pairs),
    }, {
        "first": scale * estimates["S1_conf"] / NORMAL,
        "total": scale * estimates["ST_conf"] / NORMAL,
    }


def _morris(
    design: _Design, points: Floats, y: Floats, noise: Floats
) -> tuple[dict[str, Floats], dict[str, Floats]]:
    """Computes elementary effects over the whole range of a factor (Morris
    1991, doi:10.1080/00401706.1991.10484804; Campolongo et al. 2007,
    doi:10.1016/j.envsoft.2006.10.004) and the standard error of mu_star. The
    noise variance is subtracted from the variance of effects; |N(0, s2)| has
    the mean sqrt(2 s2 / pi), which mu_star_of_noise states."""
    from SALib.analyze import morris

    estimates = morris.analyze(
        design.problem,
        points.reshape(-1, points.shape[2]),
        y.ravel(),
        num_levels=design.levels,
        **_DRAWS,
    )
    step = design.levels / (2 * (design.levels - 1))
    groups = np.array(design.problem["groups"])
    rows = []
    for factor in design.factors:
        genes = groups == factor
        change = np.diff(points[:, :, genes], axis=1)
        sample, row = np.nonzero((change != 0).any(2))
        # The genes of a factor may be changed in different directions.
        is_one = genes.sum() == 1
        sign = np.sign(change[sample, row, 0]) if is_one else 1
        effects = sign * np.diff(y, axis=1)[sample, row] / step
        spread = (noise[:, 1:] + noise[:, :-1])[sample, row] / step**2
        rows.append(
            (
                effects.mean() if is_one else np.nan,
                np.sqrt(max(0.0, effects.var(ddof=1) - spread.mean())),
                np.sqrt(2 * spread / np.pi).mean(),
            )
        )
    index = dict(zip(("mu", "sigma", OF_NOISE), np.array(rows).T))
    index["mu_star"] = np.asarray(estimates["mu_star"], float)
    error = np.asarray(estimates["mu_star_conf"], float) / NORMAL
    return index, {"mu_star": error}
