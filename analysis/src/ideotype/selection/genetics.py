# SPDX-License-Identifier: Apache-2.0
"""Genetic parameters of a trial or of a file of lines: heritability by REML,
and covariances by mean products between and within lines."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations_with_replacement
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.arrays import require_file
from ..errors import Error
from .covariances import (
    Matrix,
    draw_covariances,
    draw_inverse_wishart,
    make_semidefinite,
    mean_products,
    reml,
    without_negative,
)
from .traits import Trait, trait_of_measure
from .trial import Trial, blocks_of_plots

DRAWS = 400
"""The default number of draws for errors of genetic parameters."""


@dataclass(frozen=True)
class Population:
    """The genetic parameters of lines, in the units of the measures."""

    traits: tuple[Trait, ...]
    lines: tuple[str, ...]
    """The names of lines with values; lines of which only statistics are known
    have none."""
    values: Matrix
    """Best linear unbiased predictions of the lines [lines x traits]."""
    mean: Matrix
    """The mean of the lines [traits]."""
    genetic: Matrix
    """G, the covariances of genetic values between lines [traits x
    traits], positive semidefinite."""
    error: Matrix
    """The covariances of errors between plots [traits x traits]."""
    plots: float
    """The number of plots of a line: the harmonic mean over lines; NaN:
    unknown."""
    heritability: Matrix
    """Of a mean over the trial and of a plot [2 x traits]."""
    heritability_standard_error: Matrix
    """[2 x traits]; NaN: the heritability is assumed."""
    draws: Matrix
    """Draws of G from its sampling distribution [draws x traits x traits];
    empty if the number of lines is not known."""
    error_draws: Matrix
    """Error covariances of the same draws."""
    notes: tuple[str, ...] = ()

    @property
    def is_heritability_assumed(self) -> bool:
        """Whether the trial gives no heritability."""
        return bool(np.isnan(self.heritability_standard_error).all())

    def phenotypic(self, plots: float) -> Matrix:
        """Returns P, the covariances of means over a number of plots [traits x
        traits]."""
        return self.genetic + self.error / plots

    @property
    def genetic_standard_error(self) -> Matrix:
        """The standard errors of G; NaN if not known."""
        if not len(self.draws):
            return np.full_like(self.genetic, np.nan)
        return self.draws.std(axis=0, ddof=1)

    def genetic_interval(self, level: float = 0.95) -> Matrix:
        """Returns the ends of the confidence intervals of G [2 x traits x
        traits]; NaN if not known."""
        if not len(self.draws):
            return np.full((2, *self.genetic.shape), np.nan)
        ends = [(1 - level) / 2, (1 + level) / 2]
        return np.quantile(self.draws, ends, axis=0)

    @property
    def deviation(self) -> Matrix:
        """The genetic standard deviations [traits]."""
        return np.sqrt(np.diag(self.genetic))

    def of_plants(self) -> Population:
        """Returns the population with the traits that are measures of plants
        alone."""
        return self.select([i for i, t in enumerate(self.traits) if t.measure])

    def select(self, index: Sequence[int]) -> Population:
        """Returns the population with some of the traits."""
        at = list(index)
        square = np.ix_(at, at)
        cube = np.ix_(range(len(self.draws)), at, at)
        return replace(
            self,
            traits=tuple(self.traits[i] for i in at),
            values=self.values[:, at],
            mean=self.mean[at],
            genetic=self.genetic[square],
            error=self.error[square],
            heritability=self.heritability[:, at],
            heritability_standard_error=self.heritability_standard_error[
                :, at
            ],
            draws=self.draws[cube],
            error_draws=self.error_draws[cube],
        )


def estimate(trial: Trial, *, draws: int = DRAWS, seed: int = 1) -> Population:
    """Estimates genetic parameters of a trial. A trial with one row for each
    line takes the heritabilities of `trait_names.toml`, with errors that are
    not correlated between traits.

    draws: number of draws for errors of the parameters.
    seed: seed of the draws.

    Raises Error if the trial has too few plots, or statsmodels is not
    installed."""
    names = [trait.name for trait in trial.traits]
    table = trial.table
    # A row without a value of any trait has no part in the estimates.
    table = table[table[names].notna().any(axis=1)]
    trial = replace(trial, table=table)
    values = table[names].to_numpy(float)
    if constant := [
        name
        for name, column in zip(names, values.T)
        if len(np.unique(column[np.isfinite(column)])) < 2
    ]:
        raise Error(
            f"all plots have the same {', '.join(constant)}, or none; remove "
            "the column"
        )
    lines = trial.lines
    line = np.array([lines.index(x) for x in table["line"]])
    block = blocks_of_plots(trial)
    random = np.random.default_rng(seed)
    if not trial.has_replicates:
        return _from_means(trial, values, draws, random)
    _require_pairs(names, values, line)
    between, within = np.array(
        [reml(column, line, block) for column in values.T]
    ).T
    parts = mean_products(values, line, block)
    genetic, error = draw_covariances(parts, draws, random)
    raw = parts.genetic
    fixed = make_semidefinite(raw, parts.between / parts.plots)
    mean, predictions = _predict(values, line, block, between, within)
    return Population(
        trial.traits,
        tuple(lines),
        predictions,
        mean,
        fixed,
        parts.within,
        parts.plots,
        _heritability(between, within, parts.plots),
        _heritability(
            np.diagonal(genetic, axis1=1, axis2=2),
            np.diagonal(error, axis1=1, axis2=2),
            parts.plots,
        ).std(axis=1, ddof=1),
        genetic,
        error,
        ()
        if np.allclose(raw, fixed)
        else (
            "the estimated G had negative eigenvalues, which were set to 0",
        ),
    )


def _require_pairs(
    names: Sequence[str], values: Matrix, line: NDArray[np.int64]
) -> None:
    """Raises Error with all pairs of traits of which no line has two plots
    with both."""
    known = np.isfinite(values)
    problems = [
        f"no line has two plots with {first}"
        + f" and {second}" * (i != j)
        + "; remove a column, or give means of lines"
        for (i, first), (j, second) in combinations_with_replacement(
            enumerate(names), 2
        )
        if np.bincount(line[known[:, i] & known[:, j]], minlength=1).max() < 2
    ]
    if problems:
        raise Error("\n".join(problems))


def _heritability(between: Matrix, within: Matrix, plots: float) -> Matrix:
    """Returns heritabilities of means and of plots [2 x ...]."""
    return np.array(
        [
            between / np.maximum(between + within / count, 1e-300)
            for count in (plots, 1)
        ]
    )


def _predict(
    values: Matrix,
    line: NDArray[np.int64],
    block: NDArray[np.int64],
    between: Matrix,
    within: Matrix,
) -> tuple[Matrix, Matrix]:
    """Returns means [traits] and best linear unbiased predictions of lines
    [lines x traits], trait by trait (Henderson 1975,
    doi:10.2307/2529430)."""
    means, predictions = [], []
    for column, sigma, rest in zip(values.T, between, within):
        rows = np.isfinite(column)
        _, blocks = np.unique(block[rows], return_inverse=True)
        fixed = np.eye(blocks.max() + 1)[blocks]
        lines = np.eye(line.max() + 1)[line[rows]]
        ratio = rest / max(sigma, 1e-9 * rest, 1e-300)
        top = np.hstack([fixed.T @ fixed, fixed.T @ lines])
        bottom = np.hstack(
            [lines.T @ fixed, lines.T @ lines + ratio * np.eye(lines.shape[1])]
        )
        right = np.hstack([fixed, lines]).T @ column[rows]
        solution = np.linalg.solve(np.vstack([top, bottom]), right)
        count = fixed.shape[1]
        mean = float(np.average(solution[:count], weights=fixed.sum(axis=0)))
        means.append(mean)
        predictions.append(mean + solution[count:])
    return np.array(means), np.array(predictions).T


def _from_means(
    trial: Trial, values: Matrix, count: int, random: np.random.Generator
) -> Population:
    """Returns the parameters of a trial with one row for each line."""
    assumed = np.array([t.heritability for t in trial.traits]).T
    mean = np.nanmean(values, axis=0)
    phenotypic = _pairwise_covariance(values)
    genetic, error = _with_heritability(phenotypic, assumed)
    drawn = _draw_with_heritability(
        phenotypic, assumed, len(values), count, random
    )
    centred = np.where(np.isfinite(values), values - mean, 0)
    return Population(
        trial.traits,
        tuple(trial.lines),
        mean + assumed[0] * centred,
        mean,
        genetic,
        error,
        float("nan"),
        assumed,
        np.full_like(assumed, np.nan),
        *drawn,
        (
            "heritabilities are assumed, with errors that are not correlated "
            "between traits: the trial has one row for each line",
        ),
    )


def _with_heritability(
    phenotypic: Matrix, assumed: Matrix
) -> tuple[Matrix, Matrix]:
    """Returns G and the error covariances of plots, from the covariances of
    means over a trial and the heritabilities of means and of plots [2 x
    traits]."""
    noise = np.diag(np.diag(phenotypic) * (1 - assumed[0]))
    genetic = make_semidefinite(phenotypic - noise, phenotypic)
    return genetic, np.diag(np.diag(genetic) * (1 / assumed[1] - 1))


def _draw_with_heritability(
    phenotypic: Matrix,
    assumed: Matrix,
    lines: int,
    count: int,
    random: np.random.Generator,
) -> tuple[Matrix, Matrix]:
    """Draws the results of _with_heritability(), from the number of lines; the
    heritabilities do not vary. No draws are returned for too few lines."""
    size = len(phenotypic)
    if lines - 1 < size:
        return np.empty((0, size, size)), np.empty((0, size, size))
    sample = draw_inverse_wishart(phenotypic, lines - 1, count, random)
    both = [_with_heritability(matrix, assumed) for matrix in sample]
    return np.array([g for g, _ in both]), np.array([e for _, e in both])


def _pairwise_covariance(values: Matrix) -> Matrix:
    known = np.isfinite(values)
    centred = np.where(known, values - np.nanmean(values, axis=0), 0)
    counts = known.T.astype(float) @ known
    if (counts < 3).any():
        raise Error("two traits are measured together in fewer than 3 lines")
    covariance = centred.T @ centred / (counts - 1)
    return without_negative(covariance)


def read_lines(
    path: str | Path, *, count: int = 0, draws: int = DRAWS, seed: int = 1
) -> Population:
    """Reads a file of lines, such as campaigns/lines/maize_panel.toml: means,
    deviations and correlations of traits over lines, which are taken as
    genetic, with assumed heritabilities.

    count: number of lines of which the file has statistics, for errors of the
        covariances; 0: unknown.
    draws, seed: as for estimate().

    Raises Error if it cannot be read."""
    path = Path(path)
    require_file(path)
    try:
        file = tomllib.loads(path.read_text("utf-8"))
        rows: list[dict[str, Any]] = file["trait"]
        traits = tuple(
            trait_of_measure(row["measure"], row.get("leaf", ""))
            for row in rows
        )
        mean, deviation = (
            np.array([float(row[key]) for row in rows])
            for key in ("mean", "deviation")
        )
        upper = np.triu_indices(len(rows), 1)
        correlation = np.eye(len(rows))
        correlation[upper] = file.get("correlations", [])
        lines = file.get("line", [])
        values = np.array([line["values"] for line in lines], float)
        values = values.reshape(len(lines), len(rows))
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise Error(
            f"{path}: this is no file of lines ({error}); see [feasibility] in "
            "docs/campaign_files.md"
        ) from None
    correlation[upper[::-1]] = correlation[upper]
    genetic = correlation * np.outer(deviation, deviation)
    assumed = np.array([t.heritability for t in traits]).T
    noise = np.diag(deviation**2 * (1 / assumed[0] - 1))
    genetic = make_semidefinite(genetic, genetic + noise)
    drawn = _draw_with_heritability(
        genetic + noise, assumed, count, draws, np.random.default_rng(seed)
    )
    return Population(
        traits,
        tuple(str(line["name"]) for line in lines),
        values,
        mean,
        genetic,
        np.diag(deviation**2 * (1 / assumed[1] - 1)),
        float("nan"),
        assumed,
        np.full_like(assumed, np.nan),
        *drawn,
        (
            "deviations and correlations of the file are taken as genetic; "
            "heritabilities are assumed"
            + ("" if count else "; errors of G need the number of lines"),
        ),
    )
