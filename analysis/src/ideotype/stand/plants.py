# SPDX-License-Identifier: Apache-2.0
"""Reads plants from files of any kind and compares them in the same light."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..common.arrays import real
from ..common.compiled import _core
from ..common.settings import Settings, format_settings
from ..errors import Error, did_you_mean
from ..history.estimate import Estimate
from ..history.history import History, open_history
from ..history.names import distinct_names
from .comparison import Comparison, Key, Quantity
from .measured.leaf_tables import measured_crops

_OF_PLANT = ("blade", "leaf", "stalk", "sheath", "petiole", "organ")
"""The tables of a crop file that define the shape of a plant."""


@dataclass(frozen=True)
class Plant:
    """A named plant, or the plants of several components."""

    name: str
    core: _core.Plants
    path: str = ""
    """The file of the plant, if it comes from one."""

    @classmethod
    def read(
        cls, path: str | os.PathLike[str], under: _core.CaseStand
    ) -> list[Plant]:
        """Reads a crop file, the crop of a campaign, all plants of a table of
        measured leaves (.csv) or the best plant of a history (.h5). The crop
        of `under` completes a table that names no crop.

        Raises InputError or HistoryError if the file cannot be read, Error if
        a history has no complete generation."""
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
        with open_history(path) as history:
            best = history.best()
            if best is None:
                raise Error(
                    f"{path}: no generation of this history is complete yet; "
                    "try again later"
                )
            genome = np.ascontiguousarray(best.row.genome[0])
            case = restore_stand(history, genome, same_isa=False)
            campaign = history.attributes["campaign"]
        core = _core.grown_plants(case, genome)
        return [cls(f"{campaign}/{case.name}", core, path)]


def restore_stand(
    history: History,
    genome: ArrayLike = (),
    *,
    settings: Settings = (),
    same_isa: bool = True,
) -> _core.CaseStand:
    """Returns the compiled stand of a history; the arguments are those of
    `Stand.from_history`."""
    return _core.CaseStand.from_history(
        history.campaign("resolved"),
        str(history.path),
        str(history.attributes["case"]),
        real(genome, "genome").tolist(),
        format_settings(settings),
        str(history.attributes["isa"]) if same_isa else "",
    )


def compare_plants(
    plants: Sequence[Plant],
    stands: Sequence[tuple[str, _core.CaseStand, int | None]],
    *,
    final: bool = True,
    seed: int | None = None,
    tolerance: float | None = None,
    threads: int = 1,
    reference: str = "",
    on_progress: Any = lambda done, count: None,
) -> Comparison:
    """Evaluates plants in the stands of cases.

    stands: name, stand and index of the scenario (None: all) of each case.
    final, seed, tolerance, threads: arguments of `Stand.evaluate`.
    reference: plant to which differences refer, by default the first.
    on_progress: function of the number of finished evaluations and the number
        of all evaluations.

    Raises Error if there is no such reference or an evaluation fails."""
    names = distinct_names(
        [plant.name for plant in plants], [plant.path for plant in plants]
    )
    compared_with = _find_index(reference, names) if reference else 0
    reach = max(plant.core.reach for plant in plants)
    leaves = [len(plant.core.leaves(0)[0][2]) for plant in plants]
    tasks = [(p, c) for c in range(len(stands)) for p in range(len(plants))]
    numbers: dict[tuple[int, int], dict[Key, Estimate]] = {}
    descriptions: list[tuple[Any, ...]] = []
    longest = int(np.argmax(leaves))

    def evaluate_task(task: tuple[int, int]) -> None:
        p, c = task
        name, under, scenario = stands[c]
        try:
            stand = _core.PlantStand(under, plants[p].core, reach, scenario)
            evaluation = stand.evaluate(0, final, seed, tolerance)
        except Error as error:
            raise Error(f"{plants[p].name} in {name}: {error}") from error
        numbers[task] = _make_numbers(stand, evaluation)
        if p == longest and c == 0:
            descriptions.append((list_quantities(stand), stand.objectives))
        on_progress(len(numbers), len(tasks))

    with ThreadPoolExecutor(max(1, min(threads, len(tasks)))) as pool:
        try:
            list(pool.map(evaluate_task, tasks))
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    quantities, objectives = descriptions[0]
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


def _find_index(name: str, names: Sequence[str]) -> int:
    if name in names:
        return list(names).index(name)
    some = ", ".join(names[:5]) + (", ..." if len(names) > 5 else "")
    raise Error(
        f"there is no plant {name} to compare with; the plants are {some}"
        f"{did_you_mean(name, names)}"
    )


def list_quantities(stand: _core.CaseStand) -> tuple[Quantity, ...]:
    """Returns the compared quantities, the objectives first."""
    objectives = [Quantity(name, unit) for name, unit, _ in stand.objectives]
    names = {objective.name for objective in objectives}
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
    """Returns whether an axis has numbers as labels; leaves of several
    components have names."""
    return not any(isinstance(label, str) for label in labels)


def _make_numbers(
    stand: _core.PlantStand, evaluation: tuple[Any, ...]
) -> dict[Key, Estimate]:
    """Returns the compared numbers of an evaluation with their
    randomisations."""
    objectives, draws, estimates, by_randomisation = evaluation
    sizes = {axis: len(at) for axis, _, _, at in stand.axes}
    numbers: dict[Key, Estimate] = {}
    begin = 0
    for name, unit, _, axes, *_ in stand.quantities:
        size = int(np.prod([sizes[axis] for axis in axes]))
        span = slice(begin, begin + size)
        begin += size
        if axes not in ([], ["leaf"], ["layer"]):
            continue
        for i, (mean, error), values in zip(
            range(size), estimates[span], by_randomisation[:, span].T
        ):
            index = size - 1 - i if axes == ["leaf"] else i
            numbers[name, index] = _estimate(mean, error, unit, values)
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
