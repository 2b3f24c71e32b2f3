# SPDX-License-Identifier: Apache-2.0
"""Simulates recurrent selection: crosses, doubled haploids, trials, and
selection by yield, by an index, or by genomic prediction."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
import pandas as pd

from ..errors import Error
from .covariances import Matrix, square_root
from .genome import Alleles, Founders
from .index import smith_hazel

EXHAUSTED = 0.05
"""Genetic variance of the objective is called exhausted below this fraction of
that of the founders."""


class Method(StrEnum):
    """How parents are selected."""

    objective = "yield"
    """By the objective alone, as a yield trial measures it."""
    smith_hazel = "index"
    """By the Smith-Hazel index of the traits."""
    genomic = "genomic"
    """By ridge regression of the index on the loci (Meuwissen and others 2001,
    doi:10.1093/genetics/157.4.1819)."""


@dataclass(frozen=True)
class Plan:
    """The sizes of a programme. Each cycle tests `lines` doubled haploids in
    `plots` plots each, selects `parents`, and makes `crosses`."""

    cycles: int = 5
    lines: int = 100
    parents: int = 10
    crosses: int = 10
    plots: int = 2
    untested: int = 200
    """Further doubled haploids of each cycle that genomic selection predicts
    without plots."""
    plot_cost: float = 0.0
    cross_cost: float = 0.0
    line_cost: float = 0.0
    genotype_cost: float = 0.0

    def __post_init__(self) -> None:
        if not 2 <= self.parents < self.lines:
            raise Error(
                f"{self.parents} parents of {self.lines} lines cannot be "
                "selected; use 2 or more, and fewer than lines"
            )
        for name in ("cycles", "crosses", "plots"):
            if getattr(self, name) < 1:
                raise Error(f"{name} of a programme must be 1 or more")

    def cost(self, method: Method, cycle: int) -> float:
        """Returns the cost of the cycles up to and including this one."""
        made = self.lines
        genotyped = 0
        if method == Method.genomic:
            made += self.untested
            genotyped = made
        return cycle * (
            self.plots * self.lines * self.plot_cost
            + self.crosses * self.cross_cost
            + made * self.line_cost
            + genotyped * self.genotype_cost
        )


@dataclass(frozen=True)
class World:
    """The truth that a programme meets, and what its breeder knows."""

    founders: Founders
    genetic: Matrix
    """G, from which the index is computed."""
    error: Matrix
    """The covariances of errors of traits between plots."""
    objective: Callable[[Matrix, int], Matrix]
    """The objective [%] of plants with trait values [lines x traits], with the
    random numbers of a draw: 0 measures gains, and 1 + n is the yield trial of
    cycle n, so that no selection has seen the numbers of draw 0."""
    objective_heritability: float
    """Of one plot of a yield trial, among the founders."""
    slope: Callable[[Matrix, int], Matrix]
    """The economic weights of the traits at a mean plant in a cycle, from the
    model."""


def simulate(
    world: World, plan: Plan, method: Method, seed: int
) -> pd.DataFrame:
    """Runs one programme. Founders are tested in cycle 0; cycle n has the
    doubled haploids from n rounds of selection.

    Returns a row for each cycle: cycle, gain (mean objective [%], relative to
    the founders), variance (genetic variance of the objective), inbreeding (1 -
    heterozygosity over that of the founders), accuracy (correlation of
    criterion and objective), and the mean of each trait in a column of its
    index, "0", "1", ... The same seed gives the same bits."""
    random = np.random.default_rng([seed, 71])
    founders = world.founders
    lines = founders.alleles
    first = world.objective(founders.values(lines), 0)
    start = float(first.mean())
    variance = float(first.var(ddof=1))
    noise = _noise(variance, world.objective_heritability)
    first_diversity = _diversity(lines)
    training: list[tuple[Alleles, Matrix]] = []
    rows = []
    for cycle in range(plan.cycles + 1):
        values = founders.values(lines)
        objective = world.objective(values, 0) if cycle else first
        tested = np.arange(len(lines))
        if len(lines) > plan.lines:
            tested = random.permutation(len(lines))[: plan.lines]
        criterion = _criterion(
            world, plan, method, cycle, lines, values, tested, noise,
            training, random,
        )  # fmt: skip
        is_predicted = method == Method.genomic
        candidates = np.arange(len(lines)) if is_predicted else tested
        rows.append(
            {
                "cycle": cycle,
                "gain": float(objective.mean()) - start,
                "variance": float(objective.var(ddof=1)),
                "inbreeding": 1 - _diversity(lines) / first_diversity
                if first_diversity
                else 0.0,
                "accuracy": _correlation(
                    criterion[candidates], objective[candidates]
                ),
                **{str(i): x for i, x in enumerate(values.mean(axis=0))},
            }
        )
        if cycle == plan.cycles:
            break
        order = candidates[np.argsort(-criterion[candidates], kind="stable")]
        parents = order[: plan.parents]
        count = plan.lines
        if method == Method.genomic:
            count += plan.untested
        lines = _cross(founders, lines[parents], plan.crosses, count, random)
    return pd.DataFrame(rows)


def _criterion(
    world: World,
    plan: Plan,
    method: Method,
    cycle: int,
    lines: Alleles,
    values: Matrix,
    tested: np.ndarray,
    noise: float,
    training: list[tuple[Alleles, Matrix]],
    random: np.random.Generator,
) -> Matrix:
    """Returns the criterion of all lines; NaN without one. Lines in `tested`
    have plots.

    noise: error variance of the objective between plots."""
    criterion = np.full(len(lines), np.nan)
    count = len(tested)
    if method == Method.objective:
        error = random.standard_normal(count)
        if math.isinf(noise):
            criterion[tested] = error
            return criterion
        seen = world.objective(values[tested], 1 + cycle)
        criterion[tested] = seen + math.sqrt(noise / plan.plots) * error
        return criterion
    root = square_root(world.error / plan.plots)
    noise_of_traits = random.standard_normal((count, len(root))) @ root.T
    seen = values[tested] + noise_of_traits
    slope = world.slope(seen.mean(axis=0), cycle)
    phenotypic = world.genetic + world.error / plan.plots
    index = smith_hazel(world.genetic, phenotypic, slope)
    if method == Method.smith_hazel:
        criterion[tested] = seen @ index
        return criterion
    training.append((lines[tested], seen))
    markers = np.concatenate([x for x, _ in training])
    records = np.concatenate([x for _, x in training])
    variance = float(index @ world.genetic @ index)
    rest = float(index @ world.error @ index) / plan.plots
    return _predict_ridge(markers, records @ index, lines, variance, rest)


def _predict_ridge(
    markers: Alleles,
    records: Matrix,
    lines: Alleles,
    variance: float,
    noise: float,
) -> Matrix:
    """Returns the predictions of lines by ridge regression on all loci, with
    the ratio of error variance to variance by locus as penalty (the mixed
    model of Meuwissen and others 2001)."""
    middle = markers.mean(axis=0)
    train = markers - middle
    spread = float((middle * (1 - middle)).sum())
    ratio = noise / max(variance, 1e-12 * noise, 1e-300) * spread
    kernel = train @ train.T
    mean = records.mean()
    weights = np.linalg.solve(
        kernel + (ratio + 1e-9 * np.trace(kernel)) * np.eye(len(kernel)),
        records - mean,
    )
    return np.asarray(mean + (lines - middle) @ (train.T @ weights))


def _cross(
    founders: Founders,
    parents: Alleles,
    crosses: int,
    count: int,
    random: np.random.Generator,
) -> Alleles:
    """Returns doubled haploids of crosses between parents, each of which is
    used about equally often. Their number is shared by the crosses."""
    pairs: list[tuple[int, int]] = []
    while len(pairs) < crosses:
        order = random.permutation(len(parents))
        # Neighbours in a random ring: nobody is crossed with himself.
        ring = zip(order, np.roll(order, 1))
        pairs += [(int(a), int(b)) for a, b in ring]
    sizes = np.full(crosses, count // crosses)
    sizes[: count % crosses] += 1
    return np.concatenate(
        [
            founders.map.doubled_haploids(
                parents[a], parents[b], int(size), random
            )
            for (a, b), size in zip(pairs, sizes)
        ]
    )


def _noise(variance: float, heritability: float) -> float:
    """Returns the error variance of a plot; infinite without heritability."""
    if heritability <= 0:
        return math.inf
    return variance * (1 / heritability - 1)


def _diversity(lines: Alleles) -> float:
    """Returns the mean expected heterozygosity of the loci."""
    share = lines.mean(axis=0)
    return float((2 * share * (1 - share)).mean())


def _correlation(a: Matrix, b: Matrix) -> float:
    if np.std(a) == 0 or np.std(b) == 0:
        return math.nan
    return float(np.corrcoef(a, b)[0, 1])


def repeat(
    make_world: Callable[[int], World],
    plan: Plan,
    methods: Sequence[Method],
    repeats: int,
    seed: int,
    on_progress: Callable[[int, int], object] = lambda done, count: None,
) -> pd.DataFrame:
    """Runs programmes of each method with different random numbers, the same
    for all methods.

    make_world: returns the world of a repeat, from its number.

    Returns the rows of simulate() with columns method and repeat."""
    tables = []
    for number in range(repeats):
        world = make_world(number)
        for method in methods:
            run = simulate(world, plan, method, seed + number)
            run.insert(0, "repeat", number)
            run.insert(0, "method", str(method))
            tables.append(run)
            on_progress(len(tables), repeats * len(methods))
    return pd.concat(tables, ignore_index=True)
