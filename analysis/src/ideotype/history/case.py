# SPDX-License-Identifier: Apache-2.0
"""A case of a campaign with its replicates."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from .estimate import Estimate
from .file import HistoryError
from .front import Front
from .history import History
from .interval import Interval, gain_interval, interval, over_searches
from .pair import Pair
from .rows import Evaluation, Rows, join

_SMALL = 1e-12
_BY_ORGAN = "absorbed_by_organ"
_TAKEN = ("stalk_fraction", "soil_fraction")


class Case:
    """The replicates of one case, which have the same light, field and genes
    and different random numbers. Results are cached, so that all figures show
    one moment of a run."""

    def __init__(
        self, name: str, histories: Sequence[History], light: str = ""
    ) -> None:
        """`light` is the name of the case in cross-evaluations, by default
        `name`."""
        self.name = name
        self.light = light or name
        self.histories = tuple(histories)
        self.attributes = histories[0].attributes
        self.genes = histories[0].genes
        self.is_isolated = histories[0].is_isolated
        self.resolved = histories[0].resolved

    def __repr__(self) -> str:
        return f"<Case {self.name}, seeds: {len(self.histories)}>"

    @property
    def is_sensitivity(self) -> bool:
        """Whether the case is a sensitivity study, not a search."""
        return self.histories[0].is_sensitivity

    @property
    def known(self) -> tuple[tuple[History, Pair], ...]:
        """The histories with an evaluated baseline and best plant, each with
        this pair."""
        return self._known

    @cached_property
    def _known(self) -> tuple[tuple[History, Pair], ...]:
        pairs = ((h, h.comparison()) for h in self.histories)
        return tuple((h, pair) for h, pair in pairs if pair is not None)

    def remember(self) -> None:
        """Caches the data of several figures, so that a copy in another
        process shows the same moment of a run."""
        with suppress(HistoryError):
            _ = self._known, self._latest, self.fronts

    def is_over(self, axis: str) -> bool:
        """Returns whether the objective is taken over all entries of an axis
        of the campaign, "site", "day", "climate", "spacing" or "draw"; the case
        then has the properties of the first scenario."""
        return axis in self.resolved.get("objective", {}).get("over", ())

    @property
    def pairs(self) -> tuple[Pair, ...]:
        """The baseline and the best plant of each seed with both
        evaluated."""
        return tuple(pair for _, pair in self._known)

    @cached_property
    def fronts(self) -> tuple[tuple[History, Front], ...]:
        """The Pareto front of each seed that already has one; empty for a
        single objective."""
        fronts = ((h, h.front()) for h in self.histories)
        return tuple((h, front) for h, front in fronts if front is not None)

    def member_title(self, seed: int, index: int) -> str:
        """Returns the name of a member of `fronts[seed]` in all figures,
        tables and views: "plant 3", with the seed if there are several."""
        _, front = self.fronts[seed]
        replicate = f" of seed {seed + 1}" if len(self.histories) > 1 else ""
        return f"plant {front.number(index)}{replicate}"

    @property
    def is_final(self) -> bool:
        """Whether all seeds have their final evaluations."""
        return len(self.pairs) == len(self.histories) and all(
            pair.is_final for pair in self.pairs
        )

    @cached_property
    def _winner(self) -> tuple[History, Pair]:
        self.need_pairs()
        rows = join([pair.best.row for _, pair in self._known])
        return self._known[int(rows.ranking(1)[0])]

    @property
    def best_history(self) -> History:
        """The history with the best plant of all seeds."""
        return self._winner[0]

    @property
    def best_pair(self) -> Pair:
        """The baseline and the best plant of `best_history`."""
        return self._winner[1]

    @property
    def best(self) -> Evaluation:
        """The best plant of all seeds."""
        return self.best_pair.best

    @property
    def baseline(self) -> Evaluation:
        """The baseline plant, evaluated together with the best plant."""
        return self.best_pair.baseline

    def need_pairs(self) -> None:
        """Raises HistoryError unless a seed has an evaluated baseline and best
        plant."""
        if not self.pairs:
            raise HistoryError("baseline and best are not evaluated yet")

    @cached_property
    def _latest(self) -> tuple[Rows, NDArray[np.int64]]:
        """The last complete generations, and the index of the history of each
        row."""
        parts = [history.latest().done for history in self.histories]
        seed = np.repeat(np.arange(len(parts)), [len(p) for p in parts])
        return join(parts), seed

    def top(self, count: int) -> Rows:
        """Returns the best plants of the last complete generations of all
        seeds together, best first.

        Raises HistoryError if there is no complete generation."""
        rows = self._latest[0].top(count)
        if not len(rows):
            raise HistoryError("no plant is evaluated yet")
        return rows

    def seeds_of_top(self, count: int) -> int:
        """Returns the number of seeds from which the plants of top() come."""
        rows, seed = self._latest
        return len(set(seed[rows.ranking(count)]))

    def gains(self) -> list[Estimate]:
        """Returns the difference of the best plant from the baseline by seed,
        in the unit of the objective."""
        return [pair.difference for pair in self.pairs]

    def gain(self) -> Interval:
        """Returns the mean gain over seeds, in the unit of the objective; the
        interval includes the optimum (see gain_interval())."""
        self.need_pairs()
        return gain_interval(self.gains(), self._sign)

    def relative_gain(self) -> Interval:
        """Returns the mean gain over seeds [% of the baseline]."""
        self.need_pairs()
        return gain_interval([pair.gain for pair in self.pairs], self._sign)

    @property
    def _sign(self) -> int:
        """The sign of an improvement of the first objective."""
        return self.best.row.goals[0].sign

    def gain_per_leaf_area(self) -> Interval:
        """Returns the mean gain over seeds in absorbed PAR per leaf area [%].

        Raises HistoryError if a history lacks this quantity."""
        self.need_pairs()
        return over_searches(
            [pair.gain_per_leaf_area for pair in self.pairs],
            [pair.gain for pair in self.pairs],
        )

    def number(self, who: str, name: str | None = None) -> Interval:
        """Returns a quantity without axes of the plant `who`, "baseline" or
        "best", by default the objective. All tables and figures show this
        number; its interval covers light and field.

        Raises HistoryError if the history lacks the quantity."""
        self.need_pairs()
        plant: Evaluation = getattr(self, who)
        return interval([plant.estimate(name) if name else plant.objective])

    def light_by_organ(self, who: str) -> dict[str, Interval]:
        """Returns the PAR absorbed by each organ except leaves, relative to
        the incident PAR, of the plant `who`, "baseline" or "best". If the
        history does not distinguish organs, "stalk" is the sum of all of
        them."""
        self.need_pairs()
        plant: Evaluation = getattr(self, who)
        try:
            profile = plant.profile(_BY_ORGAN)
        except HistoryError:
            return {"stalk": self.number(who, "stalk_fraction")}
        parts = profile.over(plant.estimate("incident").mean)
        return {
            name: interval([part])
            for name, part in parts.items()
            if name != "leaves"
        }

    def headroom(self) -> Estimate:
        """Returns the additional light that the leaves of the best plant would
        absorb if other organs and the soil absorbed nothing: incident (1 -
        reflected) - absorbed. Any canopy of these leaves loses the reflected
        light.

        Each randomisation conserves energy, so the headroom is the light
        absorbed by other organs and the soil, and its standard error is at
        most the sum of theirs. The larger errors of absorbed and reflected
        light cancel.

        Raises HistoryError if there is no such ceiling, or a quantity is
        missing."""
        best = self.best
        if best.row.goals[0].name != "absorbed_par":
            raise HistoryError("the objective is not absorbed PAR alone")
        if self.is_isolated:
            raise HistoryError(
                "an isolated plot receives light from the sides too"
            )
        if best.row.with_axis("scenario"):
            raise HistoryError("the objective is taken over scenarios")
        names = ("incident", "reflected_fraction", *_TAKEN)
        incident, reflected, *taken = map(best.estimate, names)
        return Estimate(
            incident.mean * (1 - reflected.mean) - best.objective.mean,
            incident.mean * sum(part.standard_error for part in taken),
            best.objective.unit,
        )

    def is_saturated(self) -> bool:
        """Returns whether the best plant is within its standard error of the
        ceiling: nearly all light is absorbed, and no plant gains more."""
        error = self.best.objective.standard_error
        return self.headroom().mean <= max(error, _SMALL)
