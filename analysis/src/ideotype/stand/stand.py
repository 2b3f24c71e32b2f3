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
from ..common.settings import Settings, format_settings
from ..errors import Error, did_you_mean
from ..history.history import open_history
from ..mesh.geometry import Mesh
from .comparison import Comparison
from .evaluated import Evaluated, make_dataset
from .plants import Plant, compare_plants, restore_stand
from .soil import Control, answer_by

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
    """The plants of one case of a campaign, with their field and light.

    `Stand(tables)` takes the tables of a campaign file as dictionaries, with
    the keys of docs/campaign_files.md; paths are relative to `folder`.
    `Stand.from_campaign` reads a campaign file.

    Threads may share a stand: evaluations release the global interpreter lock.
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
        """Makes the stand. The arguments are those of `from_campaign`.

        Raises InputError with all problems of the tables; line numbers refer
        to `tomli_w.dumps(tables)`."""
        self._case = _core.CaseStand.from_text(
            tomli_w.dumps(tables),
            os.path.join(os.fspath(folder), "campaign.toml"),
            case,
            format_settings(settings),
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
        """Returns the stand of a case of a campaign file.

        case: index of the case, as `ideotype check --cases` lists them.
        settings: values that replace those of the file, such as
            {"light.paths": 1024}.
        isa: instruction set of the ray tracer, by default the widest of this
            processor.

        Raises InputError with all problems of the file, Error if there is no
        such file or case."""
        return cls._wrap(
            _core.CaseStand.from_file(
                os.fspath(path), case, format_settings(settings), isa or ""
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
        """Returns the stand in which the plants of a history were evaluated.

        genome: genome of a row [genes]. Sensitivity studies and
            `[[search.keys]]` also vary keys of the campaign; the stand has the
            keys of this row, by default those of the campaign. Genomes of rows
            are evaluated with their respective keys.
        settings: values that replace those of the campaign, such as
            {"plant.organs": []}.
        same_isa: whether to use the instruction set of the history, so that
            results are bitwise equal, or the widest of this processor.

        Raises the errors of `ideotype.open_history`, and Error if this
        processor lacks the instruction set."""
        with open_history(Path(path)) as history:
            return cls._wrap(
                restore_stand(
                    history, genome, settings=settings, same_isa=same_isa
                )
            )

    @classmethod
    def _wrap(cls, case: _core.CaseStand) -> Self:
        stand = cls.__new__(cls)
        stand._case = case
        return stand

    def __reduce__(self) -> tuple[Any, ...]:
        """Makes copies, also in other processes, that evaluate plants to
        bitwise equal results."""
        return _restore, (self.campaign, self.name, self.isa)

    def __repr__(self) -> str:
        return f"<Stand {'; '.join(f'{k}: {x}' for k, x in self._about())}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th>{escape(k)}</th><td>{escape(x)}</td></tr>"
            for k, x in self._about()
        )
        return f"<table><caption>Stand</caption>{rows}</table>"

    def _about(self) -> list[tuple[str, str]]:
        """Returns the properties by which users distinguish stands."""
        wanted = (f"{sense} {name}" for name, sense in self.objectives.items())
        plants = _core.grown_plants(self._case, self.baseline)
        leaves = len(plants.leaves(0)[0][2])
        properties = [
            ("case", self.name),
            ("objective", ", ".join(wanted)),
            ("plant", f"{plants.name}, {leaves} leaves"),
            ("genes", f"{self.free.sum()} of {self.free.size} free"),
        ]
        if len(self.components) > 1:
            properties.append(("components", ", ".join(self.components)))
        return [*properties, ("instruction set", self.isa)]

    @property
    def name(self) -> str:
        """The name of the case."""
        return self._case.name

    @property
    def entries(self) -> dict[str, str]:
        """The entries of the campaign of which the case consists: the names of
        site, day, climate, spacing and traits. A case that is a mean over
        several entries has the first of them."""
        return self._case.entries

    @property
    def isa(self) -> str:
        """The instruction set of the ray tracer."""
        return self._case.isa

    @property
    def campaign(self) -> str:
        """The resolved campaign as TOML: every key with its value."""
        return self._case.resolved

    @property
    def warnings(self) -> list[str]:
        """Warnings about the campaign."""
        return self._case.warnings

    @property
    def genes(self) -> pd.DataFrame:
        """One row for each gene, in the order of a genome: name, trait, leaf
        (rank from 1 for the lowest; 0: not of one leaf), unit, lower, upper,
        baseline, is_free (varied in this case), is_circular (lower and upper
        are the same point)."""
        return pd.DataFrame(self._case.genes, columns=list(_GENES))

    @property
    def baseline(self) -> NDArray[np.float64]:
        """The genome of the baseline plant [genes]."""
        return np.array(self.genes["baseline"], float)

    @property
    def free(self) -> NDArray[np.bool_]:
        """Whether a search of this case varies each gene [genes]."""
        return self._free.copy()

    @property
    def start(self) -> NDArray[np.float64]:
        """The free genes of the baseline [free genes], a starting point of
        searches."""
        return self.baseline[self.free]

    @property
    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The lower and the upper bounds of the free genes, each
        [free genes]."""
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
        """The quantities of an evaluation: name, unit, meaning, axes, is_exact
        (without a standard error)."""
        columns = ["name", "unit", "meaning", "axes", "is_exact"]
        rows = [row[: len(columns)] for row in self._case.quantities]
        return pd.DataFrame(rows, columns=columns)

    @property
    def axes(self) -> dict[str, list[Any]]:
        """The labels along each axis of the quantities, by its name."""
        return {name: labels for name, _, _, labels in self._case.axes}

    @property
    def accuracy(self) -> pd.DataFrame:
        """The keys of the campaign that trade speed for accuracy: key, value,
        and the values that `ideotype fidelity` measures, the most accurate
        last."""
        return pd.DataFrame(
            self._case.accuracy, columns=["key", "value", "values"]
        )

    @property
    def components(self) -> list[str]:
        """The names of the components of the field, the crop of the campaign
        first."""
        return list(self._case.components)

    def mesh(
        self,
        genome: ArrayLike,
        component: int = 0,
        thermal_time: float | None = None,
    ) -> Mesh:
        """Returns the surfaces of one plant [m], with its foot at the origin,
        y along the row and z up.

        genome: [genes] or [free genes].
        component: index of the component in `components`.
        thermal_time: thermal time from emergence of a growing plant
            [deg C d]; by default the plant is full-grown."""
        return Mesh.of(
            *self._case.mesh(self._plants(genome)[0], component, thermal_time)
        )

    def field_mesh(self, genome: ArrayLike) -> Mesh:
        """Returns the surfaces of the first field that evaluations sample with
        the seed of the campaign [m]: one cell of the field, with the
        within-line variation of [field.variation], x across the rows, y along
        them and z up."""
        return Mesh.of(*self._case.field_mesh(self._plants(genome)[0]))

    def crop_file(self, genome: ArrayLike, component: int = 0) -> str:
        """Returns the text of a crop file with this plant as its baseline.

        genome: [genes] or [free genes].
        component: index of the component in `components`."""
        return self._case.crop_text(self._plants(genome)[0], component)

    def leaves(self, genome: ArrayLike, component: int = 0) -> pd.DataFrame:
        """Returns the measures of the leaves of one plant, one row for each
        leaf, indexed by rank from 1 for the lowest: length, width and
        insertion_height [m], insertion_angle, curvature and azimuth [deg], and
        other measures that are not 0. Units are in .attrs["units"].

        genome: [genes] or [free genes].
        component: index of the component in `components`."""
        grown = _core.grown_plants(self._case, self._plants(genome)[0])
        measures = grown.leaves(component)
        table = pd.DataFrame({name: values for name, _, values in measures})
        table.index = pd.RangeIndex(1, len(table) + 1, name="leaf")
        table.attrs["units"] = {name: unit for name, unit, _ in measures}
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
        """Evaluates a uniform or variable stand of each of the given plants.

        genomes: [plants, genes], or [plants, free genes] with the other genes
            of the baseline; one plant may be [genes]. Units are those of
            `genes`. Rows of a history with varied keys of the campaign end
            with the values of these keys. Values beyond the bounds are
            evaluated unchanged; an impossible measure is moved to its limit.
        quantities: names of quantities, by default all of `quantities`.
        tolerance: relative standard error of the light absorbed by leaves, at
            most 0.05, reached with the fewest paths; by default the accuracy
            of the campaign.
        seed: seed of the random numbers, by default that of the campaign.
        generation: number of the generation. Plants of one generation have
            the same fields and common random numbers. Results are bitwise
            equal to the row of a history with this seed and generation.
        final: whether to evaluate plants like finalists, as `ideotype compare`
            does: with the accuracy of [final] and many fields.
        threads: number of threads, by default the number of processors.
            Results do not depend on it.

        Returns a Dataset over `plant` and the axes of the quantities, with
        each quantity and, unless it is exact, NAME_standard_error; the
        `violation` of the constraints; `objective_by_randomisation`; and
        `message`, "" or the reason for a failure. The numbers of failed
        evaluations are NaN.

        Raises Error if a name or number is invalid."""
        plants = self._plants(genomes)
        wanted = self._wanted(quantities)
        _require_numbers(generation, seed)
        if threads is not None:
            require_whole(threads, "threads", 1, 4096)

        def evaluate_plant(genome: NDArray[np.float64]) -> tuple[Any, ...]:
            return self._case.evaluate(
                genome, generation, final, seed, tolerance
            )

        evaluations = _map(evaluate_plant, plants, threads or processors())
        return make_dataset(self._case, evaluations, wanted)

    def evaluate_one(
        self,
        genome: ArrayLike,
        *,
        tolerance: float | None = None,
        seed: int | None = None,
        generation: int = 0,
        final: bool = False,
    ) -> Evaluated:
        """Evaluates one plant in the calling thread, without labels: for
        programs that manage threads themselves or measure the time of an
        evaluation. The arguments are those of `evaluate`.

        Raises Error if the evaluation fails."""
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

    def season(
        self,
        genome: ArrayLike,
        control: Control | None = None,
    ) -> pd.DataFrame:
        """Runs the days of the season with soil that dries (`[soil]` of the
        campaign), for the mean of all randomisations of an evaluation, in the
        first scenario of the case.

        genome: [genes] or [free genes].
        control: called in the morning of each day with a dictionary of its
            numbers, those of the result, in which fluxes are 0 and the water
            of the soil is that of the morning. It may return `stress`,
            transpiration over potential transpiration (0 to 1), instead of the
            program's soil, and `irrigation` [mm] instead of the campaign's.

        Returns one row for each day: `date`, `thermal_time` [deg C d], `rain`,
        `irrigation`, `potential_transpiration` (with open stomata),
        `potential_evaporation` (of wet soil below the canopy),
        `transpiration`, `evaporation`, `drainage` and `runoff` [mm],
        `root_depth` [m], and in the evening `soil_water`, `depletion` and
        `evaporable_depletion` [mm], with the largest `soil_water`,
        `available`.

        Raises Error if the campaign has no soil, or the answer is out of
        range."""
        days = self._case.season(
            self._plants(genome)[0], control and answer_by(control)
        )
        table = pd.DataFrame(days)
        table["date"] = pd.to_datetime(table["date"])
        return table

    def light_at(
        self,
        genome: ArrayLike,
        height: ArrayLike,
        position: ArrayLike = np.nan,
        *,
        fields: int = 16,
        points: int = 256,
    ) -> xarray.Dataset:
        """Computes the light on level sensors within the canopy, such as a
        ceptometer held along the rows.

        genome: [genes] or [free genes].
        height: height above the soil [sensors] [m].
        position: distance across the rows from a row [sensors] [m]; NaN: mean
            over all positions.
        fields: number of sampled fields (2 or more), over which the light is
            averaged.
        points: number of points on each sensor in each field.

        Returns a Dataset over `sensor` and `instant`: `incident`, the PAR on
        level ground above the canopy [W m-2]; `fraction`, the fraction of it
        that reaches the sensor, with `fraction_standard_error`; and `hour` on
        the clock of the site [h].

        Raises Error if shapes disagree or a number is invalid."""
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
        """Compares plants with the first plant in the same fields and light.
        Plants may have different leaf counts.

        plants: genomes, or paths of crop files, measured leaves (.csv, of one
            or more plants), campaigns (their baseline) and histories (their
            best plant).
        names: names of the plants; several plants of a file keep theirs.
        final, seed, tolerance, threads: arguments of `evaluate`.

        Returns a Comparison. Its `table` has every number with its difference
        from the first plant and paired standard errors; `print` shows the main
        numbers.

        Raises Error if there is no plant, or an evaluation fails."""
        if not plants or (names and len(names) != len(plants)):
            raise Error(
                f"{len(plants)} plants and {len(names)} names are given; give "
                "at least one plant, and as many names or none"
            )
        shown: list[Plant] = []
        for i, plant in enumerate(plants):
            plants_given = self._read_plants(plant, i)
            if names and len(plants_given) == 1:
                plants_given = [replace(plants_given[0], name=names[i])]
            shown += plants_given
        return compare_plants(
            shown,
            [(self.name, self._case, None)],
            final=final,
            seed=seed,
            tolerance=tolerance,
            threads=threads or processors(),
        )

    def draw(self, *genomes: ArrayLike, names: Sequence[str] = ()) -> Figure:
        """Draws plants, by default the baseline, from the side and from above
        at one scale. Returns a figure of matplotlib."""
        from ..figures.plants import draw_plants

        shown = genomes or (self.baseline,)
        labels = names or [f"plant {i + 1}" for i in range(len(shown))]
        if not genomes and not names:
            labels = ["baseline"]
        meshes = [self.mesh(genome) for genome in shown]
        return draw_plants(dict(zip(labels, meshes, strict=True)))

    def draw_field(self, genome: ArrayLike | None = None) -> Figure:
        """Draws a field of one plant, by default the baseline, at eye height
        and from above. Returns a figure of matplotlib."""
        from ..figures.field import draw_stand

        plant = self.baseline if genome is None else genome
        return draw_stand(
            self.mesh(plant), tomllib.loads(self.campaign), self.name
        )

    @cached_property
    def _free(self) -> NDArray[np.bool_]:
        return np.array(self.genes["is_free"], bool)

    def _plants(self, genomes: ArrayLike) -> NDArray[np.float64]:
        """Returns the genomes as an array [plants, genes]. Rows of histories
        may end with the values of varied keys."""
        given = np.atleast_2d(real(genomes, "genomes"))
        free = self._free
        sizes = free.size, free.size + self._case.key_count, free.sum()
        if given.ndim != 2 or given.shape[1] not in sizes or not len(given):
            raise Error(
                f"genomes are an array of {np.shape(genomes)}; give "
                f"[plants, {free.size}] for all genes or "
                f"[plants, {free.sum()}] for the free genes of one plant or "
                "more"
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
        known = [name for name, *_ in self._case.quantities]
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

    def _read_plants(
        self, plant: ArrayLike | str | PathLike[str], number: int
    ) -> list[Plant]:
        if isinstance(plant, str | PathLike):
            return Plant.read(plant, self._case)
        genome = self._plants(plant)[0]
        is_baseline = np.array_equal(genome, self.baseline)
        name = "baseline" if is_baseline else f"plant {number + 1}"
        return [Plant(name, _core.grown_plants(self._case, genome))]


def _restore(campaign: str, case: str, isa: str) -> Stand:
    return Stand._wrap(
        _core.CaseStand.from_history(campaign, "a stand", case, [], [], isa)
    )


def _require_numbers(generation: int, seed: int | None) -> None:
    require_whole(generation, "generation", 0, 2**32 - 1)
    if seed is not None:
        require_whole(seed, "seed", 0, 2**64 - 1)


def _map(call: Any, plants: NDArray[np.float64], threads: int) -> list[Any]:
    if threads <= 1 or len(plants) <= 1:
        return [call(plant) for plant in plants]
    with ThreadPoolExecutor(min(threads, len(plants))) as pool:
        try:
            return list(pool.map(call, plants))
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
