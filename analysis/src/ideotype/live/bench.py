# SPDX-License-Identifier: Apache-2.0
"""The stands and threads that evaluate plants for live pages."""

from __future__ import annotations

import os
import threading
from collections import OrderedDict
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..common.processors import processors
from ..errors import Error
from ..stand.stand import Stand
from .conditions import Conditions, Tables, make_tables
from .numbers import Array, Layout, Samples
from .opened import Opened
from .rough import coarsen
from .shapes import Growth, grows

Genome = NDArray[np.float64]

TOLERANCE = 0.05
"""The relative standard error of the leaves' light in one evaluation."""

_ROUGH = {"fields": 1, "randomisations": 8}
"""The accuracy of one evaluation. Further evaluations, each in a separate
field, refine the mean."""

_CAREFUL = {"fields": 4, "randomisations": 16}

_STANDS, _PLANTS = 12, 12
"""The numbers of stands, and of plants in each, that are remembered."""


@dataclass
class Place:
    """A stand under given conditions, with the evaluations of plants in it."""

    stand: Stand
    layout: Layout
    spread: Array
    """The relative standard deviations among fields that one evaluation does
    not include [numbers]."""
    plants: OrderedDict[bytes, Samples] = field(default_factory=OrderedDict)

    def samples(self, genome: Genome) -> Samples:
        """Returns the evaluations of a plant."""
        key = genome.tobytes()
        samples = self.plants.setdefault(key, Samples(self.spread))
        self.plants.move_to_end(key)
        while len(self.plants) > _PLANTS:
            self.plants.popitem(last=False)
        return samples

    def evaluate(self, genome: Genome, seed: int) -> Array:
        """Returns the numbers of an evaluation [quantities, value and standard
        error]. Raises Error if the plant cannot be evaluated."""
        return self.stand.evaluate_one(
            genome, seed=seed, tolerance=TOLERANCE
        ).numbers


@dataclass(frozen=True)
class Shown:
    """The plants and numbers that a page shows."""

    genome: Genome
    reference: Genome
    conditions: Conditions
    component: int


def evaluate_coarse(place: Place, layout: Layout, genome: Array) -> Array:
    """Returns the numbers of a plant in the coarse stand of a place, in the
    layout of another stand; numbers that the coarse stand lacks or divides
    differently are NaN."""
    known = place.samples(genome).by_seed
    if 1 not in known:
        known[1] = place.evaluate(genome, 1)
    return layout.like(place.layout, known[1])


class Bench:
    """Evaluates plants of an opened campaign for all pages.

    One thread answers changes, and a second thread evaluates the reference
    plant; other threads refine at a lower priority, so that answers need not
    wait."""

    def __init__(self, opened: Opened) -> None:
        self.opened = opened
        self.own = opened.conditions
        self._growths: dict[int, Growth] = {}
        plants = opened.base["plant"], *opened.base.get("component", [])
        self.is_plastic = any(
            "plasticity" in plant.get(key, {})
            for plant in plants
            for key in ("baseline", "crop")
        )
        count = processors()
        self.fast = ThreadPoolExecutor(1, "answer")
        self.second = ThreadPoolExecutor(1, "compare")
        self.slow = ThreadPoolExecutor(
            count, "refine", initializer=lower_priority
        )
        self.threads = count
        self._places: OrderedDict[tuple[bool, Conditions], Place | None]
        self._places = OrderedDict()
        self._lock = threading.Lock()
        self.place(self.own)

    def base(self, now: Conditions) -> Tables:
        """Returns the campaign with the season of some conditions. Raises Error
        if there is none."""
        if now.season >= len(self.opened.seasons):
            raise Error(
                f"there is no season {now.season}; choose one of the list"
            )
        return {**self.opened.base, **self.opened.seasons[now.season]}

    def has_days(self) -> bool:
        """Returns whether plants can be evaluated on clear days: soil that
        dries, grain and prices need a season."""
        try:
            self.place(replace(self.own, when="day"))
        except Error:
            return False
        return True

    def growth(self, now: Conditions) -> Growth | None:
        """Returns the plant that grows in the season of some conditions."""
        if now.season not in self._growths and grows(self.opened.base):
            self._growths[now.season] = Growth(self.base(now))
        return self._growths.get(now.season)

    def place(self, now: Conditions) -> Place:
        """Returns the stand under given conditions. Raises InputError if the
        conditions are impossible."""
        found = self._place(now, False)
        assert found
        return found

    def coarse(self, now: Conditions) -> Place | None:
        """Returns the stand for coarse evaluations under given conditions, or
        None if the conditions need no coarse stand. Raises InputError if the
        conditions are impossible."""
        return self._place(now, True)

    def _place(self, now: Conditions, is_coarse: bool) -> Place | None:
        key = is_coarse, normalise_conditions(now, self.own)
        with self._lock:
            if key in self._places:
                self._places.move_to_end(key)
                return self._places[key]
        place: Place | None = None
        tables: Tables | None = self._tables(key[1], _ROUGH)
        if is_coarse and tables:
            tables = coarsen(tables)
        if tables:
            stand = Stand(tables)
            layout = Layout(stand)
            spread = layout.spread_of_fields(tables["field"])
            place = Place(stand, layout, spread)
        with self._lock:
            place = self._places.setdefault(key, place)
            while len(self._places) > _STANDS:
                self._places.popitem(last=False)
        return place

    def coarse_pair(
        self, place: Place, layout: Layout, shown: Shown
    ) -> tuple[Array, Array]:
        """Returns the numbers of the plant that is shown and of its reference,
        as coarse_numbers() does, side by side in two threads."""
        reference = self.second.submit(
            evaluate_coarse, place, layout, shown.reference
        )
        return evaluate_coarse(place, layout, shown.genome), reference.result()

    def careful(self, now: Conditions) -> Stand:
        """Returns a stand that evaluates each plant in several fields."""
        return Stand(self._tables(now, _CAREFUL))

    def _tables(self, now: Conditions, light: dict[str, int]) -> Tables:
        tables = make_tables(self.base(now), self.own, now)
        return {**tables, "light": tables["light"] | light}

    def map(self, work: Callable[..., object], *many: Iterable[Any]) -> list:
        """Distributes calls over all threads except the answering thread."""
        return list(self.slow.map(work, *many))

    def close(self) -> None:
        """Ends the threads after the running evaluations."""
        for pool in (self.fast, self.second, self.slow):
            pool.shutdown(cancel_futures=True)


def normalise_conditions(now: Conditions, original: Conditions) -> Conditions:
    """Returns conditions that are equal if they lead to equal stands."""
    same = replace(now, age=0)
    if now.when == "season":
        same = replace(same, day=original.day, latitude=original.latitude)
    else:
        same = replace(same, season=0)
    if now.when != "hour":
        same = replace(same, hour=0)
    if not now.panels:
        same = replace(
            same,
            panel_height=original.panel_height,
            panel_width=original.panel_width,
            panel_rows=original.panel_rows,
        )
    return same


def lower_priority() -> None:
    """Gives this thread the lowest priority, if the system can."""
    if hasattr(os, "setpriority"):
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), 10)
