# SPDX-License-Identifier: Apache-2.0
"""Shows a stand and its plants, and compares plants in it."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Sequence
from dataclasses import replace
from html import escape
from os import PathLike
from typing import TYPE_CHECKING

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike

import ideotype._core as _core

from .._errors import Error
from .._stand_case import StandCase
from .compared import Comparison, Plant, compare_plants

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class StandViews(StandCase):
    """The part of a stand that shows its plants."""

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

    def _compared(
        self, plant: ArrayLike | str | PathLike[str], number: int
    ) -> list[Plant]:
        if isinstance(plant, str | PathLike):
            return Plant.read(plant, self._case)
        genome = self._plants(plant)[0]
        is_baseline = np.array_equal(genome, self.baseline)
        name = "baseline" if is_baseline else f"plant {number + 1}"
        return [Plant(name, _core.grown_plants(self._case, genome))]

    def draw(self, *genomes: ArrayLike, names: Sequence[str] = ()) -> Figure:
        """Draws plants from the side and from above, at one scale; without
        plants the baseline. Returns a figure of matplotlib."""
        from ..analysis.figures.plant_drawing import draw_plants

        shown = genomes or (self.baseline,)
        told = names or [f"plant {i + 1}" for i in range(len(shown))]
        if not genomes and not names:
            told = ["baseline"]
        meshes = [self.mesh(genome) for genome in shown]
        return draw_plants(dict(zip(told, meshes, strict=True)))

    def draw_field(self, genome: ArrayLike | None = None) -> Figure:
        """Draws a field of one plant, or of the baseline, at eye height and
        from above. Returns a figure of matplotlib."""
        from ..analysis.figures.field import draw_stand

        plant = self.baseline if genome is None else genome
        return draw_stand(
            self.mesh(plant), tomllib.loads(self.campaign), self.name
        )


def processors() -> int:
    """Returns the number of processors that this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # Some systems lack this call.
        return os.cpu_count() or 1
