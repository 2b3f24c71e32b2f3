# SPDX-License-Identifier: Apache-2.0
"""Answers that follow from a posterior: predictions with intervals, parameters
that only act together, and the measurement to make next."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.special import ndtri

from ..common.processors import processors
from ..errors import Error
from ..stand.stand import Stand
from ..validation.page import describe_conditions
from .calibration import Calibration
from .model import Evaluations, Model
from .observations import Observations
from .parameters import Parameter, settings_at

Numbers = NDArray[np.float64]
Decision = Callable[[Stand], float]

STRONG = 0.8
"""The correlation of two parameters above which they are named as a pair."""


def rows_as_stated(observations: Observations, seed: int = 1) -> Numbers:
    """Returns the rows with the crop and the campaign as their files state
    them [rows]."""
    model = Model(observations, [], Evaluations(None), seed)
    return model.evaluate(np.zeros((1, 0)))[0]


@dataclass(frozen=True)
class Predictions:
    """Computed rows under a posterior."""

    table: pd.DataFrame
    """One row for each row of the table: at, quantity, unit, measured, error,
    is_fitted, is_held_out, before (as files state the parameters), mean, low
    and high (90 % interval of the computed value), and lowest and highest (of
    a measurement: with its error and the discrepancy)."""

    failed: int = 0
    """The number of draws that could not be computed, and are left out."""

    def errors(self, of: str = "is_fitted") -> pd.DataFrame:
        """Returns the root mean square error by quantity before and after
        calibration, its change, and the fraction of measurements inside their
        90 % interval.

        of: name of the column that chooses rows."""
        lines = []
        chosen = self.table[self.table[of]]
        for (name, unit), part in chosen.groupby(
            ["quantity", "unit"], sort=False
        ):
            inside = (part.high_measured >= part.lowest) & (
                part.low_measured <= part.highest
            )
            lines.append(
                {
                    "quantity": name,
                    "unit": unit,
                    "rows": len(part),
                    "before": _rms(part.before - part.measured),
                    "after": _rms(part["mean"] - part.measured),
                    "inside": inside.mean(),
                }
            )
        columns = ["quantity", "unit", "rows", "before", "after", "inside"]
        return pd.DataFrame(lines, columns=columns)


def _rms(numbers: pd.Series) -> float:
    return float(np.sqrt((numbers**2).mean()))


def predict(
    calibration: Calibration,
    observations: Observations | None = None,
    draws: int = 400,
    evaluations: Evaluations | None = None,
) -> Predictions:
    """Returns predictions of rows.

    observations: rows of any campaign, by default those of the calibration.
        Another campaign is evaluated at each draw.
    draws: samples of the posterior.

    Raises Error if more than half of the draws cannot be computed."""
    values = calibration.draws(draws)
    own = calibration.observations
    rows = observations or own
    if observations is None:
        computed = calibration.rows_at(values)
    else:
        model = Model(
            rows, calibration.parameters, evaluations or Evaluations(None),
            calibration.model.seed,
        )  # fmt: skip
        computed = model.evaluate(values, about="prediction")
    is_known = np.isfinite(computed).all(axis=1)
    if 2 * is_known.sum() < draws:
        raise Error(
            f"only {is_known.sum()} of {draws} draws of the posterior can be "
            "computed; narrow the priors"
        )
    computed = computed[is_known]
    deviation = _deviations(
        calibration, rows, calibration.choose(draws)[is_known]
    )
    # Measurements at quantiles of their error, evenly spread over draws.
    random = np.random.default_rng(calibration.model.seed)
    count = len(computed)
    order = random.permuted(
        np.tile((np.arange(count) + 0.5) / count, (len(rows.rows), 1)), axis=1
    ).T
    measured = computed + deviation * ndtri(order)
    low, high = np.quantile(computed, [0.05, 0.95], axis=0)
    lowest, highest = np.quantile(measured, [0.05, 0.95], axis=0)
    return Predictions(
        pd.DataFrame(
            {
                "at": [describe_conditions(row) for row in rows.rows],
                "quantity": [row.quantity for row in rows.rows],
                "unit": [row.unit for row in rows.rows],
                "measured": rows.value,
                "low_measured": rows.low,
                "high_measured": rows.high,
                "error": rows.error,
                "is_fitted": rows.is_fitted,
                "is_held_out": rows.is_held_out,
                "before": rows_as_stated(rows, calibration.model.seed),
                "mean": computed.mean(axis=0),
                "low": low,
                "high": high,
                "lowest": lowest,
                "highest": highest,
            }
        ),
        draws - count,
    )


def _deviations(
    calibration: Calibration, rows: Observations, chosen: NDArray[np.intp]
) -> Numbers:
    """Returns the standard deviation of a measurement of each row, from its
    error and the discrepancy of its quantity in the chosen samples
    [draws, rows]."""
    scales = calibration.discrepancies[chosen]
    names = calibration.posterior.quantities
    deviation = np.tile(rows.error, (len(chosen), 1))
    for i, row in enumerate(rows.rows):
        if row.quantity in names:
            scale = scales[:, names.index(row.quantity)]
            deviation[:, i] = np.hypot(deviation[:, i], scale)
    return deviation


def combinations(calibration: Calibration) -> pd.DataFrame:
    """Returns the directions in which the posterior is narrower than the
    prior, narrowest first: the eigenvectors of the covariance of z, which is
    the identity a priori. `variance` is that over the prior's; the columns of
    parameters are the shares (squared loadings) of each."""
    size = len(calibration.parameters)
    covariance = np.cov(calibration.samples.z[:, :size].T).reshape(size, size)
    variances, vectors = np.linalg.eigh(covariance)
    table = pd.DataFrame({"variance": variances})
    for i, parameter in enumerate(calibration.parameters):
        table[parameter.key] = vectors[i] ** 2
    return table


def pairs(calibration: Calibration) -> pd.DataFrame:
    """Returns the pairs of parameters that the data only determine together:
    their correlation in the posterior is above 0.8, and each alone is less
    certain than with the other one known."""
    size = len(calibration.parameters)
    z = calibration.samples.z[:, :size]
    correlation = np.corrcoef(z.T).reshape(size, size)
    lines = [
        {
            "first": calibration.parameters[i].key,
            "second": calibration.parameters[j].key,
            "correlation": correlation[i, j],
            "deviation": z[:, i].std(),
            "deviation_if_known": z[:, i].std()
            * np.sqrt(1 - correlation[i, j] ** 2),
        }
        for i in range(size)
        for j in range(i + 1, size)
        if abs(correlation[i, j]) > STRONG
    ]
    columns = [
        "first", "second", "correlation", "deviation", "deviation_if_known",
    ]  # fmt: skip
    return pd.DataFrame(lines, columns=columns)


def decisions(stands: Sequence[Stand], decision: Decision) -> Numbers:
    """Returns a decision's number in each stand."""
    with ThreadPoolExecutor(processors()) as pool:
        return np.array(list(pool.map(decision, stands)))


def stands_at(
    observations: Observations,
    parameters: Sequence[Parameter],
    values: Numbers,
    seed: int = 1,
) -> list[Stand]:
    """Returns the stand of the campaign with each draw of the parameters.

    values: [draws, parameters]."""
    conditions = observations.conditions
    return [
        conditions.stand(
            conditions.settings(
                {**observations.keys, **settings_at(parameters, point)}
            ),
            seed,
        )
        for point in values
    ]


def next_measurements(
    calibration: Calibration, values: Numbers, numbers: Numbers
) -> pd.DataFrame:
    """Returns the measurements that could be made, best first, with the
    expected shrinkage of the variance of a decision.

    A measurement y with the standard error e and the discrepancy d of its
    quantity explains cov(D, y)^2 / (var(y) + e^2 + d^2) of the variance of D
    (the pre-posterior variance of a linear Gaussian model, Lindley 1956,
    doi:10.1214/aoms/1177728069). The squared correlation is adjusted for the
    number of draws.

    values: draws of the parameters [draws, parameters].
    numbers: number of the decision at each draw [draws]."""
    rows = calibration.observations
    computed = calibration.rows_at(values)
    names = calibration.posterior.quantities
    squares = (calibration.discrepancies**2).mean(axis=0)
    lines = []
    for i in np.flatnonzero(rows.is_candidate):
        row = rows.rows[i]
        noise = rows.error[i] ** 2
        if row.quantity in names:
            noise += squares[names.index(row.quantity)]
        y = computed[:, i]
        explained = adjusted_square(y, numbers)
        lines.append(
            {
                "quantity": row.quantity,
                "at": describe_conditions(row),
                "error": rows.error[i],
                "unit": row.unit,
                "shrinkage": explained * y.var() / (y.var() + noise),
            }
        )
    columns = ["quantity", "at", "error", "unit", "shrinkage"]
    table = pd.DataFrame(lines, columns=columns)
    return table.sort_values("shrinkage", ascending=False, ignore_index=True)


def explained_by_parameter(
    calibration: Calibration, values: Numbers, numbers: Numbers
) -> pd.DataFrame:
    """Returns the fraction of the variance of a decision that each parameter
    alone explains (squared correlation, adjusted), largest first."""
    table = pd.DataFrame(
        {
            "parameter": [p.key for p in calibration.parameters],
            "share": [adjusted_square(x, numbers) for x in values.T],
        }
    )
    return table.sort_values("share", ascending=False, ignore_index=True)


def adjusted_square(x: Numbers, y: Numbers) -> float:
    """Returns the squared correlation, adjusted for the number of pairs, and 0
    or more."""
    if x.std() == 0 or y.std() == 0:
        return 0.0
    square = float(np.corrcoef(x, y)[0, 1] ** 2)
    count = len(x)
    return max(0.0, 1 - (1 - square) * (count - 1) / (count - 2))
