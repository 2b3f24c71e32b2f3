# SPDX-License-Identifier: Apache-2.0
"""Calibrates parameters with measurements: mode and posterior."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib.metadata import version
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.special import ndtri
from scipy.stats import qmc

from ..errors import Error
from ..validation.table import Measurement
from .emulator import Emulator
from .likelihood import Compute, Posterior
from .model import Evaluations, Model
from .observations import Observations
from .parameters import Parameter, values_at
from .sampler import Samples, find_mode, sample

Numbers = NDArray[np.float64]

ROUNDS = 2
"""How often an emulator is refined near the posterior."""
CHECKS = 16
"""The points of the posterior at which an emulator is checked each time."""


@dataclass(frozen=True)
class EmulatorCheck:
    """An emulator compared with direct evaluations at points of the posterior
    that it was not made from."""

    error: Numbers
    """Root mean square of the differences [rows]."""
    relative: float
    """The largest `error` of the rows in the likelihood over their standard
    deviation without a discrepancy."""


@dataclass(frozen=True)
class Calibration:
    """A posterior distribution of parameters."""

    observations: Observations
    parameters: list[Parameter]
    model: Model
    posterior: Posterior
    mode: Numbers
    """The most probable values of the parameters [parameters]."""
    samples: Samples
    own_error: Numbers
    """Standard error of one evaluation of the program [rows]."""
    emulator: Emulator | None
    """None: the program was evaluated at each point."""
    checks: list[EmulatorCheck] = field(default_factory=list)

    @property
    def values(self) -> Numbers:
        """Samples of the posterior [samples, parameters]."""
        return values_at(self.parameters, self.samples.z)

    @property
    def discrepancies(self) -> Numbers:
        """Samples of the discrepancy of each quantity [samples, quantities]."""
        return self.posterior.discrepancies(self.samples.z)

    def choose(self, count: int) -> NDArray[np.intp]:
        """Returns the indices of evenly spaced samples [draws]."""
        chosen = np.linspace(0, len(self.samples.z) - 1, count)
        return np.round(chosen).astype(np.intp)

    def draws(self, count: int) -> Numbers:
        """Returns evenly spaced samples [draws, parameters]."""
        return self.values[self.choose(count)]

    def table(self) -> pd.DataFrame:
        """Returns one row for each sample: parameters, `discrepancy.QUANTITY`
        in the unit of the rows, and log_density."""
        columns = {p.key: x for p, x in zip(self.parameters, self.values.T)}
        for name, x in zip(self.posterior.quantities, self.discrepancies.T):
            columns[f"discrepancy.{name}"] = x
        return pd.DataFrame(
            columns | {"log_density": self.samples.log_density}
        )

    def summary(self) -> pd.DataFrame:
        """Returns one row for each parameter: prior, mode, mean, standard
        deviation, 5 and 95 % quantiles, `shrinkage` (1 less the variance of z
        over that of the prior), R-hat and autocorrelation time."""
        values = self.values
        low, high = np.quantile(values, [0.05, 0.95], axis=0)
        size = len(self.parameters)
        return pd.DataFrame(
            {
                "parameter": [p.key for p in self.parameters],
                "prior": [p.describe() for p in self.parameters],
                "mode": self.mode,
                "mean": values.mean(axis=0),
                "deviation": values.std(axis=0),
                "low": low,
                "high": high,
                "shrinkage": 1 - self.samples.z[:, :size].var(axis=0),
                "r_hat": self.samples.r_hat[:size],
                "autocorrelation": self.samples.autocorrelation[:size],
            }
        )

    def rows_at(self, values: Numbers) -> Numbers:
        """Returns the computed rows at values of the parameters
        [points, rows]."""
        return self.posterior.compute(values)


def calibrate(
    observations: Observations,
    parameters: Sequence[Parameter],
    *,
    evaluations: Path | None = None,
    seed: int = 1,
    emulates: bool = True,
    design: int | None = None,
    most_steps: int = 20_000,
    has_discrepancy: bool = True,
) -> Calibration:
    """Returns the posterior of parameters, given measurements.

    evaluations: CSV file in which all evaluations are kept; a repeated call
        continues with it.
    seed: seed of the design, the sampler and the program. The result has the
        same bits for the same seed on any number of processors.
    emulates: whether to replace the program by an emulator. Without one the
        sampler needs tens of thousands of evaluations until it converges.
    design: evaluations from which the emulator is made first.
    most_steps: largest number of steps of the sampler, after which it ends
        even if it has not converged.
    has_discrepancy: whether the discrepancy of each quantity is estimated.

    Raises Error if nothing can be computed or sampled."""
    if not parameters:
        raise Error(
            "there is no parameter to calibrate; give priors, or a crop file "
            "with estimates that state a range (# E: LOW to HIGH)"
        )
    stored = Evaluations(
        evaluations, _describe(observations, parameters, seed)
    )
    model = Model(observations, parameters, stored, seed)
    middle = values_at(parameters, np.zeros(len(parameters)))
    own_error = model.own_errors(middle)
    if not np.isfinite(own_error).all():
        raise Error(
            "rows cannot be computed in the middle of the priors; correct the "
            "priors, or the rows"
        )
    checks: list[EmulatorCheck] = []
    emulator: Emulator | None = None
    if emulates and observations.rows:
        emulator, checks = _emulate(
            model, own_error, design, seed, has_discrepancy
        )
        posterior = _posterior(
            model, _by_emulator(emulator, parameters),
            own_error**2 + emulator.error**2, has_discrepancy,
        )  # fmt: skip
    else:
        posterior = _posterior(
            model, model.evaluate, own_error**2, has_discrepancy
        )
    mode = find_mode(posterior, posterior.size, seed, 100 if emulates else 25)
    samples = sample(
        posterior,
        posterior.size,
        seed,
        ensembles=4 if emulates else 2,
        block=500 if emulates else 100,
        most=most_steps,
    )
    return Calibration(
        observations,
        list(parameters),
        model,
        posterior,
        values_at(parameters, mode[: len(parameters)]),
        samples,
        own_error,
        emulator,
        checks,
    )


def _describe(
    observations: Observations, parameters: Sequence[Parameter], seed: int
) -> str:
    """Returns the line that identifies the evaluations of a calibration: a
    digest of all that decides about them."""
    conditions = observations.conditions
    about = [
        version("ideotype"),
        conditions.stand(
            conditions.settings(dict(observations.keys)), seed
        ).campaign,
        [_row(row) for row in observations.rows],
        [repr(p) for p in parameters],
    ]
    digest = hashlib.sha256(json.dumps(about).encode()).hexdigest()
    return f"# ideotype calibrate, evaluations of {digest[:16]}"


def _row(row: Measurement) -> str:
    return repr([row.quantity, row.unit, row.date, row.hours, row.height,
                 row.position, row.leaves, dict(row.keys)])  # fmt: skip


def scale_values(parameters: Sequence[Parameter], values: Numbers) -> Numbers:
    """Returns values on the scale of emulators [points, parameters]."""
    columns = [p.scaled(values[:, i]) for i, p in enumerate(parameters)]
    return np.stack(columns, axis=1)


def _by_emulator(
    emulator: Emulator, parameters: Sequence[Parameter]
) -> Compute:
    return lambda values: emulator(scale_values(parameters, values))


def _posterior(
    model: Model, compute: Compute, variance: Numbers, has_discrepancy: bool
) -> Posterior:
    return Posterior(
        model.parameters, model.observations, compute, variance,
        has_discrepancy=has_discrepancy,
    )  # fmt: skip


def design_points(
    parameters: Sequence[Parameter], count: int, seed: int
) -> Numbers:
    """Returns points spread over the prior, within its central 98 % [points,
    parameters]: a Latin hypercube."""
    cube = qmc.LatinHypercube(len(parameters), seed=seed).random(count)
    return values_at(parameters, ndtri(0.01 + 0.98 * cube))


def usual_design(parameters: int) -> int:
    """Returns the usual number of evaluations of a first design: 1.6 times the
    terms of a full quadratic."""
    return math.ceil(1.6 * (parameters + 1) * (parameters + 2) / 2) + 5


def _emulate(
    model: Model,
    own_error: Numbers,
    design: int | None,
    seed: int,
    has_discrepancy: bool,
) -> tuple[Emulator, list[EmulatorCheck]]:
    """Makes an emulator, and refines it with evaluations at points of the
    posterior, which first check it."""
    parameters = model.parameters
    count = design or usual_design(len(parameters))
    points = design_points(parameters, count, seed)
    rows = model.evaluate(points, about="design")
    emulator = Emulator.make(scale_values(parameters, points), rows)
    checks: list[EmulatorCheck] = []
    for number in range(ROUNDS + 1):
        posterior = _posterior(
            model, _by_emulator(emulator, parameters),
            own_error**2 + emulator.error**2, has_discrepancy,
        )  # fmt: skip
        samples = sample(
            posterior, posterior.size, seed + number, ensembles=2, block=400,
            most=1200, samples=CHECKS,
        )  # fmt: skip
        near = values_at(parameters, samples.z[:, : len(parameters)])
        direct = model.evaluate(near, about=f"check {number + 1}")
        checks.append(_check(emulator, parameters, near, direct, posterior))
        if number == ROUNDS:
            break
        points, rows = np.vstack([points, near]), np.vstack([rows, direct])
        emulator = Emulator.make(
            scale_values(parameters, points), rows, near=len(rows) - count
        )
    # The last check is independent of the emulator: its error counts.
    return emulator.with_error(
        np.maximum(checks[-1].error, emulator.error)
    ), checks


def _check(
    emulator: Emulator,
    parameters: Sequence[Parameter],
    points: Numbers,
    direct: Numbers,
    posterior: Posterior,
) -> EmulatorCheck:
    error = np.sqrt(
        np.nanmean(
            (emulator(scale_values(parameters, points)) - direct) ** 2, axis=0
        )
    )
    fitted = posterior.observations.is_fitted
    ratio = error[fitted] / posterior.known_deviation
    return EmulatorCheck(error, float(ratio.max(initial=0)))
