# SPDX-License-Identifier: Apache-2.0
"""Properties of a stand: genes, objectives, quantities and shapes of
plants."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pandas as pd
from numpy.typing import ArrayLike, NDArray

import ideotype._core as _core

from ._arrays import real
from ._errors import Error, did_you_mean
from ._geometry import Mesh

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


class StandCase:
    """The part of a stand that knows its case and the shapes of plants."""

    _case: _core.CaseStand

    @property
    def name(self) -> str:
        """The name of the case."""
        return self._case.name

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
        return np.array(self.genes["is_free"], bool)

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

    def crop_file(self, genome: ArrayLike, component: int = 0) -> str:
        """Returns the text of a crop file with this plant as its baseline.

        component: place of the plant's component in `components`."""
        return self._case.crop_text(self._plants(genome)[0], component)

    def _plants(self, genomes: ArrayLike) -> NDArray[np.float64]:
        """Returns the genomes as an array [plants, genes], of which rows of
        histories may end with the numbers of the keys that a search varied."""
        given = np.atleast_2d(real(genomes, "genomes"))
        free = self.free
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
