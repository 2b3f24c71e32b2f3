# SPDX-License-Identifier: Apache-2.0
"""The exchange of messages with one open page of `ideotype play`."""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections.abc import Awaitable, Callable
from concurrent.futures import Executor
from typing import Any

import numpy as np

from ..common.arrays import real
from ..decision.worth import PRICE_UNITS
from ..errors import Error
from .bench import Bench, Genome, Place, Shown, evaluate_coarse
from .improve import EVALUATIONS, Improvement
from .levers import make_levers
from .numbers import Samples, make_message
from .rough import Anchor
from .shapes import make_plant, place_modules, place_neighbours

REFINING = 0.9
"""The time in which an answer is refined [s]."""

MOST = 48
"""The largest number of evaluations of one plant."""

Send = Callable[[dict[str, Any]], None]


class Session:
    """Answers the changes of one page; a later change cancels the work for an
    earlier one."""

    def __init__(self, bench: Bench, send: Send) -> None:
        self._bench = bench
        self._send = send
        self._newest = -1
        self._tasks: set[asyncio.Task] = set()
        self._improvement: Improvement | None = None
        self._drawn: tuple[object, dict[str, Any]] = (None, {})
        self._anchor: Anchor | None = None

    def greet(self) -> None:
        """Sends the page all data that do not change."""
        bench = self._bench
        opened, place = bench.opened, bench.place(bench.own)
        levers = make_levers(place.stand, opened.base)
        growth = bench.growth(bench.own)
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
                "map": opened.map,
                "days": growth.days if growth else 0,
                "has_days": bench.has_days(),
                "seasons": [
                    season["climate"][0]["name"]
                    for season in opened.seasons
                    if season
                ],
                "prices": PRICE_UNITS if "prices" in opened.base else {},
                "has_panel_table": "panel" in opened.base,
                "evaluations": EVALUATIONS,
            }
        )

    def hear(self, message: dict[str, Any]) -> None:
        """Acts on a message of the page. Raises Error if the message is
        invalid."""
        kind = message.get("kind")
        if kind == "stop":
            self._stop()
            return
        number = message.get("number")
        if type(number) is not int:
            raise Error("a message has no number; send increasing numbers")
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
            raise Error(
                f"unknown kind of message {kind!r:.40}; load the page again"
            )

    def shown(self, message: dict[str, Any]) -> Shown:
        """Returns the plants of a message. Raises Error for a bad message."""
        bench = self._bench
        conditions = message.get("conditions", {})
        component = message.get("component", 0)
        count = len(bench.place(bench.own).stand.components)
        is_component = type(component) is int and 0 <= component < count
        if not isinstance(conditions, dict) or not is_component:
            raise Error(
                "a message has unknown conditions or an unknown component; "
                "load the page again"
            )
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
        genome = real(numbers, "genome")
        if genome.shape != self._bench.opened.genome.shape:
            raise Error(
                "the genome in a message is not one of this plant; load the "
                "page again"
            )
        if not np.all(np.abs(genome) < 1e4):
            raise Error(
                "the genome in a message has impossible numbers; load the "
                "page again"
            )
        return genome

    def close(self) -> None:
        """Ends all work for the page."""
        self._newest += 1
        if self._improvement:
            self._improvement.drop()
        for task in self._tasks:
            task.cancel()

    def _stop(self) -> None:
        if self._improvement:
            self._improvement.is_ended = True

    def _start(self, work: Any) -> None:
        task = asyncio.create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._end)

    def _end(self, task: asyncio.Task) -> None:
        """Answers a page even if its work has failed for an unknown reason."""
        self._tasks.discard(task)
        if not task.cancelled() and (error := task.exception()):
            self._send(
                {
                    "kind": "problem",
                    "text": f"this plant cannot be evaluated ({error!r:.200}); "
                    "undo the last change, or load the page again",
                }
            )

    async def _answer(self, number: int, shown: Shown) -> None:
        begun, bench = time.monotonic(), self._bench

        def run(
            pool: Executor, work: Callable[..., Any], *words: Any
        ) -> Awaitable[Any]:
            def work_unless_stale() -> Any:
                return work(*words) if self._newest == number else None

            return asyncio.get_running_loop().run_in_executor(
                pool, work_unless_stale
            )

        def send(kind: str, content: dict[str, Any]) -> None:
            if self._newest == number:
                self._send({"kind": kind, "number": number, **content})

        try:
            picture = await run(bench.fast, self._picture, shown)
            if picture is not None:
                send("picture", picture)
            rough = await run(bench.fast, self._rough, shown)
            if rough is not None:
                send("numbers", rough)
            # The user waits for the first answer only.
            pool = bench.fast if rough is None else bench.slow
            place = await run(pool, bench.place, shown.conditions)
            if place is not None:
                await self._refine(
                    number, shown, place, begun, run, send, pool
                )
        except Error as error:
            send("problem", {"text": str(error)})

    def _rough(self, shown: Shown) -> dict[str, Any] | None:
        """Returns quick numbers, if evaluations take long and an anchor is
        known."""
        anchor = self._anchor
        if not anchor or anchor.conditions.kind != shown.conditions.kind:
            return None
        place = self._bench.coarse(shown.conditions)
        if place is None:
            return None
        both = self._bench.coarse_pair(place, anchor.layout, shown)
        return anchor.message(*both, shown.conditions)

    def _drop_anchor(
        self, shown: Shown, place: Place, samples: Samples
    ) -> None:
        """Stores the present numbers of the reference plant as the anchor."""
        now = shown.conditions
        coarse = self._bench.coarse(now)
        if coarse is not None and samples.by_seed:
            numbers = evaluate_coarse(coarse, place.layout, shown.reference)
            known = samples.together(sorted(samples.by_seed))
            self._anchor = Anchor(
                place.layout, known, numbers, now, place.spread
            )

    async def _refine(
        self,
        number: int,
        shown: Shown,
        place: Place,
        begun: float,
        run: Callable[..., Awaitable[Any]],
        send: Callable[[str, dict[str, Any]], None],
        first: Executor,
    ) -> None:
        """Evaluates the plant and its reference with further random numbers,
        and sends the improved numbers each time."""
        slow = self._bench.slow
        samples = place.samples(shown.genome)
        reference_samples = place.samples(shown.reference)

        async def sample(pool: Executor, genome: Genome, seed: int,
                         known: dict[int, Any]) -> None:  # fmt: skip
            if seed not in known and self._newest == number:
                found = await run(pool, place.evaluate, genome, seed)
                if found is not None:
                    known[seed] = found

        def message() -> dict[str, Any]:
            return make_message(
                place.layout,
                samples,
                reference_samples,
                sorted(samples.by_seed),
            )

        await sample(first, shown.genome, 1, samples.by_seed)
        if self._newest != number:
            return
        send("numbers", message())
        await sample(slow, shown.reference, 1, reference_samples.by_seed)
        said, seed = time.monotonic(), 1
        step = max(1, self._bench.threads // 2)
        while seed < MOST and self._newest == number:
            now = time.monotonic()
            seeds = range(seed + 1, min(seed + step, MOST) + 1)
            if now - begun > REFINING and seeds[0] not in samples.by_seed:
                break
            await asyncio.gather(
                *(
                    sample(slow, shown.genome, s, samples.by_seed)
                    for s in seeds
                ),
                *(
                    sample(slow, shown.reference, s, reference_samples.by_seed)
                    for s in seeds
                ),
            )
            if self._newest == number and (seed == 1 or now - said > 0.12):
                send("numbers", message())
                said = now
            seed = seeds[-1]
        if self._newest == number:
            send("numbers", {**message(), "is_final": True})
            fast = self._bench.fast
            await run(fast, self._drop_anchor, shown, place, reference_samples)

    def _picture(self, shown: Shown) -> dict[str, Any]:
        bench, now = self._bench, shown.conditions
        # The shape of a plant depends on its place only by plasticity.
        stand = bench.place(now if bench.is_plastic else bench.own).stand
        growth = bench.growth(now) if now.when == "season" else None

        def draw(genome: Genome) -> dict[str, Any]:
            return make_plant(stand, genome, shown.component, growth, now.age)

        # The reference plant seldom changes.
        key = (
            *(shown.reference.tobytes(), shown.component, now.when),
            *(now.season, now.age),
            now.density if bench.is_plastic else 0,
        )
        if self._drawn[0] != key:
            self._drawn = key, draw(shown.reference)
        return {
            "plants": [draw(shown.genome), self._drawn[1]],
            "neighbours": place_neighbours(now),
            "panels": place_modules(now, bench.opened.base),
            "direction": now.direction,
            "ground": 1 / now.density,
            "date": growth.date(now.age) if growth and now.age else "",
        }

    async def _improve(self, number: int, work: Improvement) -> None:
        loop = asyncio.get_running_loop()

        def send(content: dict[str, Any]) -> None:
            loop.call_soon_threadsafe(
                self._send, {"kind": "improved", "number": number, **content}
            )

        with contextlib.suppress(asyncio.CancelledError):
            try:
                await loop.run_in_executor(None, work.run, send)
            except Error as error:
                send({"is_final": True, "problem": str(error)})
