# SPDX-License-Identifier: Apache-2.0
"""Plants evaluated, bred and compared over draws of the parameters."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike, NDArray

from ..common.arrays import real
from ..common.processors import processors
from ..errors import Error
from ..search.search import Search
from ..stand.stand import Stand
from ..validation.comparison import CROP, LEAF
from .parameters import Parameter

Numbers = NDArray[np.float64]


def format_draws(
    parameters: Sequence[Parameter], values: Numbers
) -> tuple[str, list[str]]:
    """Returns the tables [[draw]] of a campaign, and the keys of the parameters
    that they leave out: changes of leaves, factors and keys of [[TABLE]], which
    are no numeric keys of a campaign.

    values: draws of the parameters [draws, parameters]."""
    kept = [i for i, p in enumerate(parameters) if campaign_key(p)]
    names = ", ".join(f'"{campaign_key(parameters[i])}"' for i in kept)
    text = "".join(
        f'[[draw]]\nname = "{number}"\nkeys = [{names}]\nvalues = '
        f"[{', '.join(repr(float(x)) for x in row[kept])}]\n\n"
        for number, row in enumerate(values, 1)
    )
    left_out = [p.key for p in parameters if not campaign_key(p)]
    return text if kept else "", left_out


def campaign_key(parameter: Parameter) -> str:
    """Returns the numeric key of a campaign that a parameter sets, or ""."""
    key = parameter.key
    if key.startswith(CROP):
        key = f"plant.baseline.{key.removeprefix(CROP)}"
        is_plain = key.count(".") == 3
    else:
        is_plain = not key.startswith(LEAF)
    return key if is_plain and not parameter.is_factor else ""


Across = str | float
"""The value of an objective over draws: "mean", "worst", or a quantile from 0
(the worst draw) to 1."""


class Draws:
    """The stands of a case at draws of its parameters. All have the same genes
    and random numbers, so plants of one generation are paired."""

    def __init__(self, stands: Sequence[Stand]) -> None:
        """Raises Error if there is no stand, or their genes differ."""
        if not stands:
            raise Error("there is no draw; give at least one stand")
        self.stands = list(stands)
        first = self.stands[0]
        names = list(first.genes.name)
        if any(list(x.genes.name) != names for x in self.stands):
            raise Error("stands have different genes; draw one case")
        (self.objective, sense), *others = first.objectives.items()
        if others:
            raise Error(
                "draws have one objective; remove the others of the campaign"
            )
        self.is_maximised = sense == "maximise"

    def evaluate(
        self, plants: ArrayLike, *, generation: int = 0, final: bool = False
    ) -> Numbers:
        """Returns the objective of each plant in each draw [draws, plants];
        NaN where an evaluation failed.

        plants: [plants, genes] or [plants, free genes]."""
        genomes = np.atleast_2d(real(plants, "plants"))

        def value(job: tuple[Stand, Numbers]) -> float:
            stand, genome = job
            try:
                found = stand.evaluate_one(
                    genome, generation=generation, final=final
                )
            except Error:
                return np.nan
            return np.nan if found.violation > 0 else found.objectives[0, 0]

        jobs = [(s, g) for s in self.stands for g in genomes]
        with ThreadPoolExecutor(processors()) as pool:
            values = list(pool.map(value, jobs))
        return np.array(values, float).reshape(len(self.stands), -1)

    def across(self, values: Numbers, how: Across) -> Numbers:
        """Returns one value of each plant over draws [plants]: the mean, the
        worst, or a quantile.

        values: [draws, plants]. Raises Error for an unknown `how`."""
        good = values if self.is_maximised else -values
        if how == "mean":
            result = good.mean(axis=0)
        elif how == "worst":
            result = good.min(axis=0)
        elif not isinstance(how, str) and 0 <= how <= 1:
            result = np.quantile(good, how, axis=0)
        else:
            raise Error(
                f'the value over draws is {how!r}; use "mean", "worst" or a '
                "quantile from 0 to 1"
            )
        return result if self.is_maximised else -result

    def breed(
        self,
        how: Across = "mean",
        *,
        generations: int = 20,
        population: int | None = None,
        seed: int = 1,
    ) -> Numbers:
        """Returns the free genes of the best plant over draws, by the
        optimizers of the program from the baseline on [free genes]."""
        lower, upper = self.stands[0].bounds
        free = self.stands[0].genes[self.stands[0].free]
        search = Search(
            lower,
            upper,
            start=np.clip(self.stands[0].start, lower, upper),
            maximise=[self.is_maximised],
            population=population,
            seed=seed,
            circular=free.is_circular.to_numpy(bool),
            traits=list(free.trait),
        )
        for generation in range(generations):
            values = self.evaluate(search.ask(), generation=generation)
            search.tell(self.across(values, how))
        return search.best()[0]

    def compare(
        self, plants: Sequence[ArrayLike], names: Sequence[str]
    ) -> Robustness:
        """Compares plants with the first one in each draw, with independent
        random numbers and the accuracy of finalists."""
        values = self.evaluate(
            np.stack([real(x, "plants") for x in plants]), final=True
        )
        return Robustness(
            list(names), values, self.is_maximised, self.objective
        )


@dataclass(frozen=True)
class Robustness:
    """Plants compared over draws."""

    names: list[str]
    values: Numbers
    """The objective [draws, plants]; the first plant is the baseline."""
    is_maximised: bool
    objective: str

    @property
    def gains(self) -> Numbers:
        """Gain of each plant over the baseline [%] [draws, plants]."""
        sign = 1 if self.is_maximised else -1
        first = self.values[:, :1]
        return sign * 100 * (self.values - first) / np.abs(first)

    @property
    def regrets(self) -> Numbers:
        """The gain of the best of these plants in each draw less that of the
        plant [%] [draws, plants]."""
        return self.gains.max(axis=1, keepdims=True) - self.gains

    def table(self) -> pd.DataFrame:
        """Returns one row for each plant: mean, best and worst gain over draws
        [%], probability of a gain, mean and largest regret [%]."""
        gains, regrets = self.gains, self.regrets
        return pd.DataFrame(
            {
                "plant": self.names,
                "mean": gains.mean(axis=0),
                "worst": gains.min(axis=0),
                "best": gains.max(axis=0),
                "probability": (gains > 0).mean(axis=0),
                "regret": regrets.mean(axis=0),
                "largest_regret": regrets.max(axis=0),
            }
        )
