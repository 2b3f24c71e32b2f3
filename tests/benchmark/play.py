#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how soon the page of `ideotype play` answers, in a browser: moves
sliders one after the other and waits each time until the first numbers, and
the plant with them, are drawn.

    .venv/bin/python tests/benchmark/play.py [MOVES]     (200)

Prints for some plants and times the median and the 95th percentile of the time
to the first numbers and until they are drawn; for every tenth move also how
long and to which standard error numbers were refined, and in how many of those
moves the first number was within two of its standard errors of the refined
one."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "analysis"))

from live_browser import shown  # noqa: E402
from live_page import CAMPAIGNS, served  # noqa: E402

GROWING = CAMPAIGNS / "growing_season.toml"
CASES = [
    ("maize, clear day", "maize", {"when": "day"}, "traits"),
    ("maize, season", "maize", {}, "traits"),
    ("maize, season, density", "maize", {}, "density"),
    ("maize, season, panels", "maize", {"panels": True}, "traits"),
    ("soybean, season", "soybean", {}, "traits"),
    ("maize, growing season", GROWING, {}, "traits"),
    ("maize, growing season, density", GROWING, {}, "density"),
]
SCRIPT = """(async () => {
  const goal = page.hello.goals[0];
  const found = { first: [], drawn: [], refined: [], errors: [], known: [], inside: [] };
  const told = (isGood) => new Promise((done) => {
    const look = () => (isGood() ? done() : setTimeout(look, 0));
    look();
  });
  const frame = () => new Promise(requestAnimationFrame);
  const isFinal = () => document.body.dataset.final === "true"
    && Number(document.body.dataset.number) === page.number;
  change({ conditions: { ...page.shown.conditions, ...%(conditions)s } });
  await format_times(isFinal);
  await new Promise((done) => setTimeout(done, 500));
  const movable = "%(what)s" === "traits"
    ? sliders.filter((s) => s.index >= 0 && page.hello.levers[s.index].kind === "profile")
    : sliders.filter((s) => s.input.id === "s-%(what)s");
  let seed = 1;
  for (let i = 1; i <= %(moves)d; ++i) {
    const { input } = movable[i %% movable.length];
    seed = (seed * 16807) %% 2147483647;
    const part = seed / 2147483647;
    input.value = Number(input.min) + part * (Number(input.max) - Number(input.min));
    const begun = performance.now();
    input.dispatchEvent(new Event("input"));
    await format_times(() => page.answered === page.number);
    found.first.push(performance.now() - begun);
    const first = field.numbers.numbers[goal];
    await frame();
    await new Promise((done) => setTimeout(done, 0));
    found.drawn.push(performance.now() - begun);
    found.errors.push(Math.abs(first[1] / first[0]));
    if (i %% 10) continue;
    await format_times(isFinal);
    const last = field.numbers.numbers[goal];
    found.refined.push(performance.now() - begun);
    found.known.push(Math.abs(last[1] / last[0]));
    found.inside.push(Math.abs(first[0] - last[0]) < 2 * Math.hypot(first[1], last[1]));
  }
  return found;
})()"""


def main() -> None:
    moves = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    print(
        "| | first numbers [ms] | drawn [ms] | their error | refined [ms] | "
        "its error | within 2 errors |\n|---|---|---|---|---|---|---|"
    )
    for name, plant, conditions, description in CASES:
        script = SCRIPT % {
            "conditions": str(conditions).replace("True", "true"),
            "what": description,
            "moves": moves,
        }
        with (
            tempfile.TemporaryDirectory() as folder,
            served("play", plant) as page,
            shown(page, Path(folder)) as phone,
        ):
            measured = phone.value(script)

        def format_times(
            kind: str, measured: dict[str, list[float]] = measured
        ) -> str:
            middle, upper = np.percentile(measured[kind], [50, 95])
            return f"{middle:.0f} (95 %: {upper:.0f})"

        def format_error(
            kind: str, measured: dict[str, list[float]] = measured
        ) -> str:
            return f"{100 * np.median(measured[kind]):.1f} %"

        inside = f"{sum(measured['inside'])} of {len(measured['inside'])}"
        print(
            f"| {name} | {format_times('first')} | {format_times('drawn')} | "
            f"{format_error('errors')} | {format_times('refined')} | {format_error('known')} | "
            f"{inside} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
