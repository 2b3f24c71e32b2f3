# SPDX-License-Identifier: Apache-2.0
"""Writes the answers of an adapter to all cases that it can compute."""

from __future__ import annotations

import csv
import sys
from collections.abc import Callable
from pathlib import Path

HERE = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(HERE))

from cases import Case, read_cases  # noqa: E402

Answer = Callable[[Case], dict[str, tuple[float, float | None]]]


def write_answers(name: str, answer: Answer) -> None:
    """Writes answers/NAME.csv. Cases that the adapter cannot compute are
    omitted."""
    folder = HERE / "answers"
    folder.mkdir(exist_ok=True)
    with (folder / f"{name}.csv").open("w") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["case", "quantity", "value", "standard_error"])
        for each, case in read_cases().items():
            found = answer(case)
            for quantity in filter(found.get, case["quantities"]):
                value, error = found[quantity]
                text = "" if error is None else f"{error:.3g}"
                out.writerow([each, quantity, f"{value:.8g}", text])
            file.flush()
