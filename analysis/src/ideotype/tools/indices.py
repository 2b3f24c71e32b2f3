# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype indices`."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..errors import did_you_mean, printable_lines
from ..history.file import HistoryError
from ..history.history import History, open_history
from ..history.indices import NORMAL, Indices, indices_of


def main(arguments: Sequence[str] | None = None) -> int:
    """Prints the indices of a history and returns the exit code: 0, or 1 if
    the history has no indices."""
    parser = argparse.ArgumentParser(
        prog="ideotype indices",
        description="Prints the sensitivity indices of the objectives of a "
        "finished sensitivity study with 95 % intervals, the most important "
        "factors first.",
    )
    add = parser.add_argument
    add("file", help="history of `ideotype sensitivity`")
    add(
        "--quantity", action="append", default=[],
        help="also print the indices of this quantity, such as lai",
    )  # fmt: skip
    add("--json", action="store_true", help="print all quantities as JSON")
    options = parser.parse_args(arguments)
    try:
        with open_history(options.file) as history:
            print(printable_lines(_format_indices(history, options)))
    except (HistoryError, OSError) as error:
        print(printable_lines(f"ideotype: {error}"), file=sys.stderr)
        return 1
    return 0


def _format_indices(history: History, options: argparse.Namespace) -> str:
    indices = indices_of(history)
    if not indices:
        raise HistoryError(
            f"{history.path}: "
            + (
                "the sensitivity study is not finished yet; resume it with "
                "ideotype sensitivity CAMPAIGN --resume"
                if history.is_sensitivity
                else "this is no history of a sensitivity study; write one "
                "with ideotype sensitivity CAMPAIGN"
            )
        )
    case = str(history.attributes["case"])
    if options.json:
        table = {name: _to_json(part) for name, part in indices.items()}
        return json.dumps({"case": case, "quantities": table}, indent=2)
    names = [x.name for x in history.objectives] + options.quantity
    for name in options.quantity:
        if name not in indices:
            raise HistoryError(
                f"--quantity: there is no '{name}'"
                + did_you_mean(name, list(indices))
            )
    text = "\n\n".join(f"{case}  {_to_text(indices[name])}" for name in names)
    known = indices[names[0]].samples
    samples = history.resolved["sensitivity"]["samples"]
    if known < samples:
        text += (
            f"\n{samples - known} of {samples} samples have failed rows; the "
            "indices are from the others"
        )
    return text


def _to_json(indices: Indices) -> dict[str, Any]:
    def number(x: float) -> float | None:
        return float(x) if np.isfinite(x) else None

    def factor_indices(k: int) -> dict[str, Any]:
        return {
            name: {
                "mean": number(values[k]),
                "standard_error": number(indices.standard_error[name][k]),
            }
            for name, values in indices.index.items()
        }

    return {
        "unit": indices.unit,
        "mean": number(indices.mean),
        "standard_deviation": number(indices.standard_deviation),
        "noise_standard_deviation": number(indices.noise),
        "samples": indices.samples,
        "factors": {
            x: factor_indices(k) for k, x in enumerate(indices.factors)
        },
    }


def _to_text(indices: Indices) -> str:
    head = (
        f"{indices.quantity} [{indices.unit}]: mean {indices.mean:.6g}, standard "
        f"deviation {indices.standard_deviation:.3g} (without that of noise, "
        f"{indices.noise:.2g}); {indices.samples} samples, 95 % intervals"
    )
    rows = [("factor", *indices.index)]
    for k in np.argsort(-np.nan_to_num(indices.main), kind="stable"):
        cells = (
            _with_interval(values[k], indices.standard_error[name][k])
            for name, values in indices.index.items()
        )
        rows.append((indices.factors[k], *cells))
    lines = (
        f"  {factor:<32}" + "".join(f"{cell:>28}" for cell in cells)
        for factor, *cells in rows
    )
    return "\n".join([head, *lines])


def _with_interval(value: float, error: float) -> str:
    if not np.isfinite(value):
        return "-"
    if not np.isfinite(error):
        return f"{value:.4g}"
    half = NORMAL * error
    digits = 4 if half <= 0 else int(1 - np.floor(np.log10(half)))
    digits = min(max(digits, 0), 4)
    low, high = value - half, value + half
    return f"{value:.{digits}f} ({low:.{digits}f} .. {high:.{digits}f})"


if __name__ == "__main__":
    sys.exit(main())
