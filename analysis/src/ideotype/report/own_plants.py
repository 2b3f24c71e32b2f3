# SPDX-License-Identifier: Apache-2.0
"""Plants of the user, evaluated like the finalists of a case."""

from __future__ import annotations

import tempfile
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import tomli_w

from ..history.case import Case
from ..history.estimate import Estimate
from ..history.file import HistoryError
from ..history.quantity import Profile
from ..mesh.geometry import Mesh

if TYPE_CHECKING:
    from ..stand.plants import Plant
    from ..stand.stand import Stand

_BY_LEAF = "absorbed_by_leaf"


@dataclass(frozen=True)
class OwnPlant:
    """A plant of the user in the light of a case."""

    name: str
    mesh: Mesh
    objective: Estimate
    _by_leaf: Profile | None

    def profile(self, name: str) -> Profile:
        """Returns the light that the leaves of the plant absorb.

        Raises HistoryError for other quantities, and if leaves are not
        distinguished."""
        if name != _BY_LEAF or self._by_leaf is None:
            raise HistoryError(f"{self.name} has no {name}")
        return self._by_leaf


def evaluate_own_plants(
    case: Case, paths: Sequence[Path]
) -> Iterator[OwnPlant]:
    """Evaluates plants in the fields and the light in which the finalists of a
    case were evaluated. Each path is a crop file, measured leaves (.csv), a
    digitised plant (.obj, .ply, .dat, or .csv of midribs) or a history, of
    which the best plant is taken. A digitised plant is evaluated as the crop
    that `ideotype fit` makes of it.

    Raises Error if a plant cannot be read or evaluated."""
    if not paths:
        return
    from ..stand.plants import compare_plants
    from ..stand.stand import Stand

    stand = Stand.from_history(case.best_history.path, same_isa=False)
    plants = [plant for path in paths for plant in _read(path, stand)]
    comparison = compare_plants(plants, [(stand.name, stand._case, None)])
    for k, (name, plant) in enumerate(zip(comparison.plants, plants)):
        values = [
            comparison.value(k, 0, (_BY_LEAF, place))
            for place in reversed(range(comparison.leaves[k]))
        ]
        objective = comparison.value(k, 0, (comparison.objective.name, 0))
        assert objective is not None
        yield OwnPlant(
            name,
            Mesh.of(*plant.core.mesh(stand._case, 0)),
            objective,
            _profile([each for each in values if each]),
        )


def _profile(values: Sequence[Estimate]) -> Profile | None:
    if not values:
        return None
    means, errors = (
        np.array([getattr(value, name) for value in values])
        for name in ("mean", "standard_error")
    )
    ranks = np.arange(1, len(values) + 1)
    return Profile(ranks, values[0].unit, means, errors)


def _read(path: Path, stand: Stand) -> list[Plant]:
    # The imports need the compiled module; the rest of a report does not.
    from ..stand.measured.fitted import readable_crop
    from ..stand.measured.plant_sources import is_digitised, read_plant
    from ..stand.plants import Plant

    if not is_digitised(path):
        return Plant.read(path, stand._case)
    like = tomllib.loads(stand.crop_file(stand.baseline))
    crop = readable_crop(read_plant(path), like, path.stem)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"{path.stem}.toml"
        file.write_text(tomli_w.dumps(crop), encoding="utf-8")
        return Plant.read(file, stand._case)
