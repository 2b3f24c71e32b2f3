# SPDX-License-Identifier: Apache-2.0
"""Plants of any shape in the same light, their differences from a reference
and their ranks."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

import ideotype._core as _core

from .._errors import Error, did_you_mean
from .._scans.leaf_tables import measured_crops
from ..analysis.reading.estimate import Estimate, difference, relative_gain
from ..analysis.reading.names import distinct_names

Key = tuple[str, int]
"""A number of a plant: the name of a quantity, and the place along the axis of
the quantity, 0 without an axis. Leaves are counted from the highest leaf,
0."""

_OF_PLANT = ("blade", "leaf", "stalk", "sheath", "petiole", "organ")
"""The tables of a crop that describe the shape of a plant."""


@dataclass(frozen=True)
class Plant:
    """A plant, or the plants of several components, with a name."""

    name: str
    core: _core.Plants
    path: str = ""
    """The file of the plant, if it comes from one."""

    @classmethod
    def read(
        cls, path: str | os.PathLike[str], under: _core.CaseStand
    ) -> list[Plant]:
        """Reads a crop file, the crop of a campaign, all plants of measured
        leaves (.csv) or the best plant of a history (.h5). The crop of a
        campaign has the measures of a table that names no crop.

        Raises InputError or HistoryError if the file cannot be read."""
        path = os.fspath(path)
        if path.endswith(".csv"):
            baseline = tomllib.loads(under.resolved)["plant"]["baseline"]
            like = {x: baseline[x] for x in _OF_PLANT if x in baseline}
            return [
                cls(crop.name, crop.core, path)
                for crop in measured_crops(Path(path), otherwise=like)
            ]
        if not path.endswith(".h5"):
            core = _core.read_plant(path)
            return [cls(core.name, core, path)]
        from .._stand import Stand
        from ..analysis import open_history

        with open_history(path) as history:
            best = history.best()
            if best is None:
                raise Error(
                    f"{path}: no generation of this history is complete yet; "
                    "try again later"
                )
            stand = Stand.from_history(
                path, best.row.genome[0], same_isa=False
            )
            campaign = history.attributes["campaign"]
        genome = np.ascontiguousarray(best.row.genome[0])
        core = _core.grown_plants(stand._case, genome)
        return [cls(f"{campaign}/{stand.name}", core, path)]


@dataclass(frozen=True)
class Quantity:
    """A quantity without axes, or along the leaves or layers of height."""

    name: str
    unit: str
    axis: str = ""
    coordinates: tuple[float, ...] = (0,)
    names: tuple[str, ...] = ()
    """The names that the number counts from 1; none if it is a measure."""


@dataclass(frozen=True)
class Comparison:
    """Plants in the light of one or more cases. All plants of a case have the
    same fields and random numbers, so that differences have paired errors; all
    errors are standard errors."""

    plants: tuple[str, ...]
    cases: tuple[str, ...]
    quantities: tuple[Quantity, ...]
    """The quantities, the objectives first. Coordinates are ranks from the
    lowest leaf of the plant with most leaves, or heights [m]."""
    objectives: tuple[str, ...]
    """The names of the objectives."""
    leaves: tuple[int, ...]
    """The number of leaves of each plant."""
    numbers: dict[tuple[int, int], dict[Key, Estimate]] = field(repr=False)
    """The numbers of each plant in each case, with their randomisations."""
    minimised: frozenset[str] = frozenset()
    """The objectives of which the least is best."""
    reference: int = 0
    """The index of the plant from which differences are."""

    @property
    def objective(self) -> Quantity:
        """The first objective."""
        return self.quantities[0]

    def value(self, plant: int, case: int, key: Key) -> Estimate | None:
        """Returns a number of a plant; None if the plant lacks the leaf."""
        return self.numbers[plant, case].get(key)

    def difference(self, plant: int, case: int, key: Key) -> Estimate | None:
        """Returns the difference of a plant's number from the reference's
        number."""
        return self._paired(difference, plant, case, key)

    def gain(self, plant: int, case: int, key: Key) -> Estimate | None:
        """Returns the difference relative to the reference [%]; None if the
        number of the reference is 0."""
        own = self.value(self.reference, case, key)
        if own is None or own.mean == 0:
            return None
        return self._paired(relative_gain, plant, case, key)

    def _paired(
        self, of_both: Any, plant: int, case: int, key: Key
    ) -> Estimate | None:
        both = (
            self.value(plant, case, key),
            self.value(self.reference, case, key),
        )
        return None if None in both else of_both(*both)

    def means(self, name: str) -> NDArray[np.float64]:
        """Returns the means of a quantity without axes [plant, case]."""
        return np.array(
            [
                [
                    self.numbers[p, c][name, 0].mean
                    for c in range(len(self.cases))
                ]
                for p in range(len(self.plants))
            ]
        )

    def ranks(self, name: str) -> NDArray[np.float64]:
        """Returns the ranks of the plants in each case [plant, case]; 1 is the
        least of a minimised objective, or else the largest. Equal plants share
        the mean of their ranks."""
        means = pd.DataFrame(self.means(name))
        return means.rank(ascending=name in self.minimised).to_numpy()

    def rank_correlation(self, name: str) -> NDArray[np.float64]:
        """Returns Spearman's correlation between the ranks in each two cases;
        NaN where all plants of a case are equal."""
        ranks = pd.DataFrame(self.ranks(name))
        return ranks.corr().to_numpy()

    def pairs(
        self, name: str, case: int
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Returns the difference of each two plants, first less second, and
        the standard errors of the differences [plant, plant]."""
        own = [self.numbers[p, case][name, 0] for p in range(len(self.plants))]
        means = np.array([x.mean for x in own])
        counts = {len(x.draws) for x in own}
        if len(counts) == 1 and min(counts) > 1:
            draws = np.array([x.draws for x in own])
            scatter = [np.std(x - draws, axis=1, ddof=1) for x in draws]
            errors = np.array(scatter) / np.sqrt(draws.shape[1])
        else:
            squares = np.array([x.standard_error for x in own]) ** 2
            errors = np.sqrt(squares[:, None] + squares)
        return means[:, None] - means, errors

    @property
    def table(self) -> pd.DataFrame:
        """A row for each plant, case and number: plant, case, quantity, unit,
        leaf (rank from the lowest of its plant), leaf_from_top (1 is the
        highest), layer_m, mean, standard_error, and the difference from the
        reference with its paired error, also in per cent."""
        return pd.DataFrame(
            [
                self._line(p, c, quantity, place)
                for p in range(len(self.plants))
                for c in range(len(self.cases))
                for quantity in self.quantities
                for place in self._places(p, quantity)
            ]
        ).astype({"leaf": "Int64", "leaf_from_top": "Int64"})

    def _places(self, plant: int, quantity: Quantity) -> Sequence[int]:
        """Returns the places along an axis that a plant has, the lowest leaf
        first."""
        if quantity.axis == "leaf":
            return range(self.leaves[plant])[::-1]
        return range(len(quantity.coordinates))

    def _line(
        self, plant: int, case: int, quantity: Quantity, place: int
    ) -> dict[str, Any]:
        key = quantity.name, place
        is_leaf, is_layer = (quantity.axis == x for x in ("leaf", "layer"))
        line: dict[str, Any] = {
            "plant": self.plants[plant],
            "case": self.cases[case],
            "quantity": quantity.name,
            "unit": quantity.unit,
            "leaf": self.leaves[plant] - place if is_leaf else None,
            "leaf_from_top": place + 1 if is_leaf else None,
            "layer_m": quantity.coordinates[place] if is_layer else None,
        }
        for name, found in (
            ("", self.value(plant, case, key)),
            ("difference", self.difference(plant, case, key)),
            ("percent", self.gain(plant, case, key)),
        ):
            line[name or "mean"] = found.mean if found else None
            error = f"{name}_standard_error".lstrip("_")
            line[error] = found.standard_error if found else None
        return line

    def __str__(self) -> str:
        from .compared_text import page_of

        return page_of(self)

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        from .compared_text import html_of

        return html_of(self)


def compare_plants(
    plants: Sequence[Plant],
    stands: Sequence[tuple[str, _core.CaseStand, int | None]],
    *,
    final: bool = True,
    seed: int | None = None,
    tolerance: float | None = None,
    threads: int = 1,
    reference: str = "",
    tell: Any = lambda done, count: None,
) -> Comparison:
    """Evaluates plants in stands of cases. Each stand comes with its name and,
    if a single scenario is meant, the place of the scenario. Differences are
    from the plant named `reference`, by default the first. `tell` gets the
    number of finished evaluations and the number of all evaluations.

    Raises Error if there is no such reference or a plant cannot be
    evaluated."""
    names = distinct_names(
        [plant.name for plant in plants], [plant.path for plant in plants]
    )
    compared_with = _index_of(reference, names) if reference else 0
    reach = max(plant.core.reach for plant in plants)
    leaves = [len(plant.core.leaves(0)[0][2]) for plant in plants]
    tasks = [(p, c) for c in range(len(stands)) for p in range(len(plants))]
    numbers: dict[tuple[int, int], dict[Key, Estimate]] = {}
    told: list[tuple[Any, ...]] = []
    longest = int(np.argmax(leaves))

    def one(task: tuple[int, int]) -> None:
        p, c = task
        name, under, scenario = stands[c]
        try:
            stand = _core.PlantStand(under, plants[p].core, reach, scenario)
            found = stand.evaluate(0, final, seed, tolerance)
        except Error as error:
            raise Error(f"{plants[p].name} in {name}: {error}") from error
        numbers[task] = _numbers_of(stand, found)
        if p == longest and c == 0:
            told.append((quantities_of(stand), stand.objectives))
        tell(len(numbers), len(tasks))

    with ThreadPoolExecutor(max(1, min(threads, len(tasks)))) as pool:
        try:
            list(pool.map(one, tasks))
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    quantities, objectives = told[0]
    return Comparison(
        tuple(names),
        tuple(name for name, *_ in stands),
        quantities,
        tuple(name for name, *_ in objectives),
        tuple(leaves),
        numbers,
        frozenset(
            name for name, _, is_maximised in objectives if not is_maximised
        ),
        compared_with,
    )


def _index_of(name: str, names: Sequence[str]) -> int:
    if name in names:
        return list(names).index(name)
    some = ", ".join(names[:5]) + (", ..." if len(names) > 5 else "")
    raise Error(
        f"there is no plant {name} to compare with; the plants are {some}"
        f"{did_you_mean(name, names)}"
    )


def quantities_of(stand: _core.CaseStand) -> tuple[Quantity, ...]:
    """Returns the quantities that are compared, the objectives first."""
    objectives = [Quantity(name, unit) for name, unit, _ in stand.objectives]
    names = {each.name for each in objectives}
    coordinates = {axis: tuple(at) for axis, _, _, at in stand.axes}
    numbers, profiles = [], []
    for name, unit, _, axes, _, counted in stand.quantities:
        if not axes and name not in names:
            numbers.append(Quantity(name, unit, names=tuple(counted)))
        elif axes in (["leaf"], ["layer"]) and _are_numbers(
            coordinates[axes[0]]
        ):
            profiles.append(
                Quantity(name, unit, axes[0], coordinates[axes[0]])
            )
    return (*objectives, *numbers, *profiles)


def _are_numbers(labels: Sequence[Any]) -> bool:
    """Returns whether an axis has numbers: leaves of several components have
    names instead."""
    return not any(isinstance(label, str) for label in labels)


def _numbers_of(
    stand: _core.PlantStand, found: tuple[Any, ...]
) -> dict[Key, Estimate]:
    """Returns all numbers that are compared, with their randomisations."""
    objectives, draws, every, by_randomisation = found
    sizes = {axis: len(at) for axis, _, _, at in stand.axes}
    numbers: dict[Key, Estimate] = {}
    begin = 0
    for name, unit, _, axes, *_ in stand.quantities:
        size = int(np.prod([sizes[axis] for axis in axes]))
        own = slice(begin, begin + size)
        begin += size
        if axes not in ([], ["leaf"], ["layer"]):
            continue
        for place, (mean, error), values in zip(
            range(size), every[own], by_randomisation[:, own].T
        ):
            at = size - 1 - place if axes == ["leaf"] else place
            numbers[name, at] = _estimate(mean, error, unit, values)
    for (name, unit, _), (mean, error), values in zip(
        stand.objectives, objectives, draws
    ):
        numbers[name, 0] = _estimate(mean, error, unit, values)
    return numbers


def _estimate(
    mean: float, error: float, unit: str, draws: NDArray[np.float64]
) -> Estimate:
    known = draws if np.isfinite(draws).all() else np.empty(0)
    return Estimate(float(mean), float(error), unit, known)
