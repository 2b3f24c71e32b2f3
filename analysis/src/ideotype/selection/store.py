# SPDX-License-Identifier: Apache-2.0
"""The stored evaluations of a selection, from which it resumes after a
kill."""

from __future__ import annotations

import json
import sqlite3
from contextlib import closing
from pathlib import Path
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from ..common.output import OutputRefused, require_output

Array = NDArray[np.float64]


class Store:
    """The evaluations of a selection in a SQLite file, one row each with the
    objective by randomisation. Without a path they are only in memory."""

    def __init__(self, path: Path | None = None, inputs: str = "") -> None:
        """Opens or creates the file.

        inputs: digest of all inputs of the selection.

        Raises OutputRefused if the file belongs to other inputs."""
        if path is not None:
            require_output(path)
        self._lock = Lock()
        self._file = sqlite3.connect(
            path or ":memory:", check_same_thread=False
        )
        try:
            with self._file:
                self._file.executescript(
                    "CREATE TABLE IF NOT EXISTS selection (inputs TEXT);"
                    "CREATE TABLE IF NOT EXISTS evaluation (digest TEXT "
                    "PRIMARY KEY, case_name TEXT, generation INTEGER, genome "
                    "TEXT, objective TEXT);"
                )
                rows = self._file.execute("SELECT inputs FROM selection")
                known = [row[0] for row in rows]
                if not known:
                    self._file.execute(
                        "INSERT INTO selection VALUES (?)", [inputs]
                    )
        except sqlite3.DatabaseError as error:
            raise OutputRefused(
                f"{path}: {error}; choose another folder"
            ) from None
        if known and known[0] != inputs:
            self.close()
            raise OutputRefused(
                f"{path}: this folder has the selection of another trial, "
                "campaign or option; choose another folder"
            )

    def find(self, digest: str) -> Array | None:
        """Returns a stored objective by randomisation."""
        with self._lock:
            row = self._file.execute(
                "SELECT objective FROM evaluation WHERE digest = ?", [digest]
            ).fetchone()
        return None if row is None else np.array(json.loads(row[0]))

    def add(
        self, digest: str, case: str, generation: int, genome: Array,
        objective: Array,
    ) -> None:  # fmt: skip
        """Stores an evaluation durably."""
        row = (
            digest, case, generation, json.dumps(genome.tolist()),
            json.dumps(objective.tolist()),
        )  # fmt: skip
        with self._lock, self._file:
            self._file.execute(
                "INSERT OR IGNORE INTO evaluation VALUES (?, ?, ?, ?, ?)", row
            )

    def __len__(self) -> int:
        with self._lock, closing(self._file.cursor()) as cursor:
            cursor.execute("SELECT count(*) FROM evaluation")
            return int(cursor.fetchone()[0])

    def close(self) -> None:
        """Closes the file."""
        self._file.close()
