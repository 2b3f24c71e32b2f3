# SPDX-License-Identifier: Apache-2.0
"""The tables of a selection, and their columns."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement

import numpy as np
import pandas as pd

from .genetics import Population
from .index import Index
from .surface import Surface

_SE = "standard error of the column before it"
_PAIRED = "paired standard error of the column before it"
_OVER_PROGRAMMES = (
    f"{_SE}, so that 1.96 of it are Student's 95 % interval over programmes"
)

COLUMNS: dict[str, dict[str, str]] = {
    "taken": {
        "column": "column of the trial",
        "taken_for": "trait or factor of the design that it was taken for",
        "unit": "unit of the column",
        "values": "number of values",
        "missing": "number of missing values",
        "note": "measure of the plant, and how it was read",
    },
    "traits": {
        "trait": "trait",
        "unit": "unit of mean and deviation",
        "mean": "mean of the lines",
        "genetic_deviation": "genetic standard deviation between lines",
        "heritability_mean": "heritability of a mean over the trial",
        "heritability_mean_standard_error": f"{_SE}; empty: assumed",
        "heritability_plot": "heritability of a plot",
        "heritability_plot_standard_error": f"{_SE}; empty: assumed",
    },
    "covariances": {
        "trait_1": "trait",
        "trait_2": "trait",
        "genetic": "element of G, in the units of both traits",
        "genetic_standard_error": f"{_SE}; empty: unknown",
        "genetic_low": "lower end of its 95 % interval",
        "genetic_high": "upper end of its 95 % interval",
        "error": "covariance of errors between plots",
        "correlation": "genetic correlation; empty without variance",
    },
    "lines": {
        "rank": "rank, 1 is the best",
        "line": "line",
        "gain": "mean over cases of the objective over that of the mean "
        "plant [%]",
        "gain_standard_error": _PAIRED,
        "gain_CASE": "gain in one case, if there are several [%]",
        "gain_CASE_standard_error": _PAIRED,
        "behind_best": "objective of the best line over that of this one [%]",
        "behind_best_standard_error": _PAIRED,
        "is_apart": "whether this difference is significant (95 %, "
        "Bonferroni)",
    },
    "gradient": {
        "case": "case of the campaign, or mean",
        "trait": "trait",
        "unit": "unit of the trait",
        "deviation": "genetic standard deviation [unit]",
        "slope": "effect of one standard deviation on the objective, at the "
        "mean plant [%]",
        "slope_standard_error": _PAIRED,
        "curvature": "second derivative by standard deviations [%]",
        "curvature_standard_error": _PAIRED,
    },
    "curvature": {
        "trait_1": "trait",
        "trait_2": "trait",
        "curvature": "mixed second derivative by standard deviations, mean "
        "over cases [%]",
        "curvature_standard_error": _PAIRED,
    },
    "index": {
        "case": "case of the campaign, or mean",
        "trait": "trait",
        "unit": "unit of the trait",
        "economic_weight": "effect on the objective, the weight of the base "
        "index [% per unit]",
        "economic_weight_standard_error": _SE,
        "weight": "weight of the phenotype in the Smith-Hazel index [% per "
        "unit]",
        "weight_standard_error": _SE,
        "response": "response of the trait in one cycle [unit]",
        "response_standard_error": _SE,
        "single_gain": "response of the objective if this trait alone is "
        "selected [%]",
        "single_gain_standard_error": _SE,
        "lost_without": "fraction of the response that an index without the "
        "trait loses",
        "advice": "select for, select against, leave alone or undecided",
    },
    "response": {
        "case": "case of the campaign, or mean",
        "objective": "objective of the mean plant",
        "objective_standard_error": _SE,
        "gain": "linear response of the objective to one cycle by the "
        "Smith-Hazel index [%]",
        "gain_standard_error": _SE,
        "base_gain": "the same by the base index [%]",
        "base_gain_standard_error": _SE,
        "first_trait": "the trait with the largest response by itself",
        "first_probability": "fraction of the draws of G and of the gradient "
        "in which it is this trait",
    },
    "programme": {
        "method": "yield, index or genomic",
        "cycle": "rounds of selection so far",
        "gain": "mean objective of the lines over that of the founders, mean "
        "over repeats [%]",
        "gain_standard_error": _OVER_PROGRAMMES,
        "mean_plant": "objective of the plant with the mean traits, evaluated "
        "with traced light [%]",
        "mean_plant_standard_error": _PAIRED,
        "mean_plant_approximate": "the same by the quadratic approximation "
        "[%]",
        "variance": "genetic variance of the objective over that of the "
        "founders",
        "inbreeding": "1 - heterozygosity over that of the founders",
        "accuracy": "correlation of criterion and objective",
        "plots": "plots so far",
        "cost": "cost so far",
        "TRAIT": "mean of each trait [unit of pages]",
    },
    "crosses": {
        "parent_1": "line",
        "parent_2": "line",
        "gain": "objective of the plant halfway between the parents [%]",
        "gain_standard_error": _PAIRED,
        "deviation": "standard deviation of the objective within the cross, "
        "approximate [%]",
        "usefulness": "gain + deviation [%]",
    },
    "targets": {
        "trait": "trait",
        "unit": "unit of the numbers",
        "now": "mean of the lines",
        "target": "mean after the last cycle of the index",
        "distance": "target - now [genetic standard deviations]",
        "lowest": "value that costs 1 % of the objective; empty: none within "
        "4 standard deviations",
        "highest": "value that costs 1 % of the objective; empty: as before",
        "slope": "effect of one standard deviation at the target [%]",
        "slope_standard_error": _PAIRED,
    },
    "reach": {
        "method": "yield, index or genomic",
        "ceiling": "gain of the ideotype of the history over the mean plant "
        "[%]; empty: none is given",
        "ceiling_standard_error": _PAIRED,
        "gain": "gain after the last cycle [%]",
        "gain_standard_error": _OVER_PROGRAMMES,
        "cycles": "number of cycles",
        "half_cycles": "cycles to half of the ceiling; empty: not reached",
    },
}
"""The meaning of each column of each table, the files NAME.csv."""


def traits_table(population: Population) -> pd.DataFrame:
    """Returns the table `traits`."""
    factor = np.array([t.factor for t in population.traits])
    h, e = population.heritability, population.heritability_standard_error
    return pd.DataFrame(
        {
            "trait": [t.name for t in population.traits],
            "unit": [t.show for t in population.traits],
            "mean": factor * population.mean,
            "genetic_deviation": factor * population.deviation,
            "heritability_mean": h[0],
            "heritability_mean_standard_error": e[0],
            "heritability_plot": h[1],
            "heritability_plot_standard_error": e[1],
        }
    )


def covariances_table(population: Population) -> pd.DataFrame:
    """Returns the table `covariances`."""
    error = population.genetic_standard_error
    low, high = population.genetic_interval()
    deviation = population.deviation
    rows = []
    for i, j in combinations_with_replacement(range(len(deviation)), 2):
        first, second = population.traits[i], population.traits[j]
        factor = first.factor * second.factor
        both = deviation[i] * deviation[j]
        rows.append(
            {
                "trait_1": first.name,
                "trait_2": second.name,
                "genetic": factor * population.genetic[i, j],
                "genetic_standard_error": factor * error[i, j],
                "genetic_low": factor * low[i, j],
                "genetic_high": factor * high[i, j],
                "error": factor * population.error[i, j],
                "correlation": population.genetic[i, j] / both
                if both > 0
                else np.nan,
            }
        )
    return pd.DataFrame(rows)


def gradient_table(
    population: Population, surfaces: Sequence[tuple[str, Surface]]
) -> pd.DataFrame:
    """Returns the table `gradient` of surfaces by case."""
    rows = []
    for case, surface in surfaces:
        step = surface.step
        slope, error = surface.gradient, surface.gradient_standard_error
        bend = np.diag(surface.curvature)
        bend_error = np.diag(surface.curvature_standard_error)
        for i, trait in enumerate(population.traits):
            rows.append(
                {
                    "case": case,
                    "trait": trait.name,
                    "unit": trait.show,
                    "deviation": trait.factor * step[i],
                    "slope": step[i] * slope[i],
                    "slope_standard_error": step[i] * error[i],
                    "curvature": step[i] ** 2 * bend[i],
                    "curvature_standard_error": step[i] ** 2 * bend_error[i],
                }
            )
    return pd.DataFrame(rows)


def curvature_table(population: Population, surface: Surface) -> pd.DataFrame:
    """Returns the table `curvature`."""
    scale = np.outer(surface.step, surface.step)
    bend = scale * surface.curvature
    error = scale * surface.curvature_standard_error
    names = [t.name for t in population.traits]
    return pd.DataFrame(
        [
            {
                "trait_1": names[i],
                "trait_2": names[j],
                "curvature": bend[i, j],
                "curvature_standard_error": error[i, j],
            }
            for i, j in combinations_with_replacement(range(len(names)), 2)
        ]
    )


def index_table(
    population: Population, indices: Sequence[Index]
) -> pd.DataFrame:
    """Returns the table `index`."""
    rows = []
    for index in indices:
        for i, trait in enumerate(population.traits):
            per_unit = 1 / trait.factor
            rows.append(
                {
                    "case": index.case,
                    "trait": trait.name,
                    "unit": trait.show,
                    "economic_weight": per_unit * index.weights[i],
                    "economic_weight_standard_error": per_unit
                    * index.weights_standard_error[i],
                    "weight": per_unit * index.smith_hazel[i],
                    "weight_standard_error": per_unit
                    * index.smith_hazel_standard_error[i],
                    "response": trait.factor * index.trait_response[i],
                    "response_standard_error": trait.factor
                    * index.trait_response_standard_error[i],
                    "single_gain": index.single_gain[i],
                    "single_gain_standard_error": (
                        index.single_gain_standard_error[i]
                    ),
                    "lost_without": index.lost_without[i],
                    "advice": str(index.advice[i]),
                }
            )
    return pd.DataFrame(rows)


def response_table(
    population: Population,
    indices: Sequence[Index],
    surfaces: Sequence[tuple[str, Surface]],
) -> pd.DataFrame:
    """Returns the table `response`."""
    rows = []
    for index, (_, surface) in zip(indices, surfaces):
        draws = np.abs(surface.objective).mean(axis=0)
        first = int(np.argmax(index.single_gain))
        rows.append(
            {
                "case": index.case,
                "objective": draws.mean(),
                "objective_standard_error": draws.std(ddof=1)
                / np.sqrt(len(draws)),
                "gain": index.gain,
                "gain_standard_error": index.gain_standard_error,
                "base_gain": index.base_gain,
                "base_gain_standard_error": index.base_gain_standard_error,
                "first_trait": population.traits[first].name,
                "first_probability": index.first_probability[first],
            }
        )
    return pd.DataFrame(rows)


def columns_table() -> pd.DataFrame:
    """Returns the meanings of all columns: file, column, meaning."""
    return pd.DataFrame(
        [
            {"file": f"{name}.csv", "column": column, "meaning": meaning}
            for name, columns in COLUMNS.items()
            for column, meaning in columns.items()
        ]
    )
