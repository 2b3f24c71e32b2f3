"""Makes small histories to the letter of analysis/FORMAT.md, without the
program.

Also a program: `made_history.py PATH` creates a history and obeys commands
from its standard input, one a line, such as `record 0 3`; it answers each
with `ok`. That is the writer in another process."""

from __future__ import annotations

import fcntl
import sys
from collections.abc import Sequence
from pathlib import Path

import h5py
import numpy as np
from made_layout import Layout
from made_numbers import (
    ERROR,
    FINALISTS,
    LAI,
    ORIGIN,
    POPULATION,
    STATUS,
    absorbed,
    baseline_genome,
    diagnostics,
    final_absorbed,
    genome,
)


class MadeHistory:
    """A writer in SWMR mode with a lock beside the file, as the program."""

    def __init__(
        self,
        path: Path,
        version: str = "1.0",
        kind: str = "ideotype-history",
        without: str | None = None,
        place: dict[str, str | float] | None = None,
        shift: float = 0.0,
        extra: Sequence[tuple[str, str, float]] = (),
    ) -> None:
        """Creates everything, empty, but the dataset `without`. `place` are
        root attributes, `shift` is added to what bred plants absorb, `extra`
        are diagnostics: name, unit, part of the absorbed PAR."""
        self._shift = shift
        self._extra = np.array([part for _, _, part in extra])
        self._lock_path = Path(f"{path}.lock")
        self._lock = self._lock_path.open("w")
        fcntl.flock(self._lock, fcntl.LOCK_EX)
        self.file = h5py.File(path, "w", libver=("v110", "v110"))
        layout = Layout(self.file, without, [(name, unit) for name, unit, _ in extra])
        layout.create(kind, version, place or {})
        self.file.swmr_mode = True

    def propose(self, generation: int) -> None:
        """Genomes first, then the status."""
        for slot in range(POPULATION):
            row = generation * POPULATION + slot
            first = ORIGIN["baseline"] if slot == 0 else ORIGIN["random"]
            later = ORIGIN["elite"] if slot < 2 else ORIGIN["child"]
            rows = self.file["evaluations"]
            rows["genome"][row] = genome(generation, slot)
            rows["origin"][row] = later if generation else first
            rows["status"][row] = STATUS["proposed"]
        self.file.flush()

    def record(self, generation: int, slot: int) -> None:
        """An outcome, status last."""
        total = absorbed(generation, slot)
        if generation or slot:
            total += self._shift
        row = generation * POPULATION + slot
        self._outcome("evaluations", row, total, ERROR)

    def fail(self, generation: int, slot: int) -> None:
        """A failed row with its reason."""
        rows, row = self.file["evaluations"], generation * POPULATION + slot
        rows["fitness"][row] = -np.inf
        rows["message"][row] = b"leaf 3 folds into itself"
        rows["status"][row] = STATUS["failed"]
        self.file.flush()

    def _outcome(self, group: str, row: int, total: float, error: float) -> None:
        rows = self.file[group]
        values = np.append(diagnostics(total), self._extra * total)
        rows["objectives"][row] = total
        rows["objectives_standard_error"][row] = error
        rows["diagnostics"][row] = values
        errors = values * error / total
        errors[LAI] = 0.0
        rows["diagnostics_standard_error"][row] = errors
        rows["fitness"][row] = total
        rows["attempt"][row] = 1
        rows["seconds"][row] = 0.25
        rows["worker"][row] = 1 + row % 2
        rows["status"][row] = STATUS["done"]
        self.file.flush()

    def commit(self, generation: int) -> None:
        """Summarizes the generation; `committed` last."""
        first = generation * POPULATION
        rows = self.file["evaluations"]
        status = rows["status"][first : first + POPULATION]
        fitness = rows["fitness"][first : first + POPULATION]
        good = fitness[status == STATUS["done"]]
        summary = {
            "best_slot": int(fitness.argmax()),
            "best": good.max(),
            "best_standard_error": ERROR,
            "mean": good.mean(),
            "spread": good.std(ddof=1),
            "diversity": 0.3 / (1 + generation),
            "failures": len(fitness) - len(good),
            "evaluations": len(fitness),
            "wall_time": 3.0 * (generation + 1),
        }
        for name, value in summary.items():
            self.file["generations"][name][generation] = value
        self.file.flush()
        self.file["generations/committed"][generation] = True
        self.file["state/wall_time"][()] = 3.0 * (generation + 1)
        self.file.flush()

    def evolve(self, generations: int) -> None:
        """Whole generations; slot 5 of each odd one fails."""
        for generation in range(generations):
            self.propose(generation)
            for slot in range(POPULATION):
                fails = slot == 5 and generation % 2
                (self.fail if fails else self.record)(generation, slot)
            self.commit(generation)

    def propose_final(self) -> None:
        """Row 0 is the baseline, the others the fittest of generation 3."""
        rows = self.file["final"]
        for slot in range(FINALISTS):
            bred = genome(3, POPULATION - slot)
            rows["genome"][slot] = bred if slot else baseline_genome()
            rows["origin"][slot] = ORIGIN["child" if slot else "baseline"]
            rows["status"][slot] = STATUS["proposed"]
        self.file.flush()

    def record_final(self, slot: int) -> None:
        """A final evaluation."""
        total = final_absorbed(slot) + (self._shift if slot else 0.0)
        self._outcome("final", slot, total, ERROR / 4)

    def finish(self, reason: str = "generations") -> None:
        """The finals, and the end."""
        self.propose_final()
        for slot in range(FINALISTS):
            self.record_final(slot)
        self.file["state/reason"][()] = reason.encode()
        self.file["state/finished"][()] = True
        self.file.flush()

    def close(self) -> None:
        """As the program at its end: no lock stays behind."""
        self.file.close()
        self._lock_path.unlink()
        self._lock.close()


def main() -> None:
    """Creates a history and obeys."""
    made = MadeHistory(Path(sys.argv[1]))
    print("ok", flush=True)
    for line in sys.stdin:
        command, *numbers = line.split()
        getattr(made, command)(*map(int, numbers))
        print("ok", flush=True)


if __name__ == "__main__":
    main()
