# SPDX-License-Identifier: Apache-2.0
"""Makes trials by random numbers from the distribution of measured lines, for
examples and tests. Their lines do not exist."""

from __future__ import annotations

import numpy as np
import pandas as pd

from .genetics import Population


def make_trial(
    population: Population, lines: int, replicates: int, seed: int
) -> pd.DataFrame:
    """Draws a trial in complete blocks from the covariances of genetic values
    and of errors of a population, with effects of blocks of 2 % of the means.

    Returns a row for each plot: line, rep, plot, and the traits in the units
    of pages, within the limits of the measures."""
    random = np.random.default_rng([seed, 281])
    genetic = random.multivariate_normal(
        population.mean, population.genetic, lines, method="eigh"
    )
    rows = []
    for rep in range(1, replicates + 1):
        block = 1 + 0.02 * random.standard_normal(len(population.mean))
        errors = random.multivariate_normal(
            np.zeros(len(block)), population.error, lines, method="eigh"
        )
        values = genetic * block + errors
        for plot, line in enumerate(random.permutation(lines), 1):
            row: dict[str, object] = {
                "line": f"made{line + 1:03}",
                "rep": rep,
                "plot": 100 * rep + plot if lines < 100 else 1000 * rep + plot,
            }
            for trait, value in zip(population.traits, values[line]):
                low, high = trait.limits
                value = trait.factor * min(max(value, low), high)
                row[trait.column] = round(value, 1)
            rows.append(row)
    return pd.DataFrame(rows)
