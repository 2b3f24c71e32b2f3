# SPDX-License-Identifier: Apache-2.0
"""The talk with one open page of `ideotype play`."""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._arrays import real
from .._errors import Error
from .bench import Bench, Genome, Place
from .conditions import Conditions
from .improve import EVALUATIONS, Improvement
from .levers import levers_of
from .numbers import message_of
from .shapes import neighbours_of, panels_of, plant_of

REFINING = 0.9
"""The time in which an answer is refined [s]."""

MOST = 48
"""The largest number of evaluations of one plant."""

Send = Callable[[dict[str, Any]], None]


@dataclass(frozen=True)
class Shown:
    """The plants and numbers that a page shows."""

    genome: Genome
    reference: Genome
    conditions: Conditions
    component: int


class Session:
    """Answers the changes of one page; a later change ends the work for an
    earlier one."""

    def __init__(self, bench: Bench, send: Send) -> None:
        self._bench = bench
        self._send = send
        self._newest = -1
        self._tasks: set[asyncio.Task] = set()
        self._improvement: Improvement | None = None
        self._drawn: tuple[object, dict[str, Any]] = (None, {})

    def greet(self) -> None:
        """Tells the page all that does not change."""
        bench = self._bench
        opened, place = bench.opened, bench.place(bench.own)
        levers = levers_of(place.stand, opened.base)
        objectives = place.stand.objectives
        known = {each["name"] for each in place.layout.scalars}
        wanted = [
            *(name for name in objectives if name in known),
            *("carbon_balance", "net_assimilation", "absorbed_par"),
            "water_use_efficiency",
        ]
        self._send(
            {
                "kind": "hello",
                "title": opened.title,
                "about": opened.about,
                "levers": levers,
                "genome": opened.genome.tolist(),
                "baseline": place.stand.baseline.tolist(),
                "conditions": vars(bench.own),
                "quantities": place.layout.scalars,
                "goals": [n for n in dict.fromkeys(wanted) if n in known],
                "components": place.stand.components,
                "days": bench.growth.days if bench.growth else 0,
                "has_panel_table": "panel" in opened.base,
                "evaluations": EVALUATIONS,
            }
        )

    def hear(self, message: dict[str, Any]) -> None:
        """Obeys a message of the page. Raises Error if it makes no sense."""
        kind = message.get("kind")
        if kind == "stop":
            self._stop()
            return
        number = message.get("number")
        if not isinstance(number, int):
            raise Error("a message has no number")
        shown = self.shown(message)
        if kind == "show":
            self._newest = number
            self._start(self._answer(number, shown))
        elif kind == "improve":
            self._stop()
            goal = str(message.get("goal"))
            self._improvement = Improvement(self._bench, shown, goal)
            self._start(self._improve(number, self._improvement))
        else:
            raise Error(f"{kind!r:.40}: there is no such message")

    def shown(self, message: dict[str, Any]) -> Shown:
        """Returns what a message shows. Raises Error if it is impossible."""
        bench = self._bench
        conditions = message.get("conditions", {})
        component = message.get("component", 0)
        count = len(bench.place(bench.own).stand.components)
        if not isinstance(conditions, dict) or component not in range(count):
            raise Error("conditions or component: no such thing")
        genome = self._genome(message.get("genome"))
        reference = message.get("reference")
        return Shown(
            genome,
            self._genome(reference)
            if reference is not None
            else bench.place(bench.own).stand.baseline,
            bench.own.changed(conditions),
            component,
        )

    def _genome(self, numbers: Any) -> Genome:
        found = real(numbers, "genome")
        if found.shape != self._bench.opened.genome.shape:
            raise Error("genome: it is not one of this plant")
        if not np.all(np.abs(found) < 1e4):
            raise Error("genome: its numbers are impossible")
        return found

    def close(self) -> None:
        """Ends all work for the page."""
        self._newest += 1
        self._stop()
        for task in self._tasks:
            task.cancel()

    def _stop(self) -> None:
        if self._improvement:
            self._improvement.is_ended = True

    def _start(self, work: Any) -> None:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _answer(self, number: int, shown: Shown) -> None:
        begun = time.monotonic()
        loop, bench = asyncio.get_running_loop(), self._bench

        def fast(work: Callable[..., Any], *words: Any) -> Any:
            def unless_stale() -> Any:
                if self._newest == number:
                    return work(*words)
                return None

            return loop.run_in_executor(bench.fast, unless_stale)

        def tell(kind: str, content: dict[str, Any]) -> None:
            if self._newest == number:
                self._send({"kind": kind, "number": number, **content})

        try:
            place = await fast(bench.place, shown.conditions)
            if place is None:
                return
            picture = await fast(self._picture, place, shown)
            tell("picture", picture or {})
            await self._refine(number, shown, place, begun, fast, tell)
        except Error as error:
            tell("problem", {"text": str(error)})

    async def _refine(
        self,
        number: int,
        shown: Shown,
        place: Place,
        begun: float,
        fast: Callable[..., Any],
        tell: Callable[[str, dict[str, Any]], None],
    ) -> None:
        """Evaluates the plant and its reference with more and more random
        numbers, and tells each time what is known."""
        bench = self._bench
        loop = asyncio.get_running_loop()
        mine = place.samples(shown.genome)
        its = place.samples(shown.reference)

        async def sample(run: Callable[..., Any], genome: Genome, seed: int,
                         known: dict[int, Any]) -> None:  # fmt: skip
            if seed not in known and self._newest == number:
                found = await run(place.evaluate, genome, seed)
                if found is not None:
                    known[seed] = found

        def slow(work: Callable[..., Any], *words: Any) -> Any:
            def unless_stale() -> Any:
                return work(*words) if self._newest == number else None

            return loop.run_in_executor(bench.slow, unless_stale)

        told = 0.0
        for seed in range(1, MOST + 1):
            late = time.monotonic() - begun > REFINING and seed > 1
            if late and seed not in mine.by_seed:
                break
            await sample(fast, shown.genome, seed, mine.by_seed)
            now = time.monotonic()
            seeds = [s for s in range(1, seed + 1) if s in mine.by_seed]
            if seeds and (seed <= 2 or now - told > 0.12):
                tell("numbers", message_of(place.layout, mine, its, seeds))
                told = now
            await sample(slow, shown.reference, seed, its.by_seed)
            if self._newest != number:
                return
        seeds = sorted(mine.by_seed)
        last = message_of(place.layout, mine, its, seeds)
        tell("numbers", {**last, "is_final": True})

    def _picture(self, place: Place, shown: Shown) -> dict[str, Any]:
        bench, now = self._bench, shown.conditions
        growth = bench.growth if now.when == "season" else None

        def draw(genome: Genome) -> dict[str, Any]:
            return plant_of(
                place.stand, genome, shown.component, growth, now.age
            )

        # The plant that it is compared with seldom changes.
        key = shown.reference.tobytes(), shown.component, now.when, now.age
        if self._drawn[0] != key:
            self._drawn = key, draw(shown.reference)
        return {
            "plants": [draw(shown.genome), self._drawn[1]],
            "neighbours": neighbours_of(now),
            "panels": panels_of(now, bench.opened.base),
            "direction": now.direction,
            "ground": 1 / now.density,
            "date": growth.date(now.age) if growth and now.age else "",
        }

    async def _improve(self, number: int, work: Improvement) -> None:
        loop = asyncio.get_running_loop()

        def tell(content: dict[str, Any]) -> None:
            loop.call_soon_threadsafe(
                self._send, {"kind": "improved", "number": number, **content}
            )

        with contextlib.suppress(asyncio.CancelledError):
            try:
                await loop.run_in_executor(None, work.run, tell)
            except Error as error:
                tell({"is_final": True, "problem": str(error)})
