# SPDX-License-Identifier: Apache-2.0
"""Makes a history of format 2.0 of one of 1.0, without the package.

`convert.py OLD NEW`: the layout is that of FORMAT.md; what 1.0 did not keep,
randomisations above all, is not there."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import h5py
import numpy as np
from made_kinds import Measured
from made_layout import Layout, seal

EXACT = {"incident", "balance_error", "paths", "capped", "lai"}
SOURCES = ("beam", "sky", "scattered")
SIDES = ("adaxial", "abaxial")
ELITE = 3
PER_AREA = "absorbed_par_per_leaf_area"
SESSION = ("started", "host", "command", "ranks")
TRAIT = re.compile(r"leaf(\d+)_(\w+)")


def convert(old: Path, new: Path) -> Path:
    """Of a closed file; `new` is written over. Returns it."""
    with h5py.File(old) as source, h5py.File(new, "w") as target:
        _Conversion(source, target).run()
    return new


def _place(column: str) -> tuple[str, str | None, object]:
    """Quantity, axis and label of a column of 1.0."""
    word = column.removeprefix("absorbed_")
    if match := re.fullmatch(r"leaf(\d+)", word):
        return "absorbed_by_leaf", "leaf", int(match[1])
    if match := re.fullmatch(r"layer_(\d+)_(\d+)cm", word):
        middle = (int(match[1]) + int(match[2])) / 200
        return "absorbed_by_layer", "layer", middle
    if match := re.fullmatch(r"hour_(\d+)_(\d+)", word):
        return "absorbed_by_hour", "hour", int(match[1]) + int(match[2]) / 60
    if word in SOURCES:
        return "absorbed_by_source", "light_source", word
    if word in SIDES:
        return "absorbed_by_side", "leaf_side", word
    return column, None, None


class _Conversion:
    def __init__(self, source: h5py.File, target: h5py.File) -> None:
        self.source, self.target = source, target
        self.size = int(source.attrs["population"])
        texts = source["diagnostics/name"].asstr()[:]
        units = source["diagnostics/unit"].asstr()[:]
        self.columns: dict[str, list[int]] = {}
        self.labels: dict[str, list] = {}
        self.quantities: dict[str, Measured] = {}
        for i, (column, unit) in enumerate(zip(texts, units)):
            if column == "violation":
                continue
            name, axis, label = _place(column)
            self.columns.setdefault(name, []).append(i)
            self.quantities[name] = Measured(unit, axis, name in EXACT)
            if axis:
                self.labels.setdefault(axis, []).append(label)
        if "leaf" in self.labels:
            leaves = np.array(self.labels["leaf"], "i4")
            self.labels["leaf"] = leaves
        names = source["objectives/name"].asstr()[:]
        units = source["objectives/unit"].asstr()[:]
        self.objectives = [(n, u, "maximise") for n, u in zip(names, units)]
        for name, unit, _ in self.objectives:
            self.quantities[name] = Measured(unit)
        self.per_area = names[0] == "absorbed_par" and "lai" in self.columns
        if self.per_area:
            self.quantities[PER_AREA] = Measured(units[0])

    def run(self) -> None:
        traits = self.source["traits"]
        renamed = [
            name.replace("_inclination", "_insertion_angle")
            for name in traits["name"].asstr()[:]
        ]
        words = [TRAIT.fullmatch(name) for name in renamed]
        genes = {
            "gene": renamed,
            "trait": [word[2] for word in words],
            "leaf": np.array([int(word[1]) for word in words], "i4"),
            "unit": list(traits["unit"].asstr()[:]),
            **{
                n: traits[n][:]
                for n in ("lower", "upper", "is_circular", "is_free")
            },
        }
        counts = (
            len(self.source[g]["status"]) for g in ("evaluations", "final")
        )
        layout = Layout(
            self.target,
            *counts,
            generations=len(self.source["generations/committed"]),
            genes=genes,
            objectives=self.objectives,
            labels=self.labels,
            quantities=self.quantities,
        )
        known = {
            name: value.decode() if isinstance(value, bytes) else value
            for name, value in self.source.attrs.items()
        }
        known |= {"format_version": "2.0"}
        known["rows"] = np.int32(len(self.source["evaluations/status"]))
        forms = ("source", "resolved")
        campaign = self.source["campaign"]
        layout.create(known, {f: campaign[f].asstr()[()] for f in forms})
        for group in ("evaluations", "final"):
            self._rows(group)
        self._generations()
        self._state()
        seal(self.target)

    def _rows(self, group: str) -> None:
        old, new = self.source[group], self.target[group]
        same = ("status", "genome", "origin", "attempt", "seconds", "worker")
        ends = ("", "_standard_error")
        for name in (*same, "message", *(f"objectives{end}" for end in ends)):
            new[name][:] = old[name][:]
        fitness = old["fitness"][:]
        violation = np.where(fitness < 0, -fitness, 0.0)
        violation[~(old["status"][:] == 2)] = np.nan
        new["violation"][:] = violation
        first = np.arange(len(fitness)) // self.size * self.size - self.size
        if group == "final":
            committed = int(self.source["generations/committed"][:].sum())
            first[:] = (committed - 1) * self.size
        parents, origin = old["parents"][:], old["origin"][:][:, None]
        # 1.0 has 0 where the first generation has no parents.
        is_none = (parents < 0) | (origin < ELITE)
        shifted = np.where(is_none, -1, parents + first[:, None])
        new["parents"][:] = shifted
        for end in ends:
            table = old[f"diagnostics{end}"][:]
            for name, at in self.columns.items():
                if name + end in new:
                    has_axis = self.quantities[name].axis
                    new[name + end][:] = (
                        table[:, at] if has_axis else table[:, at[0]]
                    )
            for i, (name, _, _) in enumerate(self.objectives):
                new[name + end][:] = old[f"objectives{end}"][:, i]
            if self.per_area:
                values = old[f"objectives{end}"][:, 0] / new["lai"][:]
                new[PER_AREA + end][:] = values

    def _generations(self) -> None:
        old, new = self.source["generations"], self.target["generations"]
        for name in old:
            if name in new and name != "generation":
                new[name][:] = old[name][:]
        committed = old["committed"][:]
        first = np.arange(len(committed)) * self.size
        new["first_row"][:] = first
        new["count"][:] = self.size
        best = np.where(committed, first + old["best_slot"][:], -1)
        new["best_row"][:] = best
        values = self.source["evaluations/objectives"][:, 0][best]
        new["best"][:] = np.where(committed, values, np.nan)

    def _state(self) -> None:
        for name in ("finished", "reason", "wall_time"):
            value = self.source["state"][name][()]
            self.target["state"][name][()] = value
        sessions, texts = (
            self.source["sessions"][:],
            self.source["messages"][:],
        )
        for name in SESSION:
            new = self.target["sessions"][name]
            new[:] = sessions[name][: len(new)]
        new = self.target["messages/text"]
        new[:] = texts[: len(new)]


if __name__ == "__main__":
    convert(Path(sys.argv[1]), Path(sys.argv[2]))
