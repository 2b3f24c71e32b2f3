#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how soon `ideotype play` answers: moves sliders one after the other
and waits each time for the first numbers.

    .venv/bin/python tests/benchmark/play.py [MOVES]     (200)

Prints for a clear day and for a season of weather the median and the 95th
percentile of the time to the plant's shape, to the first numbers, and of how
long and to which standard error the numbers were refined."""

from __future__ import annotations

import asyncio
import json
import re
import subprocess
import sys
import time
from typing import Any

import numpy as np
from tornado.websocket import WebSocketClientConnection, websocket_connect

REFINED = 20
"""The number of moves whose refined numbers are waited for."""


async def hear(
    talk: WebSocketClientConnection, kind: str, number: int
) -> dict[str, Any]:
    """Returns the next message of a kind about a question."""
    while True:
        text = await talk.read_message()
        assert text is not None, "the program has ended"
        message = json.loads(text)
        assert message["kind"] != "problem", message
        if message["kind"] == kind and message.get("number", number) == number:
            return message


async def measure(address: str, when: str, moves: int) -> None:
    """Prints the times of so many moves."""
    talk = await websocket_connect(f"{address}talk".replace("http", "ws"))
    hello = await hear(talk, "hello", 0)
    sliders = [
        i for i, lever in enumerate(hello["levers"])
        if lever["kind"] == "profile"
    ]  # fmt: skip
    goal = hello["goals"][0]
    genome = list(hello["genome"])
    random = np.random.default_rng(1)
    shape, first, last, errors = [], [], [], []
    for number in range(1, moves + 2):
        index = sliders[number % len(sliders)]
        lever = hello["levers"][index]
        genome[index] = random.uniform(lever["lower"], lever["upper"])
        begun = time.perf_counter()
        talk.write_message(
            json.dumps(
                {
                    "kind": "show",
                    "number": number,
                    "genome": genome,
                    "conditions": {"when": when},
                }
            )
        )
        await hear(talk, "picture", number)
        seen = time.perf_counter() - begun
        told = await hear(talk, "numbers", number)
        if number == 1:
            continue  # The stand is built and the first plant evaluated.
        shape.append(seen)
        first.append(time.perf_counter() - begun)
        errors.append(told["numbers"][goal])
        if number % (moves // REFINED) == 0:
            while not told.get("is_final"):
                told = await hear(talk, "numbers", number)
            last.append((time.perf_counter() - begun, told["numbers"][goal]))
    talk.close()

    def line(name: str, times: list[float]) -> None:
        low, high = np.percentile(1000 * np.array(times), [50, 95])
        print(
            f"{when}: {name} after {low:.0f} ms (median), {high:.0f} ms (95 %)"
        )

    def error(found: list[Any]) -> float:
        return 100 * float(np.median([abs(se / v) for v, se in found]))

    line("shape", shape)
    line(f"numbers ({goal} to {error(errors):.1f} %)", first)
    line(
        f"refined ({error([n for _, n in last]):.1f} %)",
        [seconds for seconds, _ in last],
    )


def main() -> None:
    moves = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    command = [sys.executable, "-m", "ideotype", "play", "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as play:
        assert play.stdout
        try:
            found = re.search(r"http://\S+", play.stdout.readline())
            assert found, "ideotype play has not begun"
            for when in ("day", "season"):
                asyncio.run(measure(found[0], when, max(moves, REFINED)))
        finally:
            play.terminate()


if __name__ == "__main__":
    main()
