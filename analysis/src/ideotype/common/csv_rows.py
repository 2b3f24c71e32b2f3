# SPDX-License-Identifier: Apache-2.0
"""Reads the rows of CSV files from users, and collects their problems."""

from __future__ import annotations

import csv
import io
from dataclasses import dataclass, field
from pathlib import Path

from ..errors import Error
from .arrays import require_file


@dataclass
class Problems:
    """The problems of a file, which are reported together."""

    texts: list[str] = field(default_factory=list)

    def add(self, where: str, text: str) -> None:
        """Adds a problem at a place, such as FILE:LINE."""
        self.texts.append(f"{where}: {text}")

    def raise_any(self) -> None:
        """Raises Error with all problems, if there are any."""
        if self.texts:
            raise Error("\n".join(dict.fromkeys(self.texts)))


@dataclass(frozen=True)
class Rows:
    """The cells of a CSV file without blanks around them."""

    separator: str
    head: str
    """The place of the line of column names, as FILE:LINE."""
    names: list[str]
    rows: list[tuple[str, list[str]]]
    """The place and the cells of each row."""


def read_text(path: Path) -> str:
    """Returns a text in UTF-8. Raises Error if it cannot be read."""
    require_file(path)
    try:
        return path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise Error(f"{path}: {error}; save it as CSV in UTF-8") from None


def read_rows(path: Path, problems: Problems, separators: str = ",") -> Rows:
    """Reads a CSV file; lines that begin with # are comments. Of several
    separators the most frequent one in the first line counts. Rows with
    another number of cells than the first are problems, and so are columns
    with the same name in any case.

    Raises Error if the file cannot be read or is empty."""
    lines = [
        (f"{path}:{number}", line)
        for number, line in enumerate(read_text(path).splitlines(), 1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    if not lines:
        raise Error(
            f"{path}:1: this file is empty; begin with a line of column names"
        )
    separator = max(separators, key=lines[0][1].count)
    text = io.StringIO("\n".join(line for _, line in lines))
    try:
        names, *cells = [
            [cell.strip() for cell in row]
            for row in csv.reader(text, delimiter=separator)
        ]
    except csv.Error as error:
        raise Error(f"{path}: {error}; save it as CSV in UTF-8") from None
    head = lines[0][0]
    lower = [name.lower() for name in names]
    for name in sorted({name for name in lower if lower.count(name) > 1}):
        problems.add(head, f"two columns are named '{name}'; rename one")
    rows = []
    for (where, _), row in zip(lines[1:], cells):
        if len(row) == len(names):
            rows.append((where, row))
            continue
        problems.add(
            where,
            f"this row has {len(row)} cells and the table {len(names)} "
            f"columns; separate cells by one '{separator}' each, and write "
            "decimals with a point",
        )
    return Rows(separator, head, names, rows)
