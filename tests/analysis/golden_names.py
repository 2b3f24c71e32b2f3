# SPDX-License-Identifier: Apache-2.0
"""Gives the results of a history their names in the golden files."""

from __future__ import annotations

from collections.abc import Iterator

import h5py
import numpy as np

EXACT = ("incident", "balance_error", "paths", "capped", "lai")
PARTS = ("absorbed", "stalk", "soil", "reflected")


def figures(file: h5py.File) -> dict[str, np.ndarray]:
    """Returns all results that the golden files contain."""
    values_by_name = {}
    for part in ("evaluations", "final"):
        rows = file[part]
        for i, gene in enumerate(file["genes/gene"].asstr()[:]):
            values_by_name[f"{part}.{gene}"] = rows["genome"][:, i]
        for name, values, errors in _columns(file, rows):
            values_by_name[f"{part}.{name}"] = values
            values_by_name[f"{part}.{name}.standard_error"] = errors
        status, violation = rows["status"][:], rows["violation"][:]
        values_by_name[f"{part}.violation"] = violation
        values_by_name[f"{part}.violation.standard_error"] = 0 * violation
        fitness = np.where(violation > 0, -violation, rows["objectives"][:, 0])
        values_by_name[f"{part}.fitness"] = np.where(
            status == 3, -np.inf, fitness
        )
        values_by_name[f"{part}.status"], values_by_name[f"{part}.origin"] = (
            status,
            rows["origin"][:],
        )
        values_by_name[f"{part}.parents"] = _slots(file, rows["parents"][:])
    generations = file["generations"]
    for name in ("best", "best_standard_error", "mean", "spread", "diversity"):
        values_by_name[f"generations.{name}"] = generations[name][:]
    best = generations["best_row"][:]
    values_by_name["generations.best_slot"] = _slots(file, best)
    violation = file["evaluations/violation"][:][best]
    values = values_by_name["generations.best"]
    values_by_name["generations.best"] = np.where(
        violation > 0, -violation, values
    )
    return values_by_name


def _slots(file: h5py.File, rows: np.ndarray) -> np.ndarray:
    """Returns the slots of rows in their generations; -1 remains -1."""
    first = file["generations/first_row"][:]
    generation = np.searchsorted(first, rows, side="right") - 1
    return np.where(rows < 0, rows, rows - first[generation])


def _columns(
    file: h5py.File, rows: h5py.Group
) -> Iterator[tuple[str, np.ndarray, np.ndarray]]:
    """Yields names, values and standard errors of objectives and
    diagnostics."""
    errors = rows["objectives_standard_error"]
    for i, name in enumerate(file["objectives/objective"].asstr()[:]):
        yield name, rows["objectives"][:, i], errors[:, i]
    for name in (*EXACT, *(f"{part}_fraction" for part in PARTS)):
        values = rows[name][:]
        error = rows.get(f"{name}_standard_error")
        yield name, values, 0 * values if error is None else error[:]
    for axis in ("leaf", "layer", "hour", "source", "side"):
        values = rows[f"absorbed_by_{axis}"]
        errors = rows[f"absorbed_by_{axis}_standard_error"]
        scale = values.dims[1][0]
        words = scale.asstr()[:] if scale.dtype.kind == "S" else scale[:]
        for i, word in enumerate(_endings(axis, words)):
            yield f"absorbed_{word}", values[:, i], errors[:, i]


def _endings(axis: str, labels: np.ndarray) -> list[str]:
    """Returns the words that followed "absorbed_" in the name of each
    column."""
    if axis == "leaf":
        return [f"leaf{rank:02}" for rank in labels]
    if axis == "hour":
        minutes = np.rint(60 * labels).astype(int)
        return [f"hour_{m // 60:02}_{m % 60:02}" for m in minutes]
    if axis == "layer":
        ends, lower = [], 0.0
        for middle in labels:
            upper = 2 * middle - lower
            edges = f"{round(100 * lower):03}_{round(100 * upper):03}"
            ends.append(f"layer_{edges}cm")
            lower = upper
        return ends
    return [str(label) for label in labels]
