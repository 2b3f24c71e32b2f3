# SPDX-License-Identifier: Apache-2.0
"""Evaluates the plants of a campaign in this process."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import cached_property
from html import escape
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import numpy as np
import pandas as pd
import tomli_w
import xarray
from numpy.typing import ArrayLike, NDArray

from ..common.arrays import real, require_whole
from ..common.compiled import _core
from ..common.processors import processors
from ..common.settings import Settings, words_of
from ..errors import Error, did_you_mean
from ..history.history import open_history
from ..mesh.geometry import Mesh
from .comparison import Comparison
from .evaluated import Evaluated, dataset_of
from .plants import Plant, case_of_history, compare_plants

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_GENES = (
    "name",
    "trait",
    "leaf",
    "unit",
    "lower",
    "upper",
    "baseline",
    "is_free",
    "is_circular",
)


class Stand:
    """The plants of one case of a campaign and the light on them.

    `Stand(tables)` takes the tables of a campaign file as dictionaries, with
    every key that a file may have; files that it names are looked for in
    `folder`. `Stand.from_campaign` reads such a file. docs/campaign_files.md
    explains the keys.

    Threads may share a stand: evaluations run without the interpreter's lock.
    """

    _case: _core.CaseStand

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
        with open_history(Path(path)) as history:
            return cls._of(
                case_of_history(
                    history, genome, settings=settings, same_isa=same_isa
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

    def __repr__(self) -> str:
        return f"<Stand {'; '.join(f'{k}: {x}' for k, x in self._about())}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th>{escape(k)}</th><td>{escape(x)}</td></tr>"
            for k, x in self._about()
        )
        return f"<table><caption>Stand</caption>{rows}</table>"

    def _about(self) -> list[tuple[str, str]]:
        """Returns the properties that distinguish a stand."""
        wanted = (f"{sense} {name}" for name, sense in self.objectives.items())
        plants = _core.grown_plants(self._case, self.baseline)
        leaves = len(plants.leaves(0)[0][2])
        told = [
            ("case", self.name),
            ("objective", ", ".join(wanted)),
            ("plant", f"{plants.name}, {leaves} leaves"),
            ("genes", f"{self.free.sum()} of {self.free.size} free"),
        ]
        if len(self.components) > 1:
            told.append(("components", ", ".join(self.components)))
        return [*told, ("instruction set", self.isa)]

    @property
    def name(self) -> str:
        """The name of the case."""
        return self._case.name

    @property
    def entries(self) -> dict[str, str]:
        """The entries of the campaign that the case is made of: names of its
        site, day, climate, spacing and traits. A case that is a mean over
        several entries has the first of them."""
        return self._case.entries

    @property
    def isa(self) -> str:
        """The instruction set of the ray tracer."""
        return self._case.isa

    @property
    def campaign(self) -> str:
        """The whole campaign as TOML: every key with its value."""
        return self._case.resolved

    @property
    def warnings(self) -> list[str]:
        """Messages about what may be wrong with the campaign."""
        return self._case.warnings

    @property
    def genes(self) -> pd.DataFrame:
        """A row for each number of a genome, in their order: name, trait, leaf
        (rank from the lowest, 1; 0: not of one leaf), unit, lower, upper,
        baseline, is_free (bred in this case), is_circular (lower and upper are
        the same point)."""
        return pd.DataFrame(self._case.genes, columns=list(_GENES))

    @property
    def baseline(self) -> NDArray[np.float64]:
        """The genome of the baseline plant, [genes]."""
        return np.array(self.genes["baseline"], float)

    @property
    def free(self) -> NDArray[np.bool_]:
        """Whether each gene is bred in this case [genes]."""
        return self._free.copy()

    @property
    def start(self) -> NDArray[np.float64]:
        """The free genes of the baseline [free genes], where a search may
        begin."""
        return self.baseline[self.free]

    @property
    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The lower and the upper bounds of the free genes, [free genes]
        each."""
        free = self.genes[self.free]
        return np.array(free["lower"], float), np.array(free["upper"], float)

    @property
    def objectives(self) -> dict[str, str]:
        """The objectives of the campaign: "maximise" or "minimise" by the name
        of the quantity."""
        return {
            name: "maximise" if is_maximised else "minimise"
            for name, _, is_maximised in self._case.objectives
        }

    @property
    def quantities(self) -> pd.DataFrame:
        """The quantities that evaluations measure: name, unit, meaning, axes,
        is_exact (it has no standard error)."""
        columns = ["name", "unit", "meaning", "axes", "is_exact"]
        rows = [each[: len(columns)] for each in self._case.quantities]
        return pd.DataFrame(rows, columns=columns)

    @property
    def axes(self) -> dict[str, list[Any]]:
        """The labels of each axis of the quantities, by its name."""
        return {name: labels for name, _, _, labels in self._case.axes}

    @property
    def accuracy(self) -> pd.DataFrame:
        """The keys of the campaign that trade speed for accuracy: key, value,
        and values, which `ideotype fidelity` tries, the most accurate
        last."""
        return pd.DataFrame(
            self._case.accuracy, columns=["key", "value", "values"]
        )

    @property
    def components(self) -> list[str]:
        """The names of the components of the field, first the component of the
        campaign's crop."""
        return list(self._case.components)

    def mesh(
        self,
        genome: ArrayLike,
        component: int = 0,
        thermal_time: float | None = None,
    ) -> Mesh:
        """Returns the surfaces of one plant: the foot of the plant is at the
        origin, y along the row, z up [m].

        component: place of the plant's component in `components`.
        thermal_time: age since emergence [deg C d] of a plant that grows;
            without it the plant is full-grown."""
        return Mesh.of(
            *self._case.mesh(self._plants(genome)[0], component, thermal_time)
        )

    def field_mesh(self, genome: ArrayLike) -> Mesh:
        """Returns the surfaces of the first field that evaluations with the
        campaign's seed draw: plants that differ as [field.variation] says,
        over one cell of the field, x across the rows, y along them, z up
        [m]."""
        return Mesh.of(*self._case.field_mesh(self._plants(genome)[0]))

    def crop_file(self, genome: ArrayLike, component: int = 0) -> str:
        """Returns the text of a crop file with this plant as its baseline.

        component: place of the plant's component in `components`."""
        return self._case.crop_text(self._plants(genome)[0], component)

    def leaves(self, genome: ArrayLike, component: int = 0) -> pd.DataFrame:
        """Returns the measures of the leaves of one plant, a row for each
        leaf, whose index is the rank from the lowest leaf, 1: length, width
        and insertion_height [m], insertion_angle, curvature and azimuth [deg],
        and other measures that are not 0. Units are in .attrs["units"].

        component: place of the plant's component in `components`."""
        grown = _core.grown_plants(self._case, self._plants(genome)[0])
        found = grown.leaves(component)
        table = pd.DataFrame({name: values for name, _, values in found})
        table.index = pd.RangeIndex(1, len(table) + 1, name="leaf")
        table.attrs["units"] = {name: unit for name, unit, _ in found}
        return table

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
        _require_numbers(generation, seed)
        if threads is not None:
            require_whole(threads, "threads", 1, 4096)

        def one(genome: NDArray[np.float64]) -> tuple[Any, ...]:
            return self._case.evaluate(
                genome, generation, final, seed, tolerance
            )

        found = _map(one, plants, threads or processors())
        return dataset_of(self._case, found, wanted)

    def evaluate_one(
        self,
        genome: ArrayLike,
        *,
        tolerance: float | None = None,
        seed: int | None = None,
        generation: int = 0,
        final: bool = False,
    ) -> Evaluated:
        """Evaluates one plant in the calling thread, without labels, for
        programs that share plants among threads of their own or measure the
        time of an evaluation. The arguments are those of `evaluate`.

        Raises Error if the plant cannot be evaluated."""
        (plant,) = self._plants(genome)
        _require_numbers(generation, seed)
        is_done, message, objectives, _, violation, numbers = (
            self._case.evaluate(plant, generation, final, seed, tolerance)
        )
        if not is_done:
            raise Error(message)
        return Evaluated(
            np.array(objectives).reshape(-1, 2),
            float(violation),
            np.array(numbers).reshape(-1, 2),
        )

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

    def compare(
        self,
        *plants: ArrayLike | str | PathLike[str],
        names: Sequence[str] = (),
        final: bool = True,
        seed: int | None = None,
        tolerance: float | None = None,
        threads: int | None = None,
    ) -> Comparison:
        """Compares plants with the first plant in the same fields and light;
        the plants may differ in their number of leaves.

        plants: genomes, or paths of crop files, measured leaves (.csv, of one
            or more plants), campaigns (their baseline) and histories (their
            best plant).
        names: names of the plants; several plants of a file keep theirs.
        final, seed, tolerance, threads: arguments of `evaluate`.

        Returns a Comparison, whose `table` has every number with its
        difference from the first plant and paired errors; printing the
        Comparison shows the main numbers.

        Raises Error if there is no plant, or a plant cannot be evaluated."""
        if not plants or (names and len(names) != len(plants)):
            raise Error(
                f"{len(plants)} plants and {len(names)} names are given; give "
                "at least one plant, and as many names or none"
            )
        shown: list[Plant] = []
        for i, plant in enumerate(plants):
            found = self._compared(plant, i)
            if names and len(found) == 1:
                found = [replace(found[0], name=names[i])]
            shown += found
        return compare_plants(
            shown,
            [(self.name, self._case, None)],
            final=final,
            seed=seed,
            tolerance=tolerance,
            threads=threads or processors(),
        )

    def draw(self, *genomes: ArrayLike, names: Sequence[str] = ()) -> Figure:
        """Draws plants from the side and from above, at one scale; without
        plants the baseline. Returns a figure of matplotlib."""
        from ..figures.plants import draw_plants

        shown = genomes or (self.baseline,)
        told = names or [f"plant {i + 1}" for i in range(len(shown))]
        if not genomes and not names:
            told = ["baseline"]
        meshes = [self.mesh(genome) for genome in shown]
        return draw_plants(dict(zip(told, meshes, strict=True)))

    def draw_field(self, genome: ArrayLike | None = None) -> Figure:
        """Draws a field of one plant, or of the baseline, at eye height and
        from above. Returns a figure of matplotlib."""
        from ..figures.field import draw_stand

        plant = self.baseline if genome is None else genome
        return draw_stand(
            self.mesh(plant), tomllib.loads(self.campaign), self.name
        )

    @cached_property
    def _free(self) -> NDArray[np.bool_]:
        return np.array(self.genes["is_free"], bool)

    def _plants(self, genomes: ArrayLike) -> NDArray[np.float64]:
        """Returns the genomes as an array [plants, genes], of which rows of
        histories may end with the numbers of the keys that a search varied."""
        given = np.atleast_2d(real(genomes, "genomes"))
        free = self._free
        sizes = free.size, free.size + self._case.key_count, free.sum()
        if given.ndim != 2 or given.shape[1] not in sizes or not len(given):
            raise Error(
                f"genomes are an array of {np.shape(genomes)}; give "
                f"[plants, {free.size}] for all genes or "
                f"[plants, {free.sum()}] for those that are free, of one plant "
                "or more"
            )
        bad = np.argwhere(~np.isfinite(given))
        if bad.size:
            row, column = map(int, bad[0])
            raise Error(
                f"genomes[{row}, {column}] is {given[row, column]}; numbers "
                "must be finite"
            )
        if given.shape[1] in sizes[:2]:
            return np.ascontiguousarray(given)
        plants = np.tile(self.baseline, (len(given), 1))
        plants[:, free] = given
        return plants

    def _wanted(self, names: Sequence[str] | None) -> list[str]:
        known = [each[0] for each in self._case.quantities]
        if names is None:
            return known
        if isinstance(names, str):
            names = [names]
        for name in names:
            if name not in known:
                raise Error(
                    f"there is no quantity '{name}'"
                    + (
                        did_you_mean(name, known)
                        or "; use some of " + ", ".join(known)
                    )
                )
        return list(names)

    def _compared(
        self, plant: ArrayLike | str | PathLike[str], number: int
    ) -> list[Plant]:
        if isinstance(plant, str | PathLike):
            return Plant.read(plant, self._case)
        genome = self._plants(plant)[0]
        is_baseline = np.array_equal(genome, self.baseline)
        name = "baseline" if is_baseline else f"plant {number + 1}"
        return [Plant(name, _core.grown_plants(self._case, genome))]


def _restored(campaign: str, case: str, isa: str) -> Stand:
    return Stand._of(
        _core.CaseStand.from_history(campaign, "a stand", case, [], [], isa)
    )


def _require_numbers(generation: int, seed: int | None) -> None:
    require_whole(generation, "generation", 0, 2**32 - 1)
    if seed is not None:
        require_whole(seed, "seed", 0, 2**64 - 1)


def _map(one: Any, plants: NDArray[np.float64], threads: int) -> list[Any]:
    if threads <= 1 or len(plants) <= 1:
        return [one(plant) for plant in plants]
    with ThreadPoolExecutor(min(threads, len(plants))) as pool:
        try:
            return list(pool.map(one, plants))
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
