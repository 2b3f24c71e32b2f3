# SPDX-License-Identifier: Apache-2.0
"""Computes the rows of a table of measurements at values of parameters, and
keeps all evaluations in a file."""

from __future__ import annotations

import csv
import math
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..common.processors import processors
from ..common.progress import Progress
from ..errors import Error, InputError
from .observations import Observations
from .parameters import Parameter, settings_at

Numbers = NDArray[np.float64]


class Evaluations:
    """Evaluations by their name, in a CSV file to which each is appended when
    it is complete. An interrupted computation that is repeated reads them from
    the file and gets the same bits.

    Each line has the name, the processor time [s] and the values, as texts that
    give back the same numbers."""

    def __init__(self, path: Path | None, header: str = "") -> None:
        """path: file, which may exist; None: evaluations are only kept in
        memory. header: description of the computation, the first line.

        Raises Error if the file is that of another computation."""
        self.path = path
        self.seconds = 0.0
        """The processor time of all evaluations, also those of the file."""
        self._known: dict[str, Numbers] = {}
        if path is None:
            return
        if not path.exists():
            path.write_text(f"{header}\n", encoding="utf-8")
        text = path.read_text(encoding="utf-8")
        complete, _, _ = text.rpartition("\n")
        first, *lines = complete.split("\n")
        if first != header:
            raise Error(
                f"{path}: these evaluations are of another calibration, with "
                "other data, parameters or settings; choose another folder"
            )
        for line in csv.reader(lines):
            self.seconds += float(line[1])
            self._known[line[0]] = np.array(line[2:], float)
        # A line that was interrupted is evaluated again.
        path.write_text(complete + "\n", encoding="utf-8")

    def __len__(self) -> int:
        return len(self._known)

    def __contains__(self, name: str) -> bool:
        return name in self._known

    def __getitem__(self, name: str) -> Numbers:
        return self._known[name]

    def add(self, name: str, values: Numbers, seconds: float) -> None:
        """Keeps an evaluation."""
        self._known[name] = values
        self.seconds += seconds
        if self.path is None:
            return
        words = ",".join(
            [name, repr(seconds), *(repr(float(x)) for x in values)]
        )
        with self.path.open("a", encoding="utf-8") as file:
            file.write(words + "\n")


def _name(values: Sequence[float], seed: int) -> str:
    """Returns the name of an evaluation: the seed and its bits."""
    return ":".join([str(seed), *(float(x).hex() for x in values)])


class Model:
    """The program as a function from parameters to the rows of a table."""

    def __init__(
        self,
        observations: Observations,
        parameters: Sequence[Parameter],
        evaluations: Evaluations,
        seed: int = 1,
    ) -> None:
        self.observations = observations
        self.parameters = list(parameters)
        self.evaluations = evaluations
        self.seed = seed
        self.failed = 0
        """The number of evaluations that failed."""

    def evaluate(
        self, points: Numbers, seed: int | None = None, about: str = ""
    ) -> Numbers:
        """Returns the rows at each point, in their units.

        points: values of the parameters [points, parameters].
        seed: seed of the program's random numbers, by default that of the
            model: all points then have common random numbers.

        Returns [points, rows]; NaN where an evaluation failed, such as for a
        plant that is impossible. Raises Error if all fail."""
        chosen = self.seed if seed is None else seed
        names = [_name(point, chosen) for point in points]
        missing = {
            name: point
            for name, point in zip(names, points)
            if name not in self.evaluations
        }
        last: Exception | None = None
        with (
            Progress("evaluated") as progress,
            ThreadPoolExecutor(processors()) as pool,
        ):
            futures = {
                name: pool.submit(self._compute, point, chosen)
                for name, point in missing.items()
            }
            for done, (name, future) in enumerate(futures.items()):
                progress.show(done, len(futures), about)
                values, seconds, error = future.result()
                if error:
                    last = error
                    self.failed += 1
                self.evaluations.add(name, values, seconds)
        if (
            last
            and len(missing) == len(names)
            and not np.isfinite(
                [self.evaluations[name] for name in names]
            ).any()
        ):
            raise Error(f"no point could be computed: {last}")
        rows = len(self.observations.rows)
        return np.array([self.evaluations[x] for x in names]).reshape(-1, rows)

    def _compute(
        self, point: Numbers, seed: int
    ) -> tuple[Numbers, float, Exception | None]:
        """Returns the rows at a point, the processor time, and the error of an
        evaluation that failed."""
        began = time.thread_time()
        values = np.full(len(self.observations.rows), math.nan)
        changes = settings_at(self.parameters, point)
        error: Exception | None = None
        conditions = self.observations.conditions
        for keys, indices in self.observations.groups:
            rows = [self.observations.rows[i] for i in indices]
            try:
                settings = conditions.settings({**keys, **changes})
                values[indices] = conditions.values(settings, rows, seed)
            except (Error, InputError) as failure:
                error = failure
        if error:
            values[:] = math.nan
        return values, time.thread_time() - began, error

    def own_errors(self, point: Numbers, seeds: int = 4) -> Numbers:
        """Returns the standard error of one evaluation of each row, from the
        scatter between seeds at a point [rows]."""
        values = [
            self.evaluate(point[None], self.seed + k, "our error")[0]
            for k in range(seeds)
        ]
        return np.std(values, axis=0, ddof=1)
