# SPDX-License-Identifier: Apache-2.0
"""Evaluates plants with the trait values of lines in the cases of a
campaign."""

from __future__ import annotations

import hashlib
import tomllib
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..common.arrays import require_whole
from ..common.compiled import _core
from ..common.processors import processors
from ..common.settings import Settings, format_settings
from ..errors import Error
from ..stand.stand import Stand
from .store import Array, Store
from .traits import Trait

_GENE = "selection_"
"""The prefix of the traits that select adds to a crop."""


class Field:
    """Plants of lines in the cases of a campaign.

    Each trait changes one measure of the campaign's plant. Between measured
    leaves a change is linear in rank, and beyond them constant. Lengths and
    widths change by a factor, angles by a difference. Traits of which the
    trial has no values keep those of the plant."""

    def __init__(
        self,
        campaign: str | Path,
        traits: Sequence[Trait],
        *,
        settings: Settings = (),
        store: Store | None = None,
        threads: int | None = None,
        seed: int | None = None,
        tolerance: float | None = None,
    ) -> None:
        """Makes the stands. seed, tolerance, threads: as for
        `Stand.evaluate`.

        Raises InputError with the problems of the campaign, Error if a trait
        is no measure of its plant."""
        words = format_settings(settings)
        self.traits = tuple(traits)
        self.store = Store() if store is None else store
        self.threads = threads or processors()
        self._seed, self._tolerance = seed, tolerance
        names = _core.case_names(str(campaign), words)
        originals = [
            Stand.from_campaign(campaign, case=index, settings=words)
            for index, (_, replicate) in enumerate(names)
            if replicate <= 1
        ]
        first = tomllib.loads(originals[0].campaign)
        self._ear = _ear_rank(first["plant"]["baseline"])
        self.plant = _measure(originals[0], first, self.traits, self._ear)
        """The traits of the campaign's plant, in their units [traits]."""
        if len({stand.entries["traits"] for stand in originals}) > 1:
            raise Error(
                "the campaign has several sets of traits, of which lines have "
                "none; keep one, with --set "
                '\'traits=[{name="one",free=["height"]}]\''
            )
        text = _with_genes(first, self.traits)
        self.stands = [
            Stand(text, folder=Path(campaign).parent, case=index)
            for index in range(len(originals))
        ]
        self.cases = tuple(x.name.rpartition("_r")[0] for x in originals)
        ((self.objective, sense), *others) = originals[0].objectives.items()
        if others:
            raise Error(
                "the campaign has several objectives; choose one, as with "
                f"--set objective.maximise={self.objective}"
            )
        self.sign = 1 if sense == "maximise" else -1
        units = originals[0].quantities.set_index("name")["unit"]
        self.unit = str(units.get(self.objective, ""))
        self._digests = [
            hashlib.sha256(
                "\0".join(
                    [x.campaign, x.name, x.isa, f"{seed} {tolerance}"]
                ).encode()
            )
            for x in self.stands
        ]

    def genome(self, values: ArrayLike) -> Array:
        """Returns the free genes of the plant with trait values [traits], in
        the units of the measures."""
        wanted = np.asarray(values, float)
        genes = self.stands[0].genes[self.stands[0].free]
        genome = np.array(genes["baseline"], float)
        for measure, at in _by_measure(self.traits).items():
            name = _gene(measure)
            mine = (genes["trait"] == name).to_numpy()
            base, new = self.plant[at], wanted[at]
            is_shift = self.traits[at[0]].unit == "deg"
            change = new - base if is_shift else new / base
            ranks = genes["leaf"].to_numpy()[mine]
            places = [self._rank(self.traits[i].leaf) for i in at]
            order = np.argsort(places)
            genome[mine] = np.interp(
                ranks, np.array(places)[order], change[order]
            )
        return genome

    def evaluate(
        self,
        plants: ArrayLike,
        draws: int = 1,
        *,
        first: int = 0,
        on_progress: Callable[[int, int], object] = lambda done, count: None,
    ) -> Array:
        """Evaluates plants with common random numbers.

        plants: trait values [plants x traits] in the units of the measures.
        draws: number of generations of fields and light, each with the
            randomisations of the campaign; `first` is the first of them.

        Returns the objective [plants x cases x randomisations], negative if
        it is minimised. Raises Error if an evaluation fails."""
        require_whole(draws, "draws", 1, 10**6)
        genomes = [self.genome(x) for x in np.atleast_2d(plants)]
        tasks = [
            (p, c, g)
            for p in range(len(genomes))
            for c in range(len(self.stands))
            for g in range(first, first + draws)
        ]
        done = 0

        def run(task: tuple[int, int, int]) -> Array:
            nonlocal done
            result = self._evaluate_one(genomes[task[0]], *task[1:])
            done += 1
            on_progress(done, len(tasks))
            return result

        with ThreadPoolExecutor(max(1, self.threads)) as pool:
            try:
                results = list(pool.map(run, tasks))
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise
        shape = len(genomes), len(self.stands), -1
        return self.sign * np.array(results).reshape(shape)

    def _evaluate_one(self, genome: Array, case: int, draw: int) -> Array:
        digest = self._digests[case].copy()
        digest.update(genome.tobytes() + str(draw).encode())
        key = digest.hexdigest()
        known = self.store.find(key)
        if known is not None:
            return known
        stand = self.stands[case]
        evaluated = stand.evaluate(
            genome[None],
            [],
            generation=draw,
            seed=self._seed,
            tolerance=self._tolerance,
            threads=1,
        )
        if message := str(evaluated.message.item()):
            raise Error(f"{self.cases[case]}: {message}")
        objective = evaluated.objective_by_randomisation.values[0, 0]
        self.store.add(key, self.cases[case], draw, genome, objective)
        return np.asarray(objective)

    def compare(
        self, path: str | Path, values: ArrayLike
    ) -> tuple[Array, Array]:
        """Evaluates the plant of a file (the best one of a history, a crop
        file) and the plant with trait values, in the same fields and light,
        with the accuracy of finalists.

        Returns the objectives of both [cases x randomisations], negative if
        it is minimised."""
        genome = self.genome(values)
        draws = [
            [numbers[self.objective, 0].draws for numbers in pair]
            for pair in (
                [compared.numbers[1, 0], compared.numbers[0, 0]]
                for compared in (
                    stand.compare(
                        genome,
                        path,
                        seed=self._seed,
                        threads=self.threads,
                    )
                    for stand in self.stands
                )
            )
        ]
        theirs, ours = self.sign * np.array(draws).transpose(1, 0, 2)
        return theirs, ours

    def _rank(self, leaf: str) -> int:
        return _leaf_rank(leaf, self._ear, self._leaves) if leaf else 0

    @property
    def _leaves(self) -> int:
        genes = self.stands[0].genes
        return int(genes["leaf"].max())


def _by_measure(traits: Sequence[Trait]) -> dict[str, list[int]]:
    """Returns the indices of the traits of each measure."""
    groups: dict[str, list[int]] = {}
    for index, trait in enumerate(traits):
        groups.setdefault(trait.measure, []).append(index)
    return groups


def _gene(measure: str) -> str:
    return _GENE + measure.replace(".", "_")


def _with_genes(
    tables: dict[str, Any], traits: Sequence[Trait]
) -> dict[str, Any]:
    """Returns a campaign in which the measures of traits, and nothing else,
    are free."""
    crop = dict(tables["plant"]["baseline"])
    added = []
    for measure, at in _by_measure(traits).items():
        trait = traits[at[0]]
        is_shift = trait.unit == "deg"
        scaled = [measure]
        if measure == "stalk.height":
            scaled.append("leaf.insertion_height")
        added.append(
            {
                "name": _gene(measure),
                "per": "leaf" if trait.leaf else "plant",
                "shifts" if is_shift else "scales": scaled,
                "unit": "deg" if is_shift else "1",
                "range": [-90, 90] if is_shift else [0.01, 100],
            }
        )
    crop["trait"] = [*crop.get("trait", []), *added]
    names = [row["name"] for row in added]
    return {
        **tables,
        "replicates": 1,
        "traits": [{"name": "selection", "free": names}],
        "plant": {**tables["plant"], "baseline": crop, "bounds": "traits"},
    }


def _ear_rank(crop: dict[str, Any]) -> int:
    """Returns the rank of the leaf at the ear, as MeasuredLines finds it in
    src/crop/measured_lines.cpp."""
    for organ in crop.get("organ", []):
        if organ["name"] == "ear" and organ.get("leaf", 0) > 0:
            return int(organ["leaf"])
    return len(crop["leaf"]) * 6 // 10


def _leaf_rank(leaf: str, ear: int, count: int) -> int:
    """Returns the rank of a leaf named "ear", "top" or by ranks from these, as
    "top-1"; the nearest leaf if the plant lacks it. Raises Error for other
    names."""
    for name, rank in (("ear", ear), ("top", count)):
        if leaf.startswith(name):
            try:
                offset = int(leaf.removeprefix(name) or 0)
            except ValueError:
                break
            return min(max(rank + offset, 1), count)
    raise Error(f"there is no leaf '{leaf}'; write it as ear+1 or top-1")


def _measure(
    stand: Stand, tables: dict[str, Any], traits: Sequence[Trait], ear: int
) -> Array:
    """Returns the traits of the campaign's plant in their units. Raises Error
    if it lacks one."""
    crop = tables["plant"]["baseline"]
    leaves = stand.leaves(stand.baseline)
    values = []
    for trait in traits:
        part, _, name = trait.measure.partition(".")
        if part == "leaf":
            if name not in leaves:
                raise Error(f"the plant has no {trait.measure}")
            rank = _leaf_rank(trait.leaf, ear, len(leaves))
            values.append(float(leaves[name].loc[rank]))
            continue
        organs = [x for x in crop.get("organ", []) if x["name"] == part]
        table = organs[0] if organs else crop.get(part, {})
        if not table.get(name):
            raise Error(
                f"the plant of the campaign has no {trait.measure}, which the "
                "trial measures; remove this column, or use another crop file"
            )
        values.append(float(table[name]))
    return np.array(values)
