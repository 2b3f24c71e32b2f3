# SPDX-License-Identifier: Apache-2.0
"""Studies: the cases of campaigns and their replicates, from many
histories."""

from __future__ import annotations

import glob
import os
import re
from collections import Counter
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Self

from .case import Case
from .coordinates import natural
from .file import HistoryError
from .history import History, open_history

if TYPE_CHECKING:
    import pandas

Location = str | os.PathLike[str]


def open_study(*places: Location, skip_damaged: bool = False) -> Study:
    """Opens the histories given by files, folders (searched recursively) and
    glob patterns, in the order of their names and each only once. All data are
    read and compared with their checksums.

    Raises FileNotFoundError or HistoryError with the file and a remedy. With
    `skip_damaged` it raises only if no history can be used; `Study.damaged`
    has the errors of the others."""
    return Study(find_histories(*places), skip_damaged)


def find_histories(*places: Location) -> list[Path]:
    """Returns the files given by the arguments of open_study(), and raises its
    errors."""
    if not places:
        raise HistoryError(
            "no history is given; name files, folders or patterns"
        )
    paths: dict[Path, Path] = {}
    for place in places:
        for path in _list_histories(place):
            paths.setdefault(path.resolve(), path)
    return list(paths.values())


def _list_histories(place: Location) -> list[Path]:
    path = Path(place)
    if path.is_dir():
        files = sorted(path.rglob("*.h5"), key=lambda x: natural(str(x)))
        if not files:
            raise HistoryError(
                f"{path}: there is no history (.h5) in this folder; name the "
                "folder that `ideotype run --out` wrote"
            )
        return files
    if not path.exists() and glob.has_magic(str(place)):
        matches = sorted(glob.glob(str(place), recursive=True), key=natural)
        if not matches:
            raise HistoryError(f"{place}: no file matches this pattern")
        return [file for match in matches for file in _list_histories(match)]
    if not path.exists():
        raise FileNotFoundError(f"{path}: there is no such file")
    return [path]


class Study:
    """Several histories as a sequence and a context manager."""

    def __init__(self, paths: list[Path], skip_damaged: bool = False) -> None:
        self._histories: list[History] = []
        self.damaged: list[Exception] = []
        """The errors of the histories that were left out."""
        with ExitStack() as stack:
            for path in paths:
                try:
                    history = stack.enter_context(open_history(path))
                    history.read_all()
                except (HistoryError, OSError) as error:
                    if not skip_damaged:
                        raise
                    self.damaged.append(error)
                else:
                    self._histories.append(history)
            if not self._histories:
                raise self.damaged[0]
            self._stack = stack.pop_all()

    def __repr__(self) -> str:
        return f"<Study, histories: {len(self)}>"

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Closes all files."""
        self._stack.close()

    def __len__(self) -> int:
        return len(self._histories)

    def __iter__(self) -> Iterator[History]:
        return iter(self._histories)

    def __getitem__(self, index: int) -> History:
        return self._histories[index]

    def cases(self) -> list[Case]:
        """Returns the cases with their replicates, in the order of the files.
        Histories with different campaigns, objectives or optimizers are
        different cases; their names contain the difference if necessary."""
        members: dict[_Identity, list[History]] = {}
        for history in self._histories:
            members.setdefault(_identity(history), []).append(history)
        shared = Counter(name for _, name in {key[:2] for key in members})
        return [
            Case(
                _make_name(key, [*members]),
                histories,
                # Cross-evaluations do not name campaigns.
                light=key[1] if shared[key[1]] == 1 else "",
            )
            for key, histories in members.items()
        ]

    def results(self) -> pandas.DataFrame:
        """Returns one line for each case: coordinates, baseline, best, gain
        with the ends of its 95 % confidence interval, leaf area index, number
        of searches. Units are in .attrs["units"]."""
        from .results import results_of

        return results_of(
            [case for case in self.cases() if not case.is_sensitivity]
        )

    def frame(self) -> pandas.DataFrame:
        """Returns all complete evaluations of all histories, one per row.
        .attrs["units"] has the units of columns."""
        from .frame import make_frame

        return make_frame(self._histories)


_Identity = tuple[str, str, str, str]
"""The properties that distinguish cases: campaign, name, objectives,
optimizer."""


def _identity(history: History) -> _Identity:
    objectives = (
        f"{'less ' * (g.sign < 0)}{g.name}" for g in history.objectives
    )
    return (
        str(history.attributes.get("campaign", "")),
        name_without_replicate(history),
        ", ".join(objectives),
        history.resolved.get("search", {}).get("optimizer", "ga"),
    )


def _make_name(key: _Identity, keys: list[_Identity]) -> str:
    name = key[1]
    if len({campaign for campaign, *_ in keys}) > 1:
        name = f"{key[0]}: {name}"
    namesakes = [other for other in keys if other[:2] == key[:2]]
    differing = [
        part for part, parts in zip(key, zip(*namesakes)) if {*parts} != {part}
    ]
    return f"{name} ({'; '.join(differing)})" if differing else name


def name_without_replicate(history: History) -> str:
    """Returns "ames_0807_762x152_all" for "ames_0807_762x152_all_r2"."""
    name = str(history.attributes.get("case", history.path.stem))
    return re.sub(r"[_-]r\d+$", "", name)
