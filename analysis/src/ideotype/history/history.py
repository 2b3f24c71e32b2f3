# SPDX-License-Identifier: Apache-2.0
"""Reads a history: the file that records the search of one case of a campaign.
FORMAT.md specifies the format."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import fields
from functools import cached_property
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from .atlas import Atlas, make_atlas
from .columns import columns
from .datasets import Datasets
from .file import HistoryError, find_writer
from .from_columns import make_rows
from .front import Front, make_front
from .genes import Genes
from .integrity import verify
from .pair import Pair
from .quantity import Objective, Quantity
from .rows import Evaluation, Origin, Rows, Status
from .state import Generations, Session, State

_SESSION = tuple(field.name for field in fields(Session))


def _read_kinds(
    genes: Mapping[str, Any],
) -> tuple[tuple[str, ...], tuple[tuple[str, ...], ...]]:
    """Returns kinds and values of genes; both are empty if all genes are
    real."""
    if "kind" not in genes:
        return (), ()
    texts = genes["values"].values.tolist()
    return (
        tuple(genes["kind"].values.tolist()),
        tuple(tuple(text.split("\n") if text else ()) for text in texts),
    )


def open_history(path: str | Path) -> History:
    """Opens a history for reading: finished, stopped, killed, or being
    written.

    Raises FileNotFoundError, or HistoryError if the file is no history, is
    damaged, or is of another major format version."""
    return History(path)


class History:
    """A history, as a context manager. Each call reads the file again, so that
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
                *_read_kinds(genes),
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
        """Verifies the checksums of recorded data. Raises HistoryError if a
        part is damaged."""
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
        """Returns the complete evaluations, done or failed, of the whole
        history or of one generation, which need not be committed."""
        if generation is None:
            return self._read("evaluations")
        if generation < 0:
            raise ValueError(f"generation {generation} is negative")
        first = int(self.datasets.read("generations/first_row")[generation])
        count = int(self.datasets.read("generations/count")[generation])
        return self._read("evaluations", first, first + count)

    def unchecked(self) -> int:
        """Returns the number of complete evaluations in incomplete
        generations, which have no checksum."""
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
        table = columns(self.datasets, "generations")
        committed = table["committed"].values.astype(bool)
        count = len(committed) if committed.all() else int(committed.argmin())

        def integers(name: str) -> NDArray[np.int64]:
            return table[name].values[:count].astype(int)

        def quantity(name: str) -> Quantity:
            _, values, about = table[name]
            error = np.full(count, np.nan)
            if f"{name}_standard_error" in table:
                error = table[f"{name}_standard_error"].values[:count]
            units = about.get("units", "")
            return Quantity(name, units, values[:count], error)

        has_front = "hypervolume" in table
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
        """Returns the baseline plant: its final evaluation if the finals are
        complete, else its latest evaluation in the run; None if it is not
        evaluated yet."""
        if (pair := self._final_pair()) is not None:
            return pair.baseline
        done = self.evaluations().done
        rows = np.flatnonzero(done.origin == Origin.BASELINE)
        return done.one(int(rows[-1]), False) if len(rows) else None

    def best(self) -> Evaluation | None:
        """Returns the best finalist except the baseline if the finals are
        complete; else, provisionally, the best plant of the last committed
        generation, or of all rows before the first commit. None if no row is
        done yet."""
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
        """Returns the Pareto front of a search for several objectives: of the
        finalists without the baseline if the finals are complete; else,
        provisionally, of the last committed generation, or of all rows before
        the first commit. None for a single objective, or if no row is done
        yet."""
        if len(self.objectives) < 2:
            return None
        if (done := self._finals()) is not None:
            return make_front(done.take(done.slot > 0), done.one(0, True))
        baseline = self.baseline()
        return make_front(self.latest(), baseline) if baseline else None

    def atlas(self) -> Atlas | None:
        """Returns the atlas if the search makes one and its finals are
        complete, else None."""
        axes = self.resolved.get("search", {}).get("axes")
        if not axes or (done := self._finals()) is None:
            return None
        return make_atlas(axes, done.take(done.slot > 0), self.evaluations())

    def latest(self) -> Rows:
        """Returns the last committed generation, or all complete rows before
        the first commit."""
        count = len(self.generations())
        return self.evaluations(count - 1 if count else None)

    @property
    def is_sensitivity(self) -> bool:
        """Whether the history contains a sensitivity study, which has no best
        plant."""
        return "sensitivity" in self.resolved

    def state(self) -> State:
        """Returns whether the case is running, stopped, interrupted or
        finished."""
        finished = bool(self.datasets.read("state/finished"))
        return State(
            find_writer(self.path),
            finished,
            self.datasets.texts("state/reason")[0] if finished else "",
            float(self.datasets.read("state/wall_time")),
        )

    def sessions(self) -> list[Session]:
        """Returns the starts of the program, oldest first."""
        table = columns(self.datasets, "sessions")
        rows = zip(*(table[name].values.tolist() for name in _SESSION))
        return [session for row in rows if (session := Session(*row)).started]

    def messages(self) -> list[str]:
        """Returns the messages for the user, oldest first."""
        return [line for line in self.datasets.texts("messages/text") if line]

    def campaign(self, form: str = "source") -> str:
        """Returns the campaign file, "source" as the user wrote it or
        "resolved" with every default."""
        return self.datasets.texts(f"campaign/{form}")[0]

    @cached_property
    def resolved(self) -> dict[str, Any]:
        """The tables of the campaign with every default; empty if the history
        lacks them."""
        try:
            return tomllib.loads(self.campaign("resolved"))
        except (HistoryError, tomllib.TOMLDecodeError):
            return {}

    @property
    def is_isolated(self) -> bool:
        """Whether the plants are an isolated plot, which receives light from
        the sides, not a periodic field."""
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
        table = columns(self.datasets, group, first, last)
        starts = None
        if group == "evaluations":
            count = self.datasets.read("generations/count")
            starts = self.datasets.read("generations/first_row").astype(int)
            # Generations without rows follow those with rows.
            starts = starts[: np.count_nonzero(count)]
        return make_rows(table, starts, self.genes, self.objectives)

    def _finals(self) -> Rows | None:
        """Returns the finalists that are done, the baseline first; None while
        the baseline or another finalist is pending."""
        status = self.datasets.read("final/status")
        if not len(status) or status[0] != Status.DONE:
            return None
        if np.any(status == Status.PROPOSED):
            return None
        return self.finalists().done

    def _final_pair(self) -> Pair | None:
        """Returns the baseline and the best plant of the finalists; None while
        a finalist is pending."""
        if (done := self._finals()) is None:
            return None
        best = done.take(done.slot > 0).top(1)
        return (
            Pair(done.one(0, True), best.one(0, True)) if len(best) else None
        )
