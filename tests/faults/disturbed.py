# SPDX-License-Identifier: Apache-2.0
"""Runs the program while one of its calls fails, and judges the outcome."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from ideotype import Error
from ideotype.history.file import open_file

# A run that takes longer counts as hung [s]; it normally takes a quarter of a
# second.
_PATIENCE = 60
# Datasets that may differ between runs.
_FREE = {
    "evaluations": {"seconds", "worker", "attempt"},
    "final": {"seconds", "worker", "attempt", "checksum"},
    "generations": {"wall_time", "checksum"},
}
_DONE = (2, 3)  # status of done and of failed rows


@dataclass(frozen=True)
class Fault:
    """A failing call: the n-th of its kind, in one rank, on some files."""

    kind: str
    mode: str
    n: int
    lasting: bool = False
    rank: int | None = None
    file: str | None = None

    def environment(self, note: Path) -> dict[str, str]:
        """Returns the variables that the library of faults reads."""
        plus = "+" if self.lasting else ""
        environment = {"FAULT": f"{self.kind}:{self.mode}:{self.n}{plus}"}
        if self.file is not None:
            environment["FAULT_FILE"] = self.file
        return environment | place(self.rank, note)


def place(rank: int | None, note: Path) -> dict[str, str]:
    """Returns the variables that state where calls are counted."""
    environment = {"FAULT_NOTE": str(note)}
    if rank is not None:
        environment["FAULT_RANK"] = str(rank)
    return environment


@dataclass
class Ended:
    """An ended run: exit code, output, and the disturbed calls."""

    code: int
    output: str
    is_hung: bool = False
    note: str = ""


@dataclass
class Verdict:
    """The outcome of a fault, and all errors in the outcome."""

    outcome: str
    wrong: list[str] = field(default_factory=list)
    output: str = ""
    hit: str = ""


class Setup:
    """A campaign with the history of an undisturbed run."""

    def __init__(
        self,
        program: Path,
        library: Path,
        campaign: Path,
        folder: Path,
        ranks: int | None = None,
    ) -> None:
        self.library = library
        self.folder = folder
        self.ranks = ranks
        self._run = [str(program), "run", str(campaign)]
        if ranks is None:
            self._run += ["--threads", "2"]
        ended = self.run("whole", {})
        assert ended.code == 0, ended.output
        (history,) = (folder / "whole").rglob("*.h5")
        self._path = history.relative_to(folder / "whole")
        self.whole = numbers_of(history)

    def history(self, out: str) -> Path:
        return self.folder / out / self._path

    def run(self, out: str, variables: dict[str, str]) -> Ended:
        """Runs or resumes the campaign; with VARIABLES the library of faults
        is loaded."""
        words = [*self._run, "--resume", "--out", out]
        if variables:
            variables = {**variables, "LD_PRELOAD": str(self.library)}
        # Only the ranks load the library; mpirun does not.
        faults = ["env", *(f"{k}={v}" for k, v in variables.items())]
        start = [] if self.ranks is None else ["mpirun", "-n", f"{self.ranks}"]
        job = subprocess.Popen(
            [*start, *faults, *words],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            start_new_session=True,
            env={**os.environ, **_MPI},
        )
        try:
            output, _ = job.communicate(timeout=_PATIENCE)
        except subprocess.TimeoutExpired:
            os.killpg(job.pid, signal.SIGKILL)
            output, _ = job.communicate()
            return Ended(job.returncode, output, True)
        return Ended(job.returncode, output)

    def counts(self, rank: int | None, file: str | None) -> dict[str, int]:
        """Returns the number of calls of each kind in an undisturbed run."""
        note = self.folder / "counts"
        note.unlink(missing_ok=True)
        variables = place(rank, note)
        if file is not None:
            variables["FAULT_FILE"] = file
        ended = self.run("counted", variables)
        assert ended.code == 0, ended.output
        counts = re.findall(
            r"^count (\w+) (\d+)$", note.read_text(), re.MULTILINE
        )
        shutil.rmtree(self.folder / "counted")
        return {kind: int(count) for kind, count in counts}

    def judge(self, fault: Fault, out: str) -> Verdict:
        """Runs with a fault, checks the remaining files, and resumes the
        run."""
        note = self.folder / f"{out}.note"
        ended = self.run(out, fault.environment(note))
        if note.exists():
            ended.note = note.read_text()
            note.unlink()
        hit = re.search(r"^hit (.*)$", ended.note, re.MULTILINE)
        verdict = Verdict(outcome_of(ended), output=ended.output)
        verdict.hit = hit[1] if hit else "none"
        if hit is None and verdict.outcome == "right":
            verdict.outcome = "not met"
        if verdict.outcome in ("hung", "silent"):
            verdict.wrong.append(verdict.outcome)
        history = self.history(out)
        if history.exists():
            verdict.wrong += self._look(history, ended)
        elif ended.code == 0:
            verdict.wrong.append("success without a history")
        # If no file was written, the next run starts from the beginning.
        if ended.code != 0 and any((self.folder / out).rglob("*.h5*")):
            verdict.wrong += self._resume(out)
        shutil.rmtree(self.folder / out, ignore_errors=True)
        return verdict

    def _resume(self, out: str) -> list[str]:
        again = self.run(out, {})
        if again.code != 0:
            return [f"no resume: {again.output[-300:]}"]
        return differences(self.whole, numbers_of(self.history(out)))

    def _look(self, history: Path, ended: Ended) -> list[str]:
        try:
            values = numbers_of(history)
        except (OSError, KeyError, RuntimeError, Error) as error:
            return [f"unreadable: {error}"]
        if ended.code == 0:
            return differences(self.whole, values)
        wrong = lost_rows(values, ended.output)
        for group in ("evaluations", "final"):
            wrong += wrong_rows(group, self.whole, values)
        return wrong


_MPI = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
}

Numbers = dict[str, np.ndarray]


def outcome_of(ended: Ended) -> str:
    """Returns the way in which a run ended: right, told, signal, silent or
    hung."""
    if ended.is_hung:
        return "hung"
    if ended.code == 0:
        return "right"
    has_reason = re.search(
        r"^(\S+Z  )?ideotype: .+|MPI_ERR_\w+|An error occurred in MPI_",
        ended.output,
        re.MULTILINE,
    )
    if not has_reason:
        return "silent"
    is_signal = ended.code < 0 or ended.code > 128
    return "signal" if is_signal else "told"


def numbers_of(path: Path) -> Numbers:
    """Returns all data of a history that must not depend on disturbances."""
    arrays = {}
    with open_file(path) as file:
        for group, free in _FREE.items():
            for name, data in file[group].items():
                if name not in free and hasattr(data, "shape"):
                    arrays[f"{group}/{name}"] = data[()]
    return arrays


def differences(whole: Numbers, disturbed: Numbers) -> list[str]:
    """Returns the differences from the undisturbed history."""
    if whole.keys() != disturbed.keys():
        return ["other data"]
    return [
        f"differs: {name}"
        for name, data in whole.items()
        if not _is_same(data, disturbed[name])
    ]


def _is_same(a: np.ndarray, b: np.ndarray) -> bool:
    if a.dtype == object:  # texts
        return bool(a.tolist() == b.tolist())
    return a.tobytes() == b.tobytes()


def wrong_rows(group: str, whole: Numbers, disturbed: Numbers) -> list[str]:
    """Returns data of complete rows that differ from the undisturbed rows."""
    rows = np.isin(disturbed[f"{group}/status"], _DONE)
    return [
        f"wrong: {name}"
        for name, data in whole.items()
        if name.startswith(f"{group}/")
        and len(data) == len(rows)
        and not _is_same(data[rows], disturbed[name][rows])
    ]


def lost_rows(disturbed: Numbers, output: str) -> list[str]:
    """Returns the rows that the log reports but the history lacks."""
    reported = [
        int(n)
        for n in re.findall(r"generation \d+, (\d+) of \d+ plants", output)
    ]
    rows = max(reported, default=0)
    done = np.isin(disturbed["evaluations/status"][:rows], _DONE)
    return [] if done.all() else ["a reported row is lost"]
