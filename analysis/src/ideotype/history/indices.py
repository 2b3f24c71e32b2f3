# SPDX-License-Identifier: Apache-2.0
"""The results of a sensitivity study: Sobol' indices, or elementary effects by
Morris, which SALib computes from the rows of the study; the noise of rows is
subtracted."""

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
"""Half the width of an interval of 95 % in standard errors."""
_DRAWS = {"num_resamples": 500, "seed": 1}

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Indices:
    """The dependence of a quantity on the factors of a study; unknown numbers
    are NaN."""

    quantity: str
    unit: str
    factors: tuple[str, ...]
    mean: float
    standard_deviation: float
    """The standard deviation of the quantity without noise."""
    noise: float
    """The standard deviation of noise."""
    samples: int
    """The number of samples in which no row failed."""
    index: dict[str, Floats]
    """The indices by name and factor: first and total; or mu, mu_star, sigma
    and mu_star_of_noise."""
    standard_error: dict[str, Floats]
    """The standard errors of first and total, or of mu_star, by bootstrap over
    samples."""

    @property
    def main(self) -> Floats:
        """The index that ranks factors: total, or mu_star."""
        return self.index["total" if "total" in self.index else "mu_star"]


class _Design(NamedTuple):
    """The rows of a study."""

    is_sobol: bool
    levels: int
    factors: tuple[str, ...]
    problem: dict[str, Any]
    """The problem as SALib has it: a variable for each free gene, a group for
    each factor."""
    points: Floats
    """The points [samples, rows of a sample, free genes], 0 to 1 in the ranges
    of genes."""


def indices_of(history: History) -> dict[str, Indices]:
    """Computes the indices of all quantities that are single numbers, by name;
    the dict is empty if the history holds no sensitivity study, or the study
    is not finished yet.

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
    found = {}
    for name in dict.fromkeys(names):
        quantity = rows[name]
        shape = design.points.shape[:2]
        values = quantity.values.reshape(shape)
        noise = quantity.standard_error.reshape(shape) ** 2
        found[name] = _analyse(name, quantity.unit, design, values, noise)
    return found


def _design(history: History, genomes: Floats) -> _Design:
    settings = history.resolved["sensitivity"]
    genes, free = history.genes, history.genes.is_free
    by_gene = settings["groups"] == "gene"
    of = np.array(genes.names if by_gene else genes.traits)[free].tolist()
    factors = tuple(dict.fromkeys(of))
    is_sobol = settings["method"] == "sobol"
    size = len(factors) + (2 if is_sobol else 1)
    width = (genes.upper - genes.lower)[free]
    points = (genomes[:, free] - genes.lower[free]) / width
    problem = {
        "num_vars": len(of),
        "names": [f"x{i}" for i in range(len(of))],
        "groups": of,
        "bounds": [[0, 1]] * len(of),
    }
    return _Design(
        is_sobol,
        settings["levels"],
        factors,
        problem,
        points.reshape(-1, size, len(of)),
    )


def _analyse(
    name: str, unit: str, design: _Design, values: Floats, noise: Floats
) -> Indices:
    """Computes the indices of the samples that have all rows.

    `values` and the variances of their noise are [samples, rows]."""
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
        {each: index.get(each, empty) for each in names},
        {each: errors.get(each, empty) for each in names},
    )


def _sobol(
    design: _Design, y: Floats, noise: Floats
) -> tuple[dict[str, Floats], dict[str, Floats]]:
    """Computes first-order indices by Saltelli et al. 2010
    (doi:10.1016/j.cpc.2009.09.018) and total indices by Jansen 1999
    (doi:10.1016/S0010-4655(98)00154-4), and their standard errors. Rows have
    independent noise, whose variance is in the variance of the rows and in the
    squared differences of a total index, but not in the products of a
    first-order index."""
    from SALib.analyze import sobol

    found = sobol.analyze(
        design.problem, y.ravel(), calc_second_order=False, **_DRAWS
    )
    variance = y[:, [0, -1]].var()
    scale = variance / (variance - noise[:, [0, -1]].mean())
    of_pairs = (noise[:, :1] + noise[:, 1:-1]).mean(0) / 2 / variance
    return {
        "first": scale * found["S1"],
        "total": scale * (found["ST"] - of_pairs),
    }, {
        "first": scale * found["S1_conf"] / NORMAL,
        "total": scale * found["ST_conf"] / NORMAL,
    }


def _morris(
    design: _Design, points: Floats, y: Floats, noise: Floats
) -> tuple[dict[str, Floats], dict[str, Floats]]:
    """Computes elementary effects over the whole range of a factor (Morris
    1991, doi:10.1080/00401706.1991.10484804, Campolongo et al. 2007,
    doi:10.1016/j.envsoft.2006.10.004), and the standard error of mu_star; the
    variance of noise is subtracted from the variance of effects."""
    from SALib.analyze import morris

    found = morris.analyze(
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
        # The genes of a factor may step in different directions.
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
    index["mu_star"] = np.asarray(found["mu_star"], float)
    error = np.asarray(found["mu_star_conf"], float) / NORMAL
    return index, {"mu_star": error}
