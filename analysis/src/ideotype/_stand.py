# SPDX-License-Identifier: Apache-2.0
"""Evaluates the plants of a campaign in this process."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from os import PathLike
from pathlib import Path
from typing import Any, Self

import numpy as np
import tomli_w
import xarray
from numpy.typing import ArrayLike, NDArray

import ideotype._core as _core

from ._arrays import real, require_whole
from ._evaluated import dataset_of
from ._settings import Settings, words_of
from ._views.stand_views import StandViews, processors


class Stand(StandViews):
    """The plants of one case of a campaign and the light on them.

    `Stand(tables)` takes the tables of a campaign file as dictionaries, with
    every key that a file may have; files that it names are looked for in
    `folder`. `Stand.from_campaign` reads such a file. docs/campaign_files.md
    explains the keys.

    Threads may share a stand: evaluations run without the interpreter's lock.
    """

    def __init__(
        self,
        tables: Mapping[str, Any],
        *,
        folder: str | PathLike[str] = ".",
        case: int = 0,
        settings: Settings = (),
        isa: str | None = None,
    ) -> None:
        """Makes the stand. Raises InputError with all problems of the tables;
        line numbers count in `tomli_w.dumps(tables)`."""
        self._case = _core.CaseStand.from_text(
            tomli_w.dumps(tables),
            os.path.join(os.fspath(folder), "campaign.toml"),
            case,
            words_of(settings),
            isa or "",
        )

    @classmethod
    def from_campaign(
        cls,
        path: str | PathLike[str],
        *,
        case: int = 0,
        settings: Settings = (),
        isa: str | None = None,
    ) -> Self:
        """Returns the stand of a case of a campaign file, in which `settings`
        replace keys of the file.

        `isa` is the instruction set of the ray tracer, by default the widest
        set of this processor. Raises InputError with all problems of the file,
        Error if there is no such file or case."""
        return cls._of(
            _core.CaseStand.from_file(
                os.fspath(path), case, words_of(settings), isa or ""
            )
        )

    @classmethod
    def from_history(
        cls,
        path: str | PathLike[str],
        genome: ArrayLike = (),
        *,
        settings: Settings = (),
        same_isa: bool = True,
    ) -> Self:
        """Returns the stand that the plants of a history were evaluated in. A
        sensitivity study and `[[search.keys]]` also vary keys of the campaign:
        the stand has the keys of the row with this genome, without it those of
        the campaign; genomes of rows are evaluated with their own keys.

        `settings`: replace keys of the history's campaign, such as
        {"plant.organs": []}.

        `same_isa`: whether to use the instruction set of the history, without
        which light differs in its last digits, or else the widest set of this
        processor.

        Raises the errors of `ideotype.open_history`, and Error if this
        processor lacks the instruction set."""
        from .analysis import open_history

        with open_history(Path(path)) as history:
            return cls._of(
                _core.CaseStand.from_history(
                    history.campaign("resolved"),
                    os.fspath(path),
                    str(history.attributes["case"]),
                    real(genome, "genome").tolist(),
                    words_of(settings),
                    str(history.attributes["isa"]) if same_isa else "",
                )
            )

    @classmethod
    def _of(cls, case: _core.CaseStand) -> Self:
        stand = cls.__new__(cls)
        stand._case = case
        return stand

    def __reduce__(self) -> tuple[Any, ...]:
        """Makes copies, also in other processes, evaluate plants to the same
        bits."""
        return _restored, (self.campaign, self.name, self.isa)

    def evaluate(
        self,
        genomes: ArrayLike,
        quantities: Sequence[str] | None = None,
        *,
        tolerance: float | None = None,
        seed: int | None = None,
        generation: int = 0,
        final: bool = False,
        threads: int | None = None,
    ) -> xarray.Dataset:
        """Evaluates the light in a stand of each of the given plants.

        genomes: [plants, genes], or [plants, free genes] with the other genes
            of the baseline; one plant may be [genes]. Numbers have the units
            of `genes`. Rows of a history whose search varied keys of its
            campaign end with their numbers. Numbers beyond their bounds are
            evaluated unchanged; a measure that a plant cannot have is moved to
            its limit.
        quantities: names of `quantities`; all if not given.
        tolerance: relative standard error of the leaves' light, at most 0.05,
            with as few paths as needed; by default the campaign's accuracy.
        seed: seed of the random numbers, in the place of the campaign's.
        generation: number of the generation whose fields and random numbers
            are taken; plants of one generation share them. The result has the
            same bits as a row of a history with this seed and generation.
        final: whether plants are evaluated like finalists, as in `ideotype
            compare`: with the accuracy of [final] and many fields.
        threads: number of threads that share the plants, by default the number
            of processors. The result does not depend on it.

        Returns a Dataset over `plant` and the axes of the quantities: each
        quantity and, unless it is exact, NAME_standard_error; `violation` of
        the constraints; `objective_by_randomisation`; and `message`, "" or the
        reason why an evaluation failed, whose numbers are then NaN.

        Raises Error if a name or number is impossible."""
        plants = self._plants(genomes)
        wanted = self._wanted(quantities)
        require_whole(generation, "generation", 0, 2**32 - 1)
        if seed is not None:
            require_whole(seed, "seed", 0, 2**64 - 1)
        if threads is not None:
            require_whole(threads, "threads", 1, 4096)

        def one(genome: NDArray[np.float64]) -> tuple[Any, ...]:
            return self._case.evaluate(
                genome, generation, final, seed, tolerance
            )

        found = _map(one, plants, threads or processors())
        return dataset_of(self._case, found, wanted)

    def light_at(
        self,
        genome: ArrayLike,
        height: ArrayLike,
        position: ArrayLike = np.nan,
        *,
        fields: int = 16,
        points: int = 256,
    ) -> xarray.Dataset:
        """Evaluates the light that level sensors among the plants receive from
        above, like a ceptometer that is held along the rows.

        height: height of each sensor above the soil [m].
        position: position of each sensor across the rows, from a row [m]; NaN:
            the mean over all positions.
        fields: number of fields that are drawn (2 or more); the light is their
            mean.
        points: number of points on each sensor in each field.

        Returns a Dataset over `sensor` and `instant`: `incident` is the light
        on level ground above the canopy [W m-2 of PAR], `fraction` is the part
        of this light on the sensor, with `fraction_standard_error`, and `hour`
        is the time on the clock of the site [h]."""
        heights, positions = np.broadcast_arrays(
            np.atleast_1d(real(height, "height")),
            np.atleast_1d(real(position, "position")),
        )
        hours, incident, means, errors = self._case.light_on_sensors(
            self._plants(genome)[0],
            heights.tolist(),
            positions.tolist(),
            fields,
            points,
        )
        over = ("sensor", "instant")
        return xarray.Dataset(
            {
                "fraction": (over, means),
                "fraction_standard_error": (over, errors),
                "incident": ("instant", incident),
            },
            {
                "hour": ("instant", hours),
                "height": ("sensor", heights),
                "position": ("sensor", positions),
            },
        )


def _restored(campaign: str, case: str, isa: str) -> Stand:
    return Stand._of(
        _core.CaseStand.from_history(campaign, "a stand", case, [], [], isa)
    )


def _map(one: Any, plants: NDArray[np.float64], threads: int) -> list[Any]:
    if threads <= 1 or len(plants) <= 1:
        return [one(plant) for plant in plants]
    with ThreadPoolExecutor(min(threads, len(plants))) as pool:
        try:
            return list(pool.map(one, plants))
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
