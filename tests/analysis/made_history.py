# SPDX-License-Identifier: Apache-2.0
"""Makes small histories that follow analysis/FORMAT.md exactly, without the
program.

As a script, `made_history.py PATH` creates a history and executes commands
from its standard input, one per line, such as `record 0 3`. It answers each
command with `ok`, and thus serves as a writer in another process."""

from __future__ import annotations

import fcntl
import os
import struct
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

import h5py
import numpy as np
from made_kinds import ORIGIN, STATUS, Measured
from made_layout import (
    Layout,
    finalist_checksum,
    generation_checksum,
)
from made_numbers import (
    ERROR,
    FINALISTS,
    GENERATIONS,
    LABELS,
    LEAVES,
    POPULATION,
    QUANTITIES,
    RANDOMISATIONS,
    TRAITS,
    absorbed,
    baseline_genome,
    final_absorbed,
    genome,
    hypervolume,
    quantities,
    randomisations,
)

_HEADER = 1 << 18  # The size of the header [bytes].

Extra = tuple[Measured, float | np.ndarray]
"""A quantity, and its value as a part of the absorbed PAR."""


ATTRIBUTES: dict[str, object] = {
    "format": "ideotype-history",
    "format_version": "2.0",
    "program": "ideotype",
    "program_version": "0.1.0",
    "git_sha": "0123456789abcdef",
    "git_dirty": "no",
    "isa": "avx2",
    "campaign": "made",
    "case": "ames_0807_762x152_all_r1",
    "site": "ames",
    "day": "2025-08-07",
    "spacing": "30x6",
    "trait_set": "all",
    "seed": np.uint64(2**63 + 1),
    "population": np.int32(POPULATION),
    "generations": np.int32(GENERATIONS),
    "finalists": np.int32(FINALISTS),
    "rows": np.int32(GENERATIONS * POPULATION),
    "latitude": 42.0,
    "longitude": -93.6,
    "row_spacing": 0.762,
    "plant_spacing": 0.1524,
}
SESSION = {
    "started": "2025-08-07T12:00:00Z",
    "host": "node1",
    "command": "ideotype run",
    "ranks": 3,
    "program": "ideotype 0.2.0",
    "compiler": "g++ 12",
    "libraries": "HDF5 1.10.8",
}


class MadeHistory:
    """A writer that, like the program, uses SWMR mode and locks the file."""

    def __init__(
        self,
        path: Path,
        *,
        without: str | None = None,
        attributes: Mapping[str, str | float] = {},
        resolved: str = 'name = "made" # resolved',
        shift: float = 0.0,
        baseline_shift: float = 0.0,
        labels: Mapping[str, object] = {},
        extra: Mapping[str, Extra] = {},
        objectives: Sequence[tuple[str, str]] = (
            ("absorbed_par", "maximise"),
        ),
    ) -> None:
        """Creates all datasets, empty, except the dataset `without`.
        `attributes` add to or replace root attributes. `shift` is added to the
        light absorbed by optimised plants, and `baseline_shift` to that of the
        baseline in the final evaluations. `extra` are additional quantities,
        and `labels` the labels of their axes."""
        self._shift, self._baseline_shift = shift, baseline_shift
        self._objectives = [name for name, _ in objectives]
        self._extra = {name: part for name, (_, part) in extra.items()}
        self._measured = QUANTITIES | {
            n: kind for n, (kind, _) in extra.items()
        }
        # As in files of the program, the header of the file comes first.
        self.file = h5py.File(
            path, "w", libver=("v110", "v110"), meta_block_size=_HEADER
        )
        self._lock = os.open(path, os.O_RDWR)
        whole = struct.pack("hhqqi4x", fcntl.F_WRLCK, os.SEEK_SET, 0, 0, 0)
        fcntl.fcntl(self._lock, fcntl.F_OFD_SETLK, whole)
        names, units, lower, upper, circular = zip(*TRAITS)
        genes = {
            "gene": names,
            "trait": [name.split("_", 1)[1] for name in names],
            "leaf": np.repeat(np.arange(1, LEAVES + 1, dtype="i4"), 4),
            "unit": units,
            "lower": lower,
            "upper": upper,
            "is_circular": circular,
            "is_free": [True] * len(names),
        }
        self._counts = (RANDOMISATIONS, 2 * RANDOMISATIONS)
        Layout(
            self.file,
            GENERATIONS * POPULATION,
            FINALISTS,
            GENERATIONS,
            genes,
            [(name, self._measured[name].units, s) for name, s in objectives],
            {**LABELS, **labels},
            self._measured,
            self._counts,
            without,
        ).create(
            ATTRIBUTES | attributes,
            {"source": 'name = "made" # source', "resolved": resolved},
        )
        for name, value in SESSION.items():
            self.file["sessions"][name][0] = (
                value.encode() if isinstance(value, str) else value
            )
        if "messages/text" in self.file:
            self.file["messages/text"][0] = "Zeit f\u00fcr Licht".encode()
        self.file.swmr_mode = True

    def propose(self, generation: int) -> None:
        """Proposes rows: writes genomes first, then positions, then the
        status."""
        for slot in range(POPULATION):
            row = generation * POPULATION + slot
            first = ORIGIN["baseline"] if slot == 0 else ORIGIN["random"]
            later = ORIGIN["elite"] if slot < 2 else ORIGIN["child"]
            rows = self.file["evaluations"]
            rows["genome"][row] = genome(generation, slot)
            rows["origin"][row] = later if generation else first
            before = row - slot - POPULATION
            rows["parents"][row] = [before, before + 1] if generation else -1
        table, start = self.file["generations"], generation * POPULATION
        table["first_row"][generation] = start
        table["count"][generation] = POPULATION
        status = [STATUS["proposed"]] * POPULATION
        rows["status"][start : start + POPULATION] = status
        self.file.flush()

    def record(self, generation: int, slot: int) -> None:
        """Records an outcome; the status is written last."""
        total = absorbed(generation, slot)
        if generation or slot:
            total += self._shift
        row = generation * POPULATION + slot
        noise = generation, slot
        self._outcome("evaluations", row, total, ERROR, noise, self._counts[0])
        self.file["evaluations/status"][row] = STATUS["done"]
        self.file.flush()

    def fail(self, generation: int, slot: int) -> None:
        """Records a failed row with the reason."""
        rows, row = self.file["evaluations"], generation * POPULATION + slot
        rows["message"][row] = b"leaf 3 folds into itself"
        for name, kind in self._measured.items():
            if kind.is_exact:
                rows[name][row] = np.nan
        rows["status"][row] = STATUS["failed"]
        self.file.flush()

    def _outcome(
        self,
        group: str,
        row: int,
        total: float,
        error: float,
        noise: tuple[int, int],
        draws: int,
    ) -> None:
        rows = self.file[group]
        extra = {name: part * total for name, part in self._extra.items()}
        known = quantities(total) | extra
        values = randomisations(total, error, draws, *noise)
        for k, name in enumerate(self._objectives):
            scale = known[name] / total
            row_error = 0.0 if self._measured[name].is_exact else error * scale
            rows["objectives"][row, k] = known[name]
            rows["objectives_standard_error"][row, k] = row_error
            each = scale * (values if row_error else total + 0 * values)
            rows["objectives_by_randomisation"][row, k] = each
        rows["violation"][row] = 0.0
        for name, kind in self._measured.items():
            rows[name][row] = known[name]
            if not kind.is_exact:
                errors = known[name] * error / total
                rows[f"{name}_standard_error"][row] = errors
        rows["attempt"][row] = 1
        rows["seconds"][row] = 0.25
        rows["worker"][row] = 1 + row % 2
        self.file.flush()

    def commit(self, generation: int) -> None:
        """Summarises the generation; `committed` is written last."""
        first = generation * POPULATION
        rows = self.file["evaluations"]
        status = rows["status"][first : first + POPULATION]
        values = rows["objectives"][first : first + POPULATION, 0]
        good = values[status == STATUS["done"]]
        summary = {
            "best_row": first + int(np.nanargmax(values)),
            "best": good.max(),
            "best_standard_error": ERROR,
            "mean": good.mean(),
            "spread": good.std(ddof=1),
            "diversity": 0.3 / (1 + generation),
            "failures": len(values) - len(good),
            "evaluations": len(values),
            "wall_time": 3.0 * (generation + 1),
            "hypervolume": hypervolume(generation),
            "hypervolume_standard_error": ERROR,
        }
        for name, value in summary.items():
            if name in self.file["generations"]:
                self.file["generations"][name][generation] = value
        checksum = generation_checksum(self.file, generation).encode()
        self.file["generations/checksum"][generation] = checksum
        self.file.flush()
        self.file["generations/committed"][generation] = True
        self.file["state/wall_time"][()] = 3.0 * (generation + 1)
        self.file.flush()

    def evolve(self, generations: int) -> None:
        """Makes complete generations; in each odd one slot 5 fails."""
        for generation in range(generations):
            self.propose(generation)
            for slot in range(POPULATION):
                fails = slot == 5 and generation % 2
                (self.fail if fails else self.record)(generation, slot)
            self.commit(generation)

    def propose_final(self) -> None:
        """Proposes final evaluations: row 0 is the baseline, the others are
        the fittest plants of generation 3."""
        rows = self.file["final"]
        for slot in range(FINALISTS):
            bred = genome(3, POPULATION - slot)
            rows["genome"][slot] = bred if slot else baseline_genome()
            rows["origin"][slot] = ORIGIN["child" if slot else "baseline"]
            rows["status"][slot] = STATUS["proposed"]
        self.file.flush()

    def record_final(self, slot: int) -> None:
        """Records a final evaluation."""
        total = final_absorbed(slot) + (
            self._shift if slot else self._baseline_shift
        )
        noise = 999, slot
        self._outcome("final", slot, total, ERROR / 4, noise, self._counts[1])
        checksum = finalist_checksum(self.file, slot, STATUS["done"]).encode()
        self.file["final/checksum"][slot] = checksum
        self.file["final/status"][slot] = STATUS["done"]
        self.file.flush()

    def finish(self, reason: str = "generations") -> None:
        """Makes the final evaluations and ends the run."""
        self.propose_final()
        for slot in range(FINALISTS):
            self.record_final(slot)
        self.file["state/reason"][()] = reason.encode()
        self.file["state/finished"][()] = True
        self.file.flush()

    def close(self) -> None:
        """Closes the file and releases its lock, like the program at its
        end."""
        self.file.close()
        os.close(self._lock)


def main() -> None:
    """Creates a history and executes commands."""
    made = MadeHistory(Path(sys.argv[1]))
    print("ok", flush=True)
    for line in sys.stdin:
        command, *numbers = line.split()
        getattr(made, command)(*map(int, numbers))
        print("ok", flush=True)


if __name__ == "__main__":
    main()
