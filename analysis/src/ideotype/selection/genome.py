# SPDX-License-Identifier: Apache-2.0
"""Genomes of inbred lines at many loci, their crosses and doubled haploids."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ..common.arrays import require_file
from ..errors import Error
from .covariances import Matrix, square_root
from .genetics import Population

Alleles = NDArray[np.int8]
"""Alleles 0 or 1 of homozygous lines [lines x loci]."""

CHROMOSOMES = 10
"""Of maize."""
MORGANS = 1.5
"""The genetic length of a chromosome; that of maize is 1.4 to 2.4 (E)."""
LOCI = 50
"""The smallest default number of loci of a chromosome."""


@dataclass(frozen=True)
class GeneticMap:
    """The recombination between neighbouring loci."""

    recombination: Matrix
    """The fraction of recombinants between each locus and the one before it;
    0.5 at the begin of a chromosome [loci]."""

    @classmethod
    def from_positions(
        cls, chromosome: Sequence[object], morgans: Matrix
    ) -> GeneticMap:
        """Makes a map of loci in the order of their chromosomes, without
        interference (Haldane 1919)."""
        apart = np.abs(np.diff(morgans))
        fraction = (1 - np.exp(-2 * apart)) / 2
        names = np.asarray(chromosome)
        fraction[names[1:] != names[:-1]] = 0.5
        return cls(np.concatenate([[0.5], fraction]))

    @classmethod
    def even(
        cls, loci: int = LOCI, chromosomes: int = CHROMOSOMES
    ) -> GeneticMap:
        """Makes a map of equally spaced loci."""
        places = np.tile((np.arange(loci) + 0.5) * MORGANS / loci, chromosomes)
        return cls.from_positions(
            np.repeat(np.arange(chromosomes), loci).tolist(), places
        )

    def doubled_haploids(
        self,
        mother: Alleles,
        father: Alleles,
        count: int,
        random: np.random.Generator,
    ) -> Alleles:
        """Draws doubled haploids from the cross of two inbred lines [count x
        loci]."""
        switches = random.random((count, len(mother))) < self.recombination
        phase = np.cumsum(switches, axis=1) % 2 == 1
        return np.where(phase, mother, father).astype(np.int8)


@dataclass(frozen=True)
class Founders:
    """Inbred lines with additive effects of their loci on traits."""

    names: tuple[str, ...]
    alleles: Alleles
    effects: Matrix
    """Half of the difference between homozygotes [loci x traits]."""
    origin: Matrix
    """The trait values of a plant halfway between homozygotes at all loci
    [traits]."""
    map: GeneticMap

    def values(self, alleles: Alleles) -> Matrix:
        """Returns the genetic values of lines [lines x traits]."""
        return self.origin + (2.0 * alleles - 1) @ self.effects


def draw_founders(
    population: Population,
    count: int,
    random: np.random.Generator,
    *,
    genetic_map: GeneticMap | None = None,
) -> Founders:
    """Draws lines with the mean and the covariances G of a population. If it
    has at least `count` lines with values, the founders are its first lines
    with their predictions, stretched to G; else their values are drawn.

    Alleles are independent with frequency 0.5. Effects are drawn with the
    correlations of G, and moved as little as possible (least squares) so that
    the founders have exactly their values. By default there are ten loci for
    each line, so that this hardly increases the genic variance.

    Raises Error if there are fewer loci than lines."""
    places = genetic_map or GeneticMap.even(max(LOCI, count))
    loci, traits = len(places.recombination), len(population.traits)
    if loci < count:
        raise Error(f"{loci} loci are too few for {count} lines; use more")
    if count <= traits + 1:
        raise Error(
            f"{count} founders are too few for {traits} traits; use more"
        )
    is_known = len(population.lines) >= count
    if is_known:
        names = population.lines[:count]
        given = population.values[:count]
    else:
        names = tuple(f"founder {i + 1}" for i in range(count))
        given = random.standard_normal((count, traits))
    values = population.mean + _with_covariance(given, population.genetic)
    alleles = random.integers(0, 2, (count, loci), dtype=np.int8)
    root = square_root(population.genetic)
    effects = random.standard_normal((loci, traits)) @ root / np.sqrt(loci)
    signs = 2.0 * alleles - 1
    rest = values - population.mean - signs @ effects
    effects += signs.T @ np.linalg.solve(signs @ signs.T, rest)
    return Founders(names, alleles, effects, population.mean, places)


def _with_covariance(values: Matrix, wanted: Matrix) -> Matrix:
    """Returns values with mean 0 and exactly these covariances. Of all linear
    changes of their deviations, in units of standard deviations, this one
    turns them the least."""
    deviation = np.sqrt(np.diag(wanted))
    present = np.cov(values.T)
    scale = np.sqrt(np.diag(present))
    spread = np.where(scale > 0, scale, 1)
    middle = square_root(present / np.outer(spread, spread))
    inverse = np.linalg.pinv(middle, rcond=1e-9)
    outer = np.outer(deviation, deviation)
    correlation = np.divide(
        wanted, outer, out=np.zeros_like(wanted), where=outer > 0
    )
    turn = inverse @ square_root(middle @ correlation @ middle) @ inverse
    centred = (values - values.mean(axis=0)) / spread
    return np.asarray(centred @ turn * deviation)


def read_founders(
    markers: str | Path, effects: str | Path, population: Population
) -> Founders:
    """Reads the user's lines and effects.

    markers: CSV with one row for each marker: marker, chromosome,
        position_cM, and a column for each line with 0 or 2 (or 0 or 1), the
        copies of an allele.
    effects: CSV with one row for each marker: marker, and a column for each
        trait by its name, half of the difference between homozygotes in the
        unit of pages, such as cm.

    Raises Error with all problems of the files."""
    problems: list[str] = []
    tables = []
    for path, needed in (
        (Path(markers), {"marker", "chromosome", "position_cM"}),
        (Path(effects), {"marker", *(t.name for t in population.traits)}),
    ):
        require_file(path)
        try:
            table = pd.read_csv(path, comment="#")
        except (OSError, ValueError) as error:
            raise Error(f"{path}: {error}") from None
        problems += [
            f"{path}: there is no column '{name}'"
            for name in sorted(needed - set(table.columns))
        ]
        tables.append(table)
    if problems:
        raise Error("\n".join(problems))
    table, sizes = tables
    lines = [
        name
        for name in table.columns
        if name not in ("marker", "chromosome", "position_cM")
    ]
    table = table.sort_values(["chromosome", "position_cM"], kind="stable")
    absent = set(table["marker"]) ^ set(sizes["marker"])
    if absent or any(x["marker"].duplicated().any() for x in tables):
        problems.append(
            f"{effects}: markers differ from those of {markers}, such as "
            f"{', '.join(sorted(map(str, absent))[:3])}; give each one row"
        )
    names = [t.name for t in population.traits]
    genotypes, positions, matrix = (
        part.apply(pd.to_numeric, errors="coerce").to_numpy(float)
        for part in (table[lines], table[["position_cM"]], sizes[names])
    )
    levels = set(np.unique(genotypes).tolist())
    if not (levels <= {0, 1} or levels <= {0, 2}):
        problems.append(
            f"{markers}: lines are inbred; write 0 or 2 copies, and impute "
            "missing ones"
        )
    for where, numbers in (
        (f"{markers}: position_cM", positions),
        (f"{effects}: {', '.join(names)}", matrix),
    ):
        if not np.isfinite(numbers).all():
            problems.append(
                f"{where} must be finite numbers; fill empty cells, and use "
                "decimal points"
            )
    if problems:
        raise Error("\n".join(problems))
    alleles = (genotypes > 0).T.astype(np.int8)
    factors = np.array([t.factor for t in population.traits])
    order = pd.Index(sizes["marker"]).get_indexer(table["marker"])
    matrix = matrix[order] / factors
    origin = population.mean - (2.0 * alleles - 1).mean(axis=0) @ matrix
    return Founders(
        tuple(lines),
        alleles,
        matrix,
        origin,
        GeneticMap.from_positions(
            table["chromosome"].tolist(), positions[:, 0] / 100
        ),
    )
