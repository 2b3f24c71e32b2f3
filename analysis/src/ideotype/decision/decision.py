# SPDX-License-Identifier: Apache-2.0
"""Decides between plants and managements."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from ..history.estimate import NORMAL, Estimate
from ..history.history import History
from .evaluate import evaluate_parts
from .options import Options
from .worth import Floats, Rule, Worth

_FACTORS = np.linspace(0, 3, 61)
"""Prices of the sweep, relative to those of the campaign."""
_MOST = 5
"""Largest number of candidates of the environments, and of each price."""
_GAIN = 0.002
"""A plant is a candidate if it raises the mean over environments, or over a
sweep of prices, by this share of the mean size of the worth."""


@dataclass(frozen=True)
class Switch:
    """A price at which the decision changes."""

    price: str
    at: float
    """The price at which both candidates are equal."""
    at_standard_error: float
    below: int
    """The better candidate below this price."""
    above: int
    difference: Estimate
    """Candidate `above` less candidate `below` at a price 10 % above `at`,
    from randomisations that did not contribute to `at`."""


@dataclass(frozen=True)
class Decision:
    """The candidates of a decision, re-evaluated with independent and common
    random numbers."""

    case: str
    names: tuple[str, ...]
    """The candidates: the baseline, and others with a number."""
    baseline: int | None
    """The index of the baseline, if the rows contain it."""
    roles: tuple[str, ...]
    """Why each candidate was chosen."""
    genomes: tuple[Floats, ...]
    keys: tuple[Mapping[str, str], ...]
    """The values of the searched keys of each candidate, as texts."""
    environments: tuple[str, ...]
    weights: Floats
    worth: Worth
    rule: Rule
    draws: Floats
    """The parts [candidates, environments, randomisations, parts]."""
    switches: tuple[Switch, ...] = ()

    def worth_draws(self, prices: Mapping[str, float] | None = None) -> Floats:
        """Returns the worth [candidates, environments, randomisations]."""
        return self.worth.of(self.draws, prices)

    def value_draws(self, prices: Mapping[str, float] | None = None) -> Floats:
        """Returns the values over environments [candidates, randomisations].
        The environments that count are those of the means, as in the
        program."""
        worth = self.worth_draws(prices)
        if self.rule.name == "probability":
            return self.rule.value(np.moveaxis(worth, 1, -1), self.weights)
        shares = self.rule.shares(worth.mean(-1), self.weights)
        return np.einsum("cer,ce->cr", worth, shares)

    @property
    def best(self) -> int:
        """The candidate with the best value at the prices of the campaign."""
        return int(self.value_draws().mean(-1).argmax())

    def value(self, candidate: int) -> Estimate:
        """Returns the value of a candidate over environments."""
        return self.estimate(self.value_draws()[candidate])

    def advantage(self, candidate: int, over: int) -> Estimate:
        """Returns the paired difference of values."""
        draws = self.value_draws()
        return self.estimate(draws[candidate] - draws[over])

    def equals(self) -> list[int]:
        """Returns the candidates without a significant difference from the
        best one (5 % for all of them together, Holm 1979, JSTOR 4615733)."""
        best = self.best
        others = [c for c in range(len(self.names)) if c != best]
        scores = {c: _score(self.advantage(best, c)) for c in others}
        order = sorted(others, key=lambda c: -scores[c])
        for rank, candidate in enumerate(order):
            level = 0.05 / (len(order) - rank)
            if math.erfc(scores[candidate] / math.sqrt(2)) > level:
                return sorted(order[rank:])
        return []

    def regret(self, candidate: int, environment: int) -> Estimate:
        """Returns the loss of a candidate against the best candidate of an
        environment, with a paired standard error."""
        worth = self.worth_draws()[:, environment]
        best = int(worth.mean(-1).argmax())
        return _estimate(worth[best] - worth[candidate], self.worth.unit)

    def regret_over_environments(
        self, candidate: int
    ) -> tuple[Estimate, float]:
        """Returns the weighted mean of the regrets with the standard error of
        the sampled environments, which treats these as independent draws, and
        the largest regret."""
        regrets = np.array(
            [
                self.regret(candidate, e).mean
                for e in range(len(self.environments))
            ]
        )
        mean, error = mean_over_environments(regrets, self.weights)
        return Estimate(mean, error, self.worth.unit), float(regrets.max())

    def wins(self, candidate: int, over: int) -> float:
        """Returns the weight of the environments in which a candidate has a
        higher worth than another."""
        worth = self.worth_draws().mean(-1)
        return float(self.weights @ (worth[candidate] > worth[over]))

    def advantage_between_environments(
        self, candidate: int, over: int
    ) -> Estimate:
        """Returns the weighted mean of the differences of the worth, with the
        standard error of the sampled environments."""
        worth = self.worth_draws().mean(-1)
        mean, error = mean_over_environments(
            worth[candidate] - worth[over], self.weights
        )
        return Estimate(mean, error, self.worth.unit)

    def estimate(self, draws: Floats) -> Estimate:
        """Returns a value over environments, or a difference of values, from
        its randomisations."""
        unit = "1" if self.rule.name == "probability" else self.worth.unit
        return _estimate(draws, unit)


def _estimate(draws: Floats, unit: str) -> Estimate:
    error = draws.std(ddof=1) / np.sqrt(len(draws))
    return Estimate(float(draws.mean()), float(error), unit, draws)


def _score(value: Estimate) -> float:
    """Returns the size of an estimate in standard errors."""
    if value.standard_error > 0:
        return abs(value.mean) / value.standard_error
    return math.inf if value.mean else 0.0


def is_significant(value: Estimate) -> bool:
    """Returns whether the 95 % interval of an estimate excludes 0."""
    return _score(value) > NORMAL


def mean_over_environments(
    values: Floats, weights: Floats
) -> tuple[float, float]:
    """Returns the weighted mean of values in environments and its standard
    error if environments are independent draws: that of a ratio estimator
    (Cochran 1977, chapter 6). With one environment the error is unknown:
    NaN."""
    mean = float(weights @ values)
    count = len(values)
    if count < 2:
        return mean, float("nan")
    residuals = weights * (values - mean)
    return mean, float(np.sqrt(count / (count - 1) * (residuals**2).sum()))


def choose_candidates(options: Options) -> dict[int, str]:
    """Returns the rows to re-evaluate, each with its role for readers: the
    baseline, the best at the prices of the campaign, and a few that are
    better in some environments or at other prices."""
    chosen: dict[int, str] = {}
    baseline = np.flatnonzero(options.is_baseline)
    if len(baseline):
        chosen[int(baseline[0])] = "baseline"
    worth = options.worth
    chosen.setdefault(int(options.values().argmax()), "best of the search")
    environments = options.environments
    for index, e in _cover(options.worths().T, [*chosen]):
        chosen[index] = f"better in {environments[e]}"
    for price in worth.swept_prices(options.parts):
        at = _FACTORS * worth.prices[price]
        values = [options.values(worth.at(price, x)) for x in at]
        for index, i in _cover(np.array(values), [*chosen]):
            chosen[index] = f"better at a price of {price} of {at[i]:.3g}"
    return chosen


def _cover(values: Floats, known: Sequence[int]) -> list[tuple[int, int]]:
    """Returns rows that, in addition to the known ones, are best in some
    situations, until another one adds little; each with the situation in which
    it adds most.

    values: values [situations, rows]."""
    scale = float(np.abs(values.max(1)).mean())
    reached = values[:, list(known)].max(1)
    added: list[tuple[int, int]] = []
    while len(added) < _MOST:
        gains = np.maximum(values - reached[:, None], 0)
        index = int(gains.mean(0).argmax())
        if gains[:, index].mean() <= _GAIN * scale:
            break
        added.append((index, int(gains[:, index].argmax())))
        reached = np.maximum(reached, values[:, index])
    return added


def find_switches(decision: Decision, price: str) -> list[Switch]:
    """Returns the switches of the best candidate along a price, from 0 to
    three times that of the campaign. The first half of the randomisations
    locates them, the second half checks them."""
    half = decision.draws.shape[2] // 2

    def values_at(at: float) -> Floats:
        return decision.value_draws(decision.worth.at(price, at))

    grid = _FACTORS * decision.worth.prices[price]
    best = [int(values_at(x)[:, :half].mean(-1).argmax()) for x in grid]
    switches = []
    for i in range(1, len(grid)):
        below, above = best[i - 1], best[i]
        if below == above:
            continue

        def gap(at: float, a: int = above, b: int = below) -> Floats:
            values = values_at(at)
            return values[a] - values[b]

        at = _find_root(lambda x: gap(x)[:half].mean(), grid[i - 1], grid[i])
        step = grid[1] - grid[0]
        slope = (gap(at + step) - gap(at - step))[:half].mean() / (2 * step)
        error = gap(at)[:half].std(ddof=1) / math.sqrt(half)
        switches.append(
            Switch(
                price,
                at,
                float(error / abs(slope)) if slope else math.inf,
                below,
                above,
                decision.estimate(gap(1.1 * at)[half:]),
            )
        )
    return switches


def _find_root(
    gap: Callable[[float], float], low: float, high: float
) -> float:
    """Returns the price at which the gap is 0, by bisection; the gap may
    jump, if environments change places."""
    for _ in range(50):
        middle = (low + high) / 2
        if gap(middle) > 0:
            high = middle
        else:
            low = middle
    return (low + high) / 2


def derive_seed(histories: Sequence[History]) -> int:
    """Returns a seed of independent random numbers, a function of the seeds of
    the histories."""
    seeds = sorted({int(history.attributes["seed"]) for history in histories})
    return int(np.random.SeedSequence(seeds).generate_state(1, np.uint32)[0])


def decide(
    options: Options,
    *,
    threads: int | None = None,
    tell: Callable[[int, int], object] = lambda done, count: None,
) -> Decision:
    """Chooses candidates from stored rows, re-evaluates them like finalists
    in each environment, with random numbers that no search used and that
    candidates have in common, and returns the decision. The seed follows from
    those of the histories.

    Raises Error if an evaluation fails."""
    chosen = choose_candidates(options)
    rows = list(chosen)
    seed = derive_seed(options.histories)
    done = 0

    def run(row: int) -> Floats:
        nonlocal done
        found = evaluate_parts(
            options.histories[row],
            options.genomes[row],
            options.worth,
            len(options.environments),
            seed,
        )
        done += 1
        tell(done, len(rows))
        return found

    with ThreadPoolExecutor(threads or len(os.sched_getaffinity(0))) as pool:
        draws = np.array([*pool.map(run, rows)])
    baseline = next(
        (i for i, row in enumerate(rows) if options.is_baseline[row]), None
    )
    others = iter(range(1, len(rows) + 1))
    decision = Decision(
        options.case,
        tuple(
            "baseline" if i == baseline else f"plant {next(others)}"
            for i in range(len(rows))
        ),
        baseline,
        tuple(chosen.values()),
        tuple(options.genomes[row] for row in rows),
        tuple(options.keys(row) for row in rows),
        options.environments,
        options.weights,
        options.worth,
        options.rule,
        draws,
    )
    switches = [
        switch
        for price in decision.worth.swept_prices(draws)
        for switch in find_switches(decision, price)
    ]
    return replace(decision, switches=tuple(switches))
