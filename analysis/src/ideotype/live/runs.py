# SPDX-License-Identifier: Apache-2.0
"""Reads the state of running campaigns from their files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..common.labels import title
from ..errors import Error
from ..history.estimate import NORMAL, Estimate, relative_gain
from ..history.file import HistoryError, Writer
from ..history.history import History, open_history
from ..history.names import distinct_names
from ..history.rows import Status
from ..history.shrinkage import shrunken

RECENT = 5
"""The number of last generations that define the current rate."""


@dataclass
class _Known:
    """A summary of a file, and the state of the file at that time."""

    stamp: tuple[int, int]
    summary: dict[str, Any]


class Folder:
    """The histories of a folder and of all folders in it."""

    def __init__(self, path: Path) -> None:
        """Opens the folder. Raises Error if there is no such folder."""
        if not path.is_dir():
            raise Error(
                f"{path}: there is no such folder; give the one that "
                "`ideotype run` writes to, results by default"
            )
        self.path = path
        self.name = path.resolve().name or str(path)
        self._known: dict[Path, _Known] = {}

    def histories(self) -> list[Path]:
        """Returns the files, by name."""
        return sorted(path for path in self.path.rglob("*.h5"))

    def summarise(self) -> dict[str, Any]:
        """Returns all cases and their sums, for the page. The entry of a file
        that cannot be read has the reason."""
        cases = [self._case(path) for path in self.histories()]
        named = [case for case in cases if "problem" not in case]
        names = distinct_names(
            [case["name"] for case in named], [case["file"] for case in named]
        )
        for case, name in zip(named, names):
            case["name"] = name
        left = [c["core_hours_left"] for c in cases if "problem" not in c]
        known = [hours for hours in left if hours is not None]
        return {
            "folder": self.name,
            "cases": cases,
            "running": sum(c.get("state") == "running" for c in cases),
            "finished": sum(c.get("state") == "finished" for c in cases),
            "rate": sum(
                c.get("rate") or 0
                for c in cases
                if c.get("state") == "running"
            ),
            "evaluations": sum(c.get("evaluations", 0) for c in cases),
            "failures": sum(c.get("failures", 0) for c in cases),
            "core_hours_left": sum(known),
            "damaged": sum("problem" in c for c in cases),
        }

    def _case(self, path: Path) -> dict[str, Any]:
        name = str(path.relative_to(self.path))
        try:
            at = path.stat()
            stamp = (at.st_mtime_ns, at.st_size)
            known = self._known.get(path)
            # Only the file of a finished case cannot change without a new time
            # stamp.
            if (
                known
                and known.stamp == stamp
                and known.summary.get("state") == "finished"
            ):
                return {**known.summary}
            with open_history(path) as history:
                summary = {"file": name, **summarise_case(history)}
        except (HistoryError, OSError) as error:
            return {"file": name, "problem": str(error)}
        self._known[path] = _Known(stamp, summary)
        return {**summary}


def summarise_case(history: History) -> dict[str, Any]:
    """Returns the data of a case for the page."""
    state = history.state()
    generations = history.generations()
    status = history.datasets.read("evaluations/status")
    seconds = history.datasets.read("evaluations/seconds")
    planned = int(history.attributes["generations"])
    done = len(generations)
    objective = history.objectives[0]
    evaluated = int(np.count_nonzero(status >= Status.DONE))
    failed = status == Status.FAILED
    summary: dict[str, Any] = {
        "name": str(history.attributes.get("case", history.path.stem)),
        "campaign": str(history.attributes.get("campaign", "")),
        "state": "finished"
        if state.finished
        else {
            Writer.WRITING: "running",
            Writer.CLOSED: "stopped",
            Writer.GONE: "interrupted",
        }[state.writer],
        "state_text": str(state),
        "generation": done,
        "generations": planned,
        "evaluations": evaluated,
        "failures": int(np.count_nonzero(failed)),
        "last_failure": _find_last_failure(history, failed),
        "objective": objective.name,
        "objective_label": title(objective.name),
        "unit": objective.unit,
        "sign": objective.sign,
        "wall_time": state.wall_time,
        "convergence": [
            _numbers(generations.best.values),
            _numbers(generations.best.standard_error),
            _numbers(generations.mean.values),
        ],
        **_left(history, seconds[status == Status.DONE], done, planned,
                state.finished, generations.wall_time.values,
                generations.evaluations),
    }  # fmt: skip
    summary.update(_best(history))
    return summary


def _best(history: History) -> dict[str, Any]:
    """Returns the first objective of the baseline and of the best plant with
    standard errors, the gain with half of its 95 % interval [%], and whether
    both plants were re-evaluated at the end. Before that, the objective of the
    best plant is its expectation given its generation (shrinkage), since the
    value by which it was selected is too good on average."""
    pair = history.comparison()
    is_final = pair is not None and pair.is_final
    baseline = best = gain = None
    if pair is not None:
        baseline, best = pair.baseline.objective, pair.best.objective
        if not is_final:
            rows = history.latest().done
            best = shrunken(rows, int(rows.ranking(1)[0]))
        gain = pair.gain if is_final else relative_gain(best, baseline)
        # A decrease of a minimised objective is a gain, also of negative values.
        better = history.objectives[0].sign * np.sign(baseline.mean)
        gain = gain.scaled(float(better), "%")
    return {
        "baseline": _pair(baseline),
        "best": _pair(best),
        "gain": gain and _numbers([gain.mean, NORMAL * gain.standard_error]),
        "is_final": is_final,
    }


def _find_last_failure(history: History, failed: Any) -> str:
    if not failed.any():
        return ""
    row = int(np.flatnonzero(failed)[-1])
    return history.datasets.texts("evaluations/message")[row]


def _left(
    history: History,
    seconds: Any,
    done: int,
    planned: int,
    is_finished: bool,
    times: Any,
    counts: Any,
) -> dict[str, Any]:
    """Returns the current rate [evaluations/s], the time left [s] and the core
    hours left; None for numbers that are not known yet."""
    rate = left = None
    if len(times) > 1:
        first = max(0, len(times) - 1 - RECENT)
        passed = float(times[-1] - times[first])
        if passed > 0:
            rate = float(counts[first + 1 :].sum()) / passed
            left = (planned - done) * passed / (len(times) - 1 - first)
    elif len(times) == 1 and times[0] > 0:
        rate, left = counts[0] / times[0], (planned - done) * float(times[0])
    hours = None
    known = seconds[np.isfinite(seconds)]
    if len(known) and done:
        per_generation = counts.sum() / done
        hours = float((planned - done) * per_generation * known.mean() / 3600)
    if is_finished:
        left, hours = 0.0, 0.0
    return {"rate": rate, "seconds_left": left, "core_hours_left": hours}


def _numbers(values: Any) -> list[float | None]:
    return [float(v) if np.isfinite(v) else None for v in values]


def _pair(estimate: Estimate | None) -> list[float | None] | None:
    if estimate is None:
        return None
    return _numbers([estimate.mean, estimate.standard_error])
