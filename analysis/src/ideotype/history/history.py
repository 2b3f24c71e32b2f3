# SPDX-License-Identifier: Apache-2.0
"""A history: one case of a campaign, as FORMAT.md specifies it."""

from __future__ import annotations

import tomllib
from dataclasses import fields
from functools import cached_property
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from .atlas import Atlas, atlas_of
from .columns import columns
from .datasets import Datasets
from .file import HistoryError, writer_of
from .front import Front, front_of
from .genes import Genes
from .integrity import verify
from .pair import Pair
from .quantity import Objective, Quantity
from .rows import Evaluation, Origin, Rows, Status
from .rows_of import rows_of
from .state import Generations, Session, State

_SESSION = tuple(field.name for field in fields(Session))


def open_history(path: str | Path) -> History:
    """Opens a history to read: finished, stopped, killed, or being written.

    Raises FileNotFoundError, or HistoryError if the file is no history, is
    damaged, or is of another major format version."""
    return History(path)


class History:
    """A history as a context manager. Every call reads the file again, so that
    repeated calls follow a run; complete rows never change."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        data = Datasets(path)
        try:
            self.datasets = data
            self.attributes = data.attributes()
            self.population = int(self.attributes["population"])
            genes = columns(data, "genes")
            self.genes = Genes(
                tuple(genes["gene"].values.tolist()),
                tuple(genes["trait"].values.tolist()),
                genes["leaf"].values.astype(int),
                tuple(genes["unit"].values.tolist()),
                genes["lower"].values,
                genes["upper"].values,
                genes["is_circular"].values.astype(bool),
                genes["is_free"].values.astype(bool),
            )
            objectives = columns(data, "objectives")
            names = ("objective", "unit", "sense")
            rows = zip(*(objectives[name].values.tolist() for name in names))
            self.objectives = tuple(Objective(*row) for row in rows)
            self.verify()
        except BaseException as error:
            data.close()
            if isinstance(error, Exception) and not isinstance(
                error, HistoryError
            ):
                raise HistoryError(f"{path}: damaged ({error!r})") from error
            raise

    def verify(self) -> None:
        """Compares recorded data with their checksums. Raises HistoryError if
        a part is damaged."""
        verify(self.datasets)

    def __repr__(self) -> str:
        return f"<History {self.path}>"

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Closes the file."""
        self.datasets.close()

    def evaluations(self, generation: int | None = None) -> Rows:
        """Returns complete evaluations, done or failed, of the whole history
        or of one generation, which need not be committed."""
        if generation is None:
            return self._read("evaluations")
        if generation < 0:
            raise ValueError(f"generation {generation} is negative")
        first = int(self.datasets.read("generations/first_row")[generation])
        count = int(self.datasets.read("generations/count")[generation])
        return self._read("evaluations", first, first + count)

    def unchecked(self) -> int:
        """Counts complete evaluations of incomplete generations, which have no
        checksum."""
        committed = self.datasets.read("generations/committed").astype(bool)
        count = self.datasets.read("generations/count")
        status = self.datasets.read("evaluations/status")
        complete = committed.cumprod().astype(bool)
        first = int(count[complete].sum())
        return int(np.count_nonzero(status[first:] >= Status.DONE))

    def finalists(self) -> Rows:
        """Returns complete final evaluations; slot 0 is the baseline."""
        return self._read("final")

    def generations(self) -> Generations:
        """Returns summaries of the committed generations."""
        found = columns(self.datasets, "generations")
        committed = found["committed"].values.astype(bool)
        count = len(committed) if committed.all() else int(committed.argmin())

        def integers(name: str) -> NDArray[np.int64]:
            return found[name].values[:count].astype(int)

        def quantity(name: str) -> Quantity:
            _, values, about = found[name]
            error = np.full(count, np.nan)
            if f"{name}_standard_error" in found:
                error = found[f"{name}_standard_error"].values[:count]
            units = about.get("units", "")
            return Quantity(name, units, values[:count], error)

        has_front = "hypervolume" in found
        return Generations(
            first_row=integers("first_row"),
            count=integers("count"),
            best_row=integers("best_row"),
            best=quantity("best"),
            mean=quantity("mean"),
            spread=quantity("spread"),
            diversity=quantity("diversity"),
            failures=integers("failures"),
            evaluations=integers("evaluations"),
            wall_time=quantity("wall_time"),
            hypervolume=quantity("hypervolume") if has_front else None,
        )

    def baseline(self) -> Evaluation | None:
        """Returns the unbred plant: its final evaluation if the finals are
        complete, or else its latest evaluation in the run; None if there is no
        evaluation yet."""
        if (pair := self._final_pair()) is not None:
            return pair.baseline
        done = self.evaluations().done
        found = np.flatnonzero(done.origin == Origin.BASELINE)
        return done.one(int(found[-1]), False) if len(found) else None

    def best(self) -> Evaluation | None:
        """Returns the fittest finalist except the baseline if the finals are
        complete, or else, provisionally, the fittest plant of the last
        committed generation, or of all rows before the first commit. None if
        no row is done yet."""
        if (pair := self._final_pair()) is not None:
            return pair.best
        top = self.latest().top(1)
        return top.one(0, False) if len(top) else None

    def comparison(self) -> Pair | None:
        """Returns the baseline and the best plant, if both are known."""
        if (pair := self._final_pair()) is not None:
            return pair
        baseline, best = self.baseline(), self.best()
        if baseline is None or best is None:
            return None
        return Pair(baseline, best)

    def front(self) -> Front | None:
        """Returns the front of a search for several objectives: the finalists
        without the baseline if the finals are complete, or else,
        provisionally, the front of the last committed generation, or of all
        rows before the first commit. None if there is a single objective, or
        no row is done yet."""
        if len(self.objectives) < 2:
            return None
        if (done := self._finals()) is not None:
            return front_of(done.take(done.slot > 0), done.one(0, True))
        baseline = self.baseline()
        return front_of(self.latest(), baseline) if baseline else None

    def atlas(self) -> Atlas | None:
        """Returns the atlas of the best plant of each kind, if the search
        makes an atlas and its finals are complete."""
        axes = self.resolved.get("search", {}).get("axes")
        if not axes or (done := self._finals()) is None:
            return None
        return atlas_of(axes, done.take(done.slot > 0), self.evaluations())

    def latest(self) -> Rows:
        """Returns the last committed generation, or all complete rows before
        the first commit."""
        count = len(self.generations())
        return self.evaluations(count - 1 if count else None)

    @property
    def is_sensitivity(self) -> bool:
        """Whether the history holds a sensitivity study, in which no plant is
        the best."""
        return "sensitivity" in self.resolved

    def state(self) -> State:
        """Returns whether the case is running, stopped, interrupted or
        finished."""
        finished = bool(self.datasets.read("state/finished"))
        return State(
            writer_of(self.path),
            finished,
            self.datasets.texts("state/reason")[0] if finished else "",
            float(self.datasets.read("state/wall_time")),
        )

    def sessions(self) -> list[Session]:
        """Returns the starts of the program, oldest first."""
        found = columns(self.datasets, "sessions")
        rows = zip(*(found[name].values.tolist() for name in _SESSION))
        return [each for row in rows if (each := Session(*row)).started]

    def messages(self) -> list[str]:
        """Returns messages that the user should know, oldest first."""
        return [line for line in self.datasets.texts("messages/text") if line]

    def campaign(self, form: str = "source") -> str:
        """Returns the campaign file, "source" as the user wrote it or
        "resolved" with every default."""
        return self.datasets.texts(f"campaign/{form}")[0]

    @cached_property
    def resolved(self) -> dict[str, Any]:
        """The campaign with every default; empty if the history has no
        resolved campaign."""
        try:
            return tomllib.loads(self.campaign("resolved"))
        except (HistoryError, tomllib.TOMLDecodeError):
            return {}

    @property
    def is_isolated(self) -> bool:
        """Whether the plants are an isolated plot, lit from all sides, and no
        periodic field."""
        return self.resolved.get("field", {}).get("boundary") == "isolated"

    def read_all(self) -> None:
        """Reads all data of the history. Raises HistoryError if data are
        missing or damaged."""
        self.evaluations()
        self.finalists()
        self.generations()
        self.state()
        self.sessions()
        self.messages()
        for form in ("source", "resolved"):
            self.campaign(form)

    def _read(
        self, group: str, first: int = 0, last: int | None = None
    ) -> Rows:
        found = columns(self.datasets, group, first, last)
        starts = None
        if group == "evaluations":
            count = self.datasets.read("generations/count")
            starts = self.datasets.read("generations/first_row").astype(int)
            # Generations that have no rows yet come after all generations with
            # rows.
            starts = starts[: np.count_nonzero(count)]
        return rows_of(found, starts, self.genes, self.objectives)

    def _finals(self) -> Rows | None:
        """Returns the finalists that are done, the baseline first, once the
        baseline is done and no finalist is pending."""
        status = self.datasets.read("final/status")
        if not len(status) or status[0] != Status.DONE:
            return None
        if np.any(status == Status.PROPOSED):
            return None
        return self.finalists().done

    def _final_pair(self) -> Pair | None:
        """Returns the baseline and the best plant of the finalists, once no
        finalist is pending."""
        if (done := self._finals()) is None:
            return None
        bred = done.take(done.slot > 0).top(1)
        return (
            Pair(done.one(0, True), bred.one(0, True)) if len(bred) else None
        )
