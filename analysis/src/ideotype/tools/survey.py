# SPDX-License-Identifier: Apache-2.0
"""Measures, within a given time, the accuracy of evaluations with settings
that trade accuracy for speed."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Sequence
from itertools import product
from statistics import fmean, median, stdev
from typing import Any, NamedTuple

from ..errors import InputError
from ..history.estimate import NORMAL

Setting = tuple[tuple[str, float], ...]
"""Keys with values that replace those of the campaign."""
OWN: Setting = ()
_TOO_LONG = "it takes too long for --seconds"
FEWEST = 4
"""The smallest number of draws for a standard deviation."""
_FOR_LADDERS = 0.6
"""The fraction of the time for measurements of single keys."""
_COMBINATIONS = 6
"""The number of combinations that are measured, the best by prediction."""


class Draw(NamedTuple):
    """The objective of the baseline in one evaluation, the difference of
    another plant from it with common random numbers, and the time of one
    evaluation [s]."""

    value: float
    difference: float
    seconds: float


class Estimate(NamedTuple):
    """A number and its standard error, printed in % ± half of its 95 %
    confidence interval."""

    mean: float
    standard_error: float

    def __str__(self) -> str:
        half = NORMAL * self.standard_error
        return f"{100 * self.mean:.2f} ± {100 * half:.2f}"


def root_sum(biases: Sequence[Estimate]) -> Estimate:
    """Returns the root of the sum of squares, corrected for the contribution
    of errors; a bias within two standard errors of 0 counts as 0."""
    square = sum(m**2 - e**2 for m, e in biases if abs(m) > 2 * e)
    error = math.hypot(*(error for _, error in biases))
    return Estimate(math.sqrt(square), error)


class Survey:
    """A measurement of settings within a given time. A ladder has the settings
    of one key, the most accurate last. The draws of all settings have common
    random numbers, so biases are means of paired differences. Cheap ladders
    have more draws."""

    def __init__(
        self,
        keys: Sequence[dict[str, Any]],
        measure: Callable[[Setting, int], Draw],
        seconds: float,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._measure, self._clock, self._seconds = measure, clock, seconds
        self._began = clock()
        self._cost: dict[Setting, float] = {}
        self.draws: dict[Setting, list[Draw]] = {OWN: []}
        self.left_out: dict[str, str] = {}
        self.ladders = [ladder(**key) for key in keys]
        # The measured combinations.
        self.chosen = [OWN]

    def run(self, tolerance: float) -> None:
        """Measures each setting once, then ladders, then combinations, until
        the time is over."""
        for _ in range(FEWEST):
            self._draw(OWN, 0, math.inf)
        for settings in self.ladders:
            self._begin(settings)
        while self._repeat(self.ladders, _FOR_LADDERS):
            pass
        guess = 4 * self._cost[OWN]
        for setting in self.predicted(tolerance):
            if setting in self.draws or self._draw(setting, guess, 1):
                self.chosen.append(setting)
        while self._repeat([self.chosen], 1):
            pass

    def _begin(self, settings: list[Setting]) -> None:
        """Measures each setting of a ladder once, and removes settings that
        take too long."""
        last = OWN
        for setting in list(settings):
            # More accurate settings may take several times as long.
            factor = 2 if OWN in settings[settings.index(setting) :] else 6
            guess = factor * self.draws[last][0].seconds
            try:
                if setting == OWN or (
                    guess < self._seconds / 40
                    and self._draw(setting, guess, _FOR_LADDERS)
                ):
                    last = setting
                    continue
                reason = _TOO_LONG
            except InputError as error:
                reason = str(error)
            self.left_out[format_setting(setting)] = reason
            settings.remove(setting)

    def _repeat(self, ladders: list[list[Setting]], part: float) -> bool:
        """Draws once more from the ladder with the least work so far; returns
        False if the time is over."""

        def least(settings: list[Setting]) -> int:
            return min(len(self.draws[setting]) for setting in settings)

        def work(settings: list[Setting]) -> float:
            cost = sum(self._cost[setting] for setting in settings)
            return least(settings) * math.sqrt(cost)

        # A ladder that contains only the campaign's setting has nothing to
        # compare.
        several = [settings for settings in ladders if settings != [OWN]]
        settings = min(several, key=work, default=[])
        fewest = least(settings) if settings else 0
        behind = [x for x in settings if len(self.draws[x]) == fewest]
        return all([behind, *(self._draw(x, 0, part) for x in behind)])

    def _draw(self, setting: Setting, guess: float, part: float) -> bool:
        """Measures a setting if it fits into a fraction of the time; returns
        whether it does."""
        before = self._clock()
        end = before + self._cost.get(setting, guess) - self._began
        if end > part * self._seconds:
            return False
        if sys.stderr.isatty():
            left = f"{max(0, self._seconds - end):.0f} s left"
            print(f"\r{left:12}", end="", file=sys.stderr)
        done = self.draws.get(setting, [])
        self.draws[setting] = [*done, self._measure(setting, len(done))]
        self._cost[setting] = self._clock() - before
        return True

    def measured(self) -> list[list[Setting]]:
        """Returns the ladders, without settings with too few draws for an
        error."""
        return [
            [s for s in settings if len(self.draws.get(s, [])) >= FEWEST]
            for settings in self.ladders
        ]

    def row(
        self, setting: Setting, ladders: Sequence[list[Setting]]
    ) -> dict[str, Any]:
        """Returns the errors of one evaluation, of the objective and of the
        difference between the plants, relative to the objective of the
        baseline. A bias is the deviation from the most accurate setting of a
        ladder. Biases are added in squares, since biases that cancel for these
        plants need not cancel for others."""
        draws = self.draws[setting]
        scale = abs(fmean(draw.value for draw in self.draws[OWN]))
        row: dict[str, Any] = {"settings": dict(setting), "draws": len(draws)}
        row["seconds"] = median(draw.seconds for draw in draws)
        for part, name in enumerate(("value", "difference")):
            biases = []
            for settings in ladders:
                here = (s for s in settings if set(s) & set(setting))
                best = self.draws[settings[-1]]
                pairs = zip(self.draws[next(here, OWN)], best)
                apart = [(a[part] - b[part]) / scale for a, b in pairs]
                error = stdev(apart) / math.sqrt(len(apart))
                biases.append(Estimate(fmean(apart), error))
            size = stdev(draw[part] for draw in draws) / scale
            noise = Estimate(size, size / math.sqrt(2 * len(draws) - 2))
            bias = root_sum(biases)
            size = math.hypot(bias.mean, noise.mean)
            error = math.hypot(*(m * e for m, e in (bias, noise))) / size
            row[name] = {
                "bias": biases[0] if len(biases) == 1 else bias,
                "noise": noise,
                "error": Estimate(size, error),
            }
        return row

    def predicted(self, tolerance: float) -> list[Setting]:
        """Returns the most promising combinations of settings near a
        tolerance, if ratios of noise and of time multiply."""
        unchanged = self.row(OWN, [])
        noise = unchanged["value"]["noise"]
        options: list[list[Any]] = []
        for settings in self.measured():
            options.append([])
            for candidate in settings:
                row = self.row(candidate, [settings])
                bias, scatter, _ = row["value"].values()
                ratio = scatter.mean / noise.mean
                cost = row["seconds"] / unchanged["seconds"]
                size = root_sum([bias])[0]
                options[-1].append((candidate, size, ratio, cost))
        combinations = []
        for setting, biases, ratios, costs in (
            zip(*c) for c in product(*options)
        ):
            error = math.hypot(noise.mean * math.prod(ratios), *biases)
            combinations.append((math.prod(costs), error, sum(setting, ())))
        front = pareto(combinations)
        near = [point for point in front if 0.4 < point[1] / tolerance < 2]
        near = near or front[-_COMBINATIONS:]
        step = max(1, math.ceil(len(near) / _COMBINATIONS))
        return [setting for _, _, setting in near[::step]]


def pareto(points: Sequence[tuple[float, float, Any]]) -> list[Any]:
    """Returns the points (cost, error, ...) that are more accurate than all
    cheaper points."""
    front: list[Any] = []
    for point in sorted(points, key=lambda point: point[:2]):
        if not front or point[1] < front[-1][1]:
            front.append(point)
    return front


def ladder(key: str, value: float, values: Sequence[float]) -> list[Setting]:
    """Returns the settings of a key, including that of the campaign, the most
    accurate last."""
    is_falling = values[-1] < values[0]
    steps = sorted({value, *values}, reverse=is_falling)
    return [OWN if step == value else ((key, step),) for step in steps]


def format_setting(setting: Setting) -> str:
    """Returns keys and values as words for the option `--set`."""
    return " ".join(f"{k}={v:.15g}" for k, v in setting) or "the campaign"


def _relative_cost(row: dict[str, Any], own: dict[str, Any]) -> Estimate:
    """Returns the time of an evaluation times the square of the error of the
    difference, relative to the campaign's: the work that a search needs to
    distinguish two plants."""
    errors = [x["difference"]["error"] for x in (row, own)]
    ratio = errors[0].mean / errors[1].mean
    size = row["seconds"] / own["seconds"] * ratio**2
    if row["settings"] == own["settings"]:
        return Estimate(size, 0)
    parts = (2 * x.standard_error / x.mean for x in errors)
    return Estimate(size, size * math.hypot(*parts))


def summarize(survey: Survey, tolerance: float) -> dict[str, Any]:
    """Returns all measurements and the cheapest setting within the tolerance;
    an estimate is [mean, standard error]."""
    ladders = survey.measured()
    too_few = {
        format_setting(setting): _TOO_LONG
        for asked, kept in zip(survey.ladders, ladders)
        for setting in asked
        if setting not in kept
    }
    rows = [
        survey.row(setting, ladders)
        for setting in dict.fromkeys(survey.chosen)
        if len(survey.draws[setting]) >= FEWEST
    ]
    rows.sort(key=lambda row: row["seconds"])
    tables = [[survey.row(s, [steps]) for s in steps] for steps in ladders]
    own = survey.row(OWN, [])
    for row in (*rows, *(row for steps in tables for row in steps)):
        row["cost"] = _relative_cost(row, own)
    front = pareto([(r["seconds"], r["value"]["error"].mean, r) for r in rows])
    met = [row for _, error, row in front if error <= tolerance]
    for row in rows:
        row["is_on_front"] = any(row is point[2] for point in front)
    return {
        "tolerance": tolerance,
        "keys": tables,
        "settings": rows,
        "chosen": met[0] if met else front[-1][2],
        "is_met": bool(met),
        "best_for_search": min(rows, key=lambda row: row["cost"].mean),
        "left_out": survey.left_out | too_few,
    }
