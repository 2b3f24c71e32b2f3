# SPDX-License-Identifier: Apache-2.0
"""Finds the mode of a density and samples from it.

The mode is found by the CMA-ES of `ideotype.Search`, and samples by the
affine-invariant ensemble sampler of emcee (Foreman-Mackey and others 2013,
doi:10.1086/670067). Several independent ensembles begin at points of the prior;
their agreement is the evidence of convergence."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import Error
from ..search.search import Search

Numbers = NDArray[np.float64]
Density = Callable[[Numbers], Numbers]

LARGEST_R_HAT = 1.01
"""The R-hat below which samples have converged (Vehtari and others 2021,
doi:10.1214/20-BA1221)."""
FEWEST_TIMES = 50
"""The fewest autocorrelation times that a chain must be long."""

_NO_DENSITY = (
    "no point of the prior has a probability; widen the errors, or correct the "
    "priors"
)


@dataclass(frozen=True)
class Samples:
    """Samples of a density, and their convergence."""

    z: Numbers
    """[samples, dimensions], after burn-in and thinning."""
    log_density: Numbers
    """[samples]."""
    r_hat: Numbers
    """Split R-hat between independent ensembles [dimensions]."""
    autocorrelation: Numbers
    """Integrated autocorrelation time [steps, by dimension]."""
    steps: int
    """Steps of each ensemble."""
    evaluations: int
    """Number of evaluated points."""
    chained: int
    """Number of points of all chains after burn-in, before thinning."""

    @property
    def effective_size(self) -> float:
        """The effective number of samples of the slowest dimension."""
        return float(self.chained / self.autocorrelation.max())

    @property
    def has_converged(self) -> bool:
        """Whether R-hat is small enough and chains are long enough."""
        return bool(
            self.r_hat.max() <= LARGEST_R_HAT
            and self.steps >= FEWEST_TIMES * self.autocorrelation.max()
        )


def find_mode(
    density: Density, size: int, seed: int, generations: int = 100
) -> Numbers:
    """Returns the point of the highest density [dimensions].

    Raises Error if no point has a density."""
    search = Search(
        np.full(size, -4.0),
        np.full(size, 4.0),
        start=np.zeros(size),
        optimizer="cma_es",
        population=8 + 2 * size,
        seed=seed,
    )
    best: Numbers | None = None
    highest = -np.inf
    for _ in range(generations):
        points = search.ask()
        values = density(points)
        search.tell(np.where(np.isfinite(values), values, np.nan))
        if np.max(values) > highest:
            best, highest = points[np.argmax(values)].copy(), np.max(values)
    if best is None:
        raise Error(_NO_DENSITY)
    return best


def split_r_hat(chains: Numbers) -> Numbers:
    """Returns the split R-hat of chains [chains, steps, walkers, dimensions]:
    each ensemble is cut into two halves, whose means and variances are
    compared (Gelman and others 2013, Bayesian Data Analysis, section 11.4)."""
    half = chains.shape[1] // 2
    parts = np.concatenate([chains[:, :half], chains[:, half : 2 * half]])
    flat = parts.reshape(len(parts), -1, chains.shape[-1])
    within = flat.var(axis=1, ddof=1).mean(axis=0)
    between = flat.mean(axis=1).var(axis=0, ddof=1)
    return np.sqrt((within + between) / within)


def sample(
    density: Density,
    size: int,
    seed: int,
    *,
    start: Numbers | None = None,
    ensembles: int = 4,
    block: int = 500,
    most: int = 20_000,
    samples: int = 4000,
) -> Samples:
    """Samples from a density until it has converged, or `most` steps.

    start: points among which walkers begin [points, dimensions], by default
        points of the prior, which is standard normal.
    block: steps between tests of convergence.
    samples: largest number of samples to return.

    Raises Error if emcee is not installed, or no start has a density."""
    try:
        import emcee
    except ImportError:
        raise Error(
            "emcee, which samples the posterior, is not installed; run "
            'pip install "ideotype[calibrate]"'
        ) from None
    walkers = max(2 * size + 2, 12)
    walkers += walkers % 2
    samplers, states = [], []
    for ensemble in range(ensembles):
        random = np.random.default_rng([seed, ensemble])
        points = _starts(density, random, walkers, size, start)
        sampler = emcee.EnsembleSampler(walkers, size, density, vectorize=True)
        generator = np.random.RandomState(random.integers(2**31))
        states.append(emcee.State(points, random_state=generator.get_state()))
        samplers.append(sampler)
    steps = 0
    while True:
        for i, sampler in enumerate(samplers):
            states[i] = sampler.run_mcmc(
                states[i], block, skip_initial_state_check=True
            )
        steps += block
        burn = steps // 4
        chains = np.array([s.get_chain()[burn:] for s in samplers])
        times = np.max(
            [
                emcee.autocorr.integrated_time(c, quiet=True, tol=0)
                for c in chains
            ],
            axis=0,
        )
        times = np.where(np.isfinite(times), np.maximum(times, 1), steps)
        r_hat = split_r_hat(chains)
        is_long = steps - burn >= FEWEST_TIMES * times.max()
        if (is_long and r_hat.max() <= LARGEST_R_HAT) or steps >= most:
            break
    logs = np.array([s.get_log_prob()[burn:] for s in samplers]).reshape(-1)
    flat = chains.reshape(-1, size)
    # Evenly spaced samples of all ensembles.
    chosen = np.linspace(0, len(flat) - 1, min(samples, len(flat))).astype(int)
    return Samples(
        flat[chosen], logs[chosen], r_hat, times, steps - burn,
        steps * walkers * ensembles, chains.shape[0] * chains.shape[1] * walkers,
    )  # fmt: skip


def _starts(
    density: Density,
    random: np.random.Generator,
    walkers: int,
    size: int,
    start: Numbers | None,
) -> Numbers:
    """Returns points with a density for all walkers."""
    points = np.empty((0, size))
    for _ in range(20):
        if start is None:
            more = random.normal(0, 1, (walkers, size))
        else:
            more = start[random.integers(len(start), size=walkers)]
            more = more + random.normal(0, 1e-3, more.shape)
        points = np.vstack([points, more[np.isfinite(density(more))]])
        if len(points) >= walkers:
            return points[:walkers]
    raise Error(_NO_DENSITY)
