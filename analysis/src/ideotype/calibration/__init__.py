# SPDX-License-Identifier: Apache-2.0
"""Calibrates parameters of crops and campaigns with field measurements.

`read_observations` reads a table of measurements, `read_parameters` the priors
of parameters, and `calibrate` returns their posterior distribution, a
`Calibration`. `predict`, `combinations`, `pairs` and `next_measurements` answer
questions about it. `format_draws` writes draws of the posterior or of the prior
as scenarios of a campaign."""

from .answers import (
    Predictions,
    combinations,
    decisions,
    explained_by_parameter,
    next_measurements,
    pairs,
    predict,
    stands_at,
)
from .calibration import Calibration, EmulatorCheck, calibrate
from .draws import format_draws
from .emulator import Emulator, Fit
from .likelihood import Posterior
from .model import Evaluations, Model
from .observations import Observations, make_observations, read_observations
from .parameters import (
    Parameter,
    estimates,
    read_parameters,
    read_priors,
    values_at,
)
from .sampler import Samples, find_mode, sample

__all__ = [
    "Calibration",
    "Emulator",
    "EmulatorCheck",
    "Evaluations",
    "Fit",
    "Model",
    "Observations",
    "Parameter",
    "Posterior",
    "Predictions",
    "Samples",
    "calibrate",
    "combinations",
    "decisions",
    "estimates",
    "explained_by_parameter",
    "find_mode",
    "format_draws",
    "make_observations",
    "next_measurements",
    "pairs",
    "predict",
    "read_observations",
    "read_parameters",
    "read_priors",
    "sample",
    "stands_at",
    "values_at",
]
