# SPDX-License-Identifier: Apache-2.0
"""Measures the accuracy of evaluations with settings that trade accuracy for
speed, within a given time."""

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
"""Keys with values that replace the values of the campaign."""
OWN: Setting = ()
_TOO_LONG = "it takes too long for --seconds"
FEWEST = 4
"""The least number of draws for a standard deviation."""
_FOR_LADDERS = 0.6
"""The fraction of the time in which keys are measured one by one."""
_COMBINATIONS = 6
"""The number of combinations that are measured, which are predicted to be the
best."""


class Draw(NamedTuple):
    """The objective of one evaluation of the baseline, the difference of
    another plant from the baseline with the same random numbers, and the time
    of one evaluation [s]."""

    value: float
    difference: float
    seconds: float


class Estimate(NamedTuple):
    """A number and its standard error; printed in %, with half of the 95 %
    confidence interval."""

    mean: float
    standard_error: float

    def __str__(self) -> str:
        half = NORMAL * self.standard_error
        return f"{100 * self.mean:.2f} ± {100 * half:.2f}"


def root_sum(biases: Sequence[Estimate]) -> Estimate:
    """Returns the root of the sum of squares without the part that errors add
    to the squares; a bias within two standard errors of 0 counts as 0."""
    square = sum(m**2 - e**2 for m, e in biases if abs(m) > 2 * e)
    error = math.hypot(*(error for _, error in biases))
    return Estimate(math.sqrt(square), error)


class Survey:
    """A measurement of settings within a given time. A ladder has the settings
    of one key, the most accurate last. All get the same draws, so that biases
    are means of pairs; cheap ladders get more draws."""

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
        self.ladders = [ladder(**each) for each in keys]
        # The combinations that are measured.
        self.chosen = [OWN]

    def run(self, tolerance: float) -> None:
        """Measures each setting once, then ladders, then combinations."""
        for _ in range(FEWEST):
            self._draw(OWN, 0, math.inf)
        for settings in self.ladders:
            self._begin(settings)
        while self._repeat(self.ladders, _FOR_LADDERS):
            pass
        guess = 4 * self._cost[OWN]
        for each in self.predicted(tolerance):
            if each in self.draws or self._draw(each, guess, 1):
                self.chosen.append(each)
        while self._repeat([self.chosen], 1):
            pass

    def _begin(self, settings: list[Setting]) -> None:
        """Measures a ladder once without the settings that take too long."""
        last = OWN
        for each in list(settings):
            # More accurate settings may take several times as long.
            factor = 2 if OWN in settings[settings.index(each) :] else 6
            guess = factor * self.draws[last][0].seconds
            try:
                if each == OWN or (
                    guess < self._seconds / 40
                    and self._draw(each, guess, _FOR_LADDERS)
                ):
                    last = each
                    continue
                why = _TOO_LONG
            except InputError as error:
                why = str(error)
            self.left_out[words(each)] = why
            settings.remove(each)

    def _repeat(self, ladders: list[list[Setting]], part: float) -> bool:
        """Draws once more from the ladder that has taken the least work;
        returns False if the time is over."""

        def least(settings: list[Setting]) -> int:
            return min(len(self.draws[each]) for each in settings)

        def work(settings: list[Setting]) -> float:
            cost = sum(self._cost[each] for each in settings)
            return least(settings) * math.sqrt(cost)

        # A ladder of the campaign's own setting alone leaves nothing to compare.
        several = [each for each in ladders if each != [OWN]]
        settings = min(several, key=work, default=[])
        fewest = least(settings) if settings else 0
        behind = [each for each in settings if len(self.draws[each]) == fewest]
        return all([behind, *(self._draw(each, 0, part) for each in behind)])

    def _draw(self, setting: Setting, guess: float, part: float) -> bool:
        """Measures a setting if a fraction of the time suffices."""
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
        """Returns the ladders without the settings whose draws are too few to
        estimate an error."""
        return [
            [s for s in each if len(self.draws.get(s, [])) >= FEWEST]
            for each in self.ladders
        ]

    def row(
        self, setting: Setting, ladders: Sequence[list[Setting]]
    ) -> dict[str, Any]:
        """Returns errors of one evaluation relative to the baseline's
        objective: the error of the objective and the error of the difference
        between the plants. Biases against the most accurate setting of each
        ladder add up as squares, since biases that cancel for these plants
        need not cancel for others."""
        draws = self.draws[setting]
        scale = abs(fmean(each.value for each in self.draws[OWN]))
        row: dict[str, Any] = {"settings": dict(setting), "draws": len(draws)}
        row["seconds"] = median(each.seconds for each in draws)
        for part, name in enumerate(("value", "difference")):
            biases = []
            for each in ladders:
                here = (s for s in each if set(s) & set(setting))
                pairs = zip(self.draws[next(here, OWN)], self.draws[each[-1]])
                apart = [(a[part] - b[part]) / scale for a, b in pairs]
                error = stdev(apart) / math.sqrt(len(apart))
                biases.append(Estimate(fmean(apart), error))
            size = stdev(each[part] for each in draws) / scale
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
        tolerance, on the assumption that ratios of noise and of seconds
        multiply."""
        own = self.row(OWN, [])
        noise = own["value"]["noise"]
        options: list[list[Any]] = []
        for settings in self.measured():
            options.append([])
            for each in settings:
                row = self.row(each, [settings])
                bias, one, _ = row["value"].values()
                ratio = one.mean / noise.mean
                cost = row["seconds"] / own["seconds"]
                options[-1].append((each, root_sum([bias])[0], ratio, cost))
        found = []
        for setting, biases, ratios, costs in (
            zip(*c) for c in product(*options)
        ):
            error = math.hypot(noise.mean * math.prod(ratios), *biases)
            found.append((math.prod(costs), error, sum(setting, ())))
        front = pareto(found)
        near = [each for each in front if 0.4 < each[1] / tolerance < 2]
        near = near or front[-_COMBINATIONS:]
        step = max(1, math.ceil(len(near) / _COMBINATIONS))
        return [setting for _, _, setting in near[::step]]


def pareto(points: Sequence[tuple[float, float, Any]]) -> list[Any]:
    """Returns the items (cost, error, ...) that are more accurate than all
    cheaper items."""
    front: list[Any] = []
    for each in sorted(points, key=lambda point: point[:2]):
        if not front or each[1] < front[-1][1]:
            front.append(each)
    return front


def ladder(key: str, value: float, values: Sequence[float]) -> list[Setting]:
    """Returns the settings of a key, the most accurate last, and the setting
    of the campaign."""
    is_falling = values[-1] < values[0]
    steps = sorted({value, *values}, reverse=is_falling)
    return [OWN if each == value else ((key, each),) for each in steps]


def words(setting: Setting) -> str:
    """Returns keys and values as words for the option `--set`."""
    return " ".join(f"{k}={v:.15g}" for k, v in setting) or "the campaign"


def result(survey: Survey, tolerance: float) -> dict[str, Any]:
    """Returns all measurements; an estimate is [mean, standard error]."""
    ladders = survey.measured()
    too_few = {
        words(setting): _TOO_LONG
        for asked, found in zip(survey.ladders, ladders)
        for setting in asked
        if setting not in found
    }
    rows = [
        survey.row(each, ladders)
        for each in dict.fromkeys(survey.chosen)
        if len(survey.draws[each]) >= FEWEST
    ]
    rows.sort(key=lambda row: row["seconds"])
    front = pareto([(r["seconds"], r["value"]["error"].mean, r) for r in rows])
    met = [row for _, error, row in front if error <= tolerance]
    for row in rows:
        row["is_on_front"] = any(row is point[2] for point in front)
    return {
        "tolerance": tolerance,
        "keys": [[survey.row(s, [each]) for s in each] for each in ladders],
        "settings": rows,
        "chosen": met[0] if met else front[-1][2],
        "is_met": bool(met),
        "left_out": survey.left_out | too_few,
    }
