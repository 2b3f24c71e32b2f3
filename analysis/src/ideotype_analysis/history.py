"""A history: one case of a campaign, as FORMAT.md specifies it."""

from __future__ import annotations

import tomllib
from functools import cached_property
from pathlib import Path
from types import TracebackType
from typing import Self

import numpy as np
from numpy.typing import NDArray

from .datasets import Datasets
from .file import HistoryError, missing_bytes, text, writer_of
from .pair import Pair
from .rows import Evaluation, Origin, Rows, Status
from .state import Generations, Session, State
from .table import Quantity, Table
from .traits import Traits

Columns = tuple[tuple[str, ...], tuple[str, ...]]
"""Names and units."""

_FINAL = -1
"""Stands for the generation of a finalist."""


def open_history(path: str | Path) -> History:
    """Opens a history to read: finished, stopped, killed, or being written.

    Raises FileNotFoundError, or HistoryError if the file is no history, is
    damaged, or is of another major format version. HDF5 may take minutes over
    a damaged file: where one is to be expected, open_study() tries each file
    for a limited time first."""
    return History(path)


class History:
    """A context manager. Every call looks at the file anew, so that calling
    again follows a run; complete rows never change."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        self._data = Datasets(path)
        try:
            self.attributes = self._data.attributes()
            self.population = int(self.attributes["population"])
            self.traits = Traits(
                tuple(
                    name.replace("_inclination", "_insertion_angle")
                    for name in self._data.texts("traits/name")
                ),
                self._data.texts("traits/unit"),
                self._data.read("traits/lower"),
                self._data.read("traits/upper"),
                self._data.read("traits/is_circular").astype(bool),
                self._data.read("traits/is_free").astype(bool),
            )
            self._objectives = self._columns("objectives")
            self._diagnostics = self._columns("diagnostics")
        except KeyError as error:
            self.close()
            raise HistoryError(f"{path}: has no {error}") from error
        except HistoryError:
            self.close()
            raise

    def __repr__(self) -> str:
        return f"<History {self.path}>"

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Lets go of the file."""
        self._data.close()

    def evaluations(self, generation: int | None = None) -> Rows:
        """Complete evaluations, done or failed: all, or of one generation,
        which need not be committed."""
        if generation is None:
            return self._rows("evaluations", 0, None)
        if generation < 0:
            raise ValueError(f"generation {generation} is negative")
        first = generation * self.population
        return self._rows("evaluations", first, first + self.population)

    def finalists(self) -> Rows:
        """Complete final evaluations; slot 0 is the baseline."""
        return self._rows("final", 0, None)

    def generations(self) -> Generations:
        """Summaries of the committed generations."""
        committed = self._data.read("generations/committed").astype(bool)
        count = len(committed) if committed.all() else int(committed.argmin())
        unit = self._objectives[1][0]
        unknown = np.full(count, np.nan)

        def integers(name: str) -> NDArray[np.int64]:
            return self._data.read(f"generations/{name}", 0, count).astype(int)

        def quantity(name: str, unit: str) -> Quantity:
            values = self._data.read(f"generations/{name}", 0, count)
            return Quantity(name, unit, values, unknown)

        best = self._data.read("generations/best", 0, count)
        error = self._data.read("generations/best_standard_error", 0, count)
        return Generations(
            best_slot=integers("best_slot"),
            best=Quantity("best", unit, best, error),
            mean=quantity("mean", unit),
            spread=quantity("spread", unit),
            diversity=quantity("diversity", "1"),
            failures=integers("failures"),
            evaluations=integers("evaluations"),
            wall_time=quantity("wall_time", "s"),
        )

    def baseline(self) -> Evaluation | None:
        """The unbred plant: its final evaluation if the finals are complete,
        else its latest in the run; None if there is none yet."""
        if (pair := self._final_pair()) is not None:
            return pair.baseline
        done = self.evaluations().done
        found = np.flatnonzero(done.origin == Origin.BASELINE)
        return done.one(int(found[-1]), False) if len(found) else None

    def best(self) -> Evaluation | None:
        """The fittest finalist but the baseline if the finals are complete.
        Else, provisionally, the fittest of the last committed generation, or
        of all rows before the first; None if nothing is done yet."""
        if (pair := self._final_pair()) is not None:
            return pair.best
        top = self.latest().top(1)
        return top.one(0, False) if len(top) else None

    def comparison(self) -> Pair | None:
        """Baseline and best, if both are known."""
        if (pair := self._final_pair()) is not None:
            return pair
        baseline, best = self.baseline(), self.best()
        if baseline is None or best is None:
            return None
        return Pair(baseline, best)

    def latest(self) -> Rows:
        """The last committed generation, or all complete rows before the
        first commit."""
        count = len(self.generations())
        return self.evaluations(count - 1 if count else None)

    def state(self) -> State:
        """Whether the case is running, stopped, interrupted or finished."""
        finished = bool(self._data.read("state/finished"))
        return State(
            writer_of(self.path),
            finished,
            text(self._data.read("state/reason")) if finished else "",
            float(self._data.read("state/wall_time")),
            missing_bytes(self.path),
        )

    def sessions(self) -> list[Session]:
        """The starts of the program, oldest first."""
        return [
            Session(
                text(entry["started"]),
                text(entry["host"]),
                text(entry["command"]),
                int(entry["ranks"]),
            )
            for entry in self._data.read("sessions")
            if text(entry["started"])
        ]

    def messages(self) -> list[str]:
        """What the user should know, oldest first."""
        return [line for line in self._data.texts("messages") if line]

    def campaign(self, form: str = "source") -> str:
        """The campaign file, "source" as the user wrote it or "resolved"
        with every default."""
        return text(self._data.read(f"campaign/{form}"))

    @cached_property
    def is_isolated(self) -> bool:
        """Whether the plants are a plot alone, lit from all sides, and not a
        stand without end."""
        try:
            campaign = tomllib.loads(self.campaign("resolved"))
        except tomllib.TOMLDecodeError:
            return False
        return campaign.get("field", {}).get("boundary") == "isolated"

    def read_all(self) -> None:
        """Reads all that the other calls read. Raises HistoryError if some of
        it is missing or damaged."""
        self.evaluations()
        self.finalists()
        self.generations()
        self.state()
        self.sessions()
        self.messages()
        for form in ("source", "resolved"):
            self.campaign(form)

    def _final_pair(self) -> Pair | None:
        """The finalists' verdict, once none of them is pending."""
        status = self._data.read("final/status")
        if not len(status) or status[0] != Status.DONE:
            return None
        if np.any(status == Status.PROPOSED):
            return None
        done = self.finalists().done
        bred = done.take(done.slot > 0).top(1)
        if not len(bred):
            return None
        return Pair(done.one(0, True), bred.one(0, True))

    def _rows(self, group: str, first: int, last: int | None) -> Rows:
        # FORMAT.md: the status decides, so it is read before all else.
        status = self._data.read(f"{group}/status", first, last)
        complete = np.flatnonzero(status >= Status.DONE)
        last = first + int(complete[-1]) + 1 if len(complete) else first

        def read(name: str) -> NDArray:
            return self._data.read(f"{group}/{name}", first, last)[complete]

        def table(columns: Columns, name: str) -> Table:
            error = read(f"{name}_standard_error")
            return Table(*columns, read(name), error)

        genome = read("genome")
        number = first + complete
        if group == "final":
            generation, slot = np.full(len(number), _FINAL), number
        else:
            generation, slot = np.divmod(number, self.population)
        objectives = table(self._objectives, "objectives")
        # The file keeps no standard error of the fitness: it is that of the
        # first objective.
        error = objectives.standard_error[:, 0]
        seconds = read("seconds")
        return Rows(
            generation=generation,
            slot=slot,
            status=status[complete].astype(int),
            origin=read("origin").astype(int),
            parents=read("parents").astype(int),
            traits=Table(
                self.traits.names,
                self.traits.units,
                genome,
                np.zeros_like(genome),
            ),
            objectives=objectives,
            diagnostics=table(self._diagnostics, "diagnostics"),
            fitness=Quantity(
                "fitness", objectives.units[0], read("fitness"), error
            ),
            attempt=read("attempt").astype(int),
            seconds=Quantity("seconds", "s", seconds, np.zeros_like(seconds)),
            worker=read("worker").astype(int),
            message=np.array([text(m) for m in read("message")], dtype=str),
        )

    def _columns(self, group: str) -> Columns:
        return self._data.texts(f"{group}/name"), self._data.texts(
            f"{group}/unit"
        )
