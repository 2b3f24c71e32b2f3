# SPDX-License-Identifier: Apache-2.0
"""The reach of a programme: ranked lines, crosses, targets by trait, and the
cycles to a given gain."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd
from scipy.stats import norm

from ..history.estimate import Estimate
from ..history.interval import student_error
from .covariances import Matrix
from .field import Field
from .genetics import Population
from .surface import Surface, paired_difference

LOSS = 1.0
"""The loss of the objective that defines tolerances of targets [%]."""

_FARTHEST = 4.0
"""The largest tolerance [genetic standard deviations]."""


def rank_lines(
    field: Field,
    population: Population,
    draws: int,
    on_progress: Callable[[int, int], Any] = lambda done, count: None,
) -> pd.DataFrame:
    """Ranks the lines with values by the objective of their plants, best
    first.

    Returns rank, line, gain (over the plant with the mean of the lines, mean
    over cases [%]), gain_standard_error, gain_CASE with its standard error if
    there are several cases, behind_best and behind_best_standard_error
    (paired), and is_apart: whether the difference from the best line is
    significant (95 %, Bonferroni)."""
    plants = np.vstack([population.mean, population.values])
    values = field.evaluate(plants, draws, on_progress=on_progress)
    centre, lines = values[0], values[1:]
    gains = [paired_difference(x, centre) for x in lines]
    best = int(np.argmax([gain for gain, _ in gains]))
    # Half of the two-sided 5 %, shared by all comparisons with the best.
    limit = float(norm.ppf(1 - 0.025 / max(len(lines) - 1, 1)))
    rows = []
    for name, line, (gain, error) in zip(population.lines, lines, gains):
        behind, behind_error = paired_difference(lines[best], line)
        row: dict[str, Any] = {
            "line": name,
            "gain": gain,
            "gain_standard_error": error,
        }
        if len(field.cases) > 1:
            for c, case in enumerate(field.cases):
                one = paired_difference(line[c : c + 1], centre[c : c + 1])
                row[f"gain_{case}"] = one[0]
                row[f"gain_{case}_standard_error"] = one[1]
        row["behind_best"] = behind
        row["behind_best_standard_error"] = behind_error
        row["is_apart"] = behind > limit * behind_error
        rows.append(row)
    table = pd.DataFrame(rows).sort_values(
        "gain", ascending=False, kind="stable", ignore_index=True
    )
    table.insert(0, "rank", np.arange(1, len(table) + 1))
    return table


def choose_crosses(
    field: Field,
    population: Population,
    surface: Surface,
    *,
    count: int,
    draws: int,
    uses: int = 3,
) -> pd.DataFrame:
    """Chooses crosses of lines by the usefulness of their doubled haploids
    (Schnell and Utz 1975): the mean plus a standard deviation of the
    objective. The candidates are screened by the quadratic approximation, and
    the plants halfway between the parents are evaluated.

    Without markers the variance within a cross is unknown. It is taken as that
    of doubled haploids of unrelated inbred lines, G / 2 (E), so that crosses
    differ by the plant halfway and by the slope there.

    uses: largest number of crosses of a line.

    Returns a row for each cross, best first: parent_1, parent_2, gain (of the
    plant halfway [%]), gain_standard_error, deviation (of the objective within
    the cross [%], by the approximation), usefulness."""
    values, lines = population.values, len(population.lines)
    if lines < 2:
        return pd.DataFrame(
            columns=["parent_1", "parent_2", "gain", "gain_standard_error",
                     "deviation", "usefulness"]
        )  # fmt: skip
    first, second = np.triu_indices(lines, 1)
    halfway = (values[first] + values[second]) / 2
    slopes = (
        surface.gradient
        + (halfway - surface.centre) @ surface.shrunk_curvature
    )
    variance = np.einsum("ki,ij,kj->k", slopes, population.genetic, slopes)
    spread = np.sqrt(variance / 2)
    rough = surface.value(halfway) + spread
    used = np.zeros(lines, int)
    chosen: list[int] = []
    for k in np.argsort(-rough, kind="stable"):
        if max(used[first[k]], used[second[k]]) < uses:
            used[[first[k], second[k]]] += 1
            chosen.append(int(k))
        if len(chosen) == count:
            break
    evaluated = field.evaluate(
        np.vstack([population.mean, halfway[chosen]]), draws
    )
    rows = []
    for k, plant in zip(chosen, evaluated[1:]):
        gain, error = paired_difference(plant, evaluated[0])
        rows.append(
            {
                "parent_1": population.lines[first[k]],
                "parent_2": population.lines[second[k]],
                "gain": gain,
                "gain_standard_error": error,
                "deviation": float(spread[k]),
                "usefulness": gain + float(spread[k]),
            }
        )
    return pd.DataFrame(rows).sort_values(
        "usefulness", ascending=False, kind="stable", ignore_index=True
    )


def set_targets(
    field: Field, population: Population, target: Matrix, *, draws: int
) -> pd.DataFrame:
    """Returns targets by trait in the unit of pages, with the tolerance that
    costs 1 % of the objective while all other traits have their targets.

    target: trait values [traits].

    The objective along a trait is a parabola through the target and one
    standard deviation on either side. An end is empty if the objective does
    not fall by 1 % within four standard deviations and the limits of the
    measure.

    Returns trait, unit, now (mean of the lines), target, distance between
    them [genetic standard deviations], lowest, highest, slope (effect of one standard deviation [%]) and
    slope_standard_error."""
    step = population.deviation
    count = len(step)
    offsets = np.vstack([np.zeros(count), np.eye(count), -np.eye(count)])
    values = field.evaluate(target + offsets * step, draws)
    rows = []
    for i, trait in enumerate(population.traits):
        plus, _ = paired_difference(values[1 + i], values[0])
        minus, _ = paired_difference(values[1 + count + i], values[0])
        slope, bend = (plus - minus) / 2, plus + minus
        both = paired_difference(values[1 + i], values[1 + count + i])
        ends = [_tolerance(slope, bend, sign) for sign in (-1, 1)]
        low, high = (
            trait.factor * end
            if trait.limits[0] < end < trait.limits[1]
            else math.nan
            for end in (target[i] + end * step[i] for end in ends)
        )
        rows.append(
            {
                "trait": trait.name,
                "unit": trait.show,
                "now": trait.factor * population.mean[i],
                "target": trait.factor * target[i],
                "distance": (target[i] - population.mean[i]) / step[i]
                if step[i] > 0
                else 0.0,
                "lowest": low,
                "highest": high,
                "slope": slope,
                "slope_standard_error": both[1] / 2,
            }
        )
    return pd.DataFrame(rows)


def _tolerance(slope: float, bend: float, sign: int) -> float:
    """Returns the first distance in a direction at which the parabola slope x
    + bend x^2 / 2 is -LOSS [standard deviations]; infinite beyond
    _FARTHEST."""
    roots = np.roots([bend / 2, slope, LOSS])
    real = [
        float(x.real)
        for x in roots
        if abs(x.imag) < 1e-9 and 0 < sign * x.real <= _FARTHEST
    ]
    return min(real, key=abs) if real else math.inf


@dataclass(frozen=True)
class Reach:
    """The gain of a programme compared with an ideotype."""

    ceiling: float
    """The gain of the ideotype over the mean of the lines [%]; NaN: no
    history is given."""
    ceiling_standard_error: float
    curve: Matrix
    """The mean gain by cycle [cycles + 1] [%]."""
    curve_standard_error: Matrix
    half_cycles: float
    """The cycles to half of the ceiling; infinite if the programme does not
    reach it, NaN without a ceiling."""

    def sentence(self) -> str:
        """Returns the answer as a sentence."""
        last = len(self.curve) - 1
        cycles = f"{last} cycle{'s' * (last != 1)}"
        gain = Estimate(
            float(self.curve[-1]), float(self.curve_standard_error[-1])
        ).interval_text()
        if math.isnan(self.ceiling):
            return (
                f"Standing variation gives {gain} % in {cycles}. Without "
                "a history there is no ideotype to compare with."
            )
        ceiling = Estimate(
            self.ceiling, self.ceiling_standard_error
        ).interval_text()
        half = (
            f"half of that takes {self.half_cycles:.1f} cycles"
            if math.isfinite(self.half_cycles)
            else f"half of that is not reached in {cycles}"
        )
        if self.curve[-1] >= self.ceiling:
            return (
                f"Standing variation gives {gain} % in {cycles}, more than "
                f"the {ceiling} % of the ideotype: its search was narrower "
                "than the lines, or too short."
            )
        return (
            f"Standing variation gives {gain} of {ceiling} points in {cycles} "
            f"({half}); the rest needs variation that these lines do not "
            "have, or more cycles."
        )


def mean_gains(runs: pd.DataFrame, method: str) -> tuple[Matrix, Matrix]:
    """Returns the gain by cycle [cycles + 1] [%], as mean over the programmes
    of a method, and its standard error; NaN for a single programme. The error
    is scaled so that the normal interval equals Student's interval for the few
    programmes."""
    table = runs[runs["method"] == method].pivot(
        index="repeat", columns="cycle", values="gain"
    )
    error = table.std(ddof=1).map(lambda x: student_error(x, len(table)))
    return table.mean().to_numpy(), error.to_numpy()


def find_reach(
    runs: pd.DataFrame, method: str, ceiling: tuple[float, float] | None
) -> Reach:
    """Returns the reach of a method from the rows of repeat()."""
    curve, error = mean_gains(runs, method)
    top, top_error = ceiling or (math.nan, math.nan)
    return Reach(top, top_error, curve, error, cycles_to(curve, top / 2))


def cycles_to(curve: Sequence[float] | Matrix, gain: float) -> float:
    """Returns the number of cycles until a curve first reaches a gain, by
    linear interpolation; infinite if it does not."""
    if math.isnan(gain):
        return math.nan
    values = np.asarray(curve)
    above = np.flatnonzero(values >= gain)
    if not above.size:
        return math.inf
    last = int(above[0])
    if last == 0:
        return 0.0
    low, high = values[last - 1], values[last]
    return float(last - 1 + (gain - low) / (high - low))


def evaluate_ceiling(
    field: Field, path: Any, population: Population
) -> tuple[float, float]:
    """Returns the gain of the best plant of a history over the plant with the
    mean of the lines, and its paired standard error [%]."""
    theirs, ours = field.compare(path, population.mean)
    return paired_difference(theirs, ours)
