# SPDX-License-Identifier: Apache-2.0
"""Cross-evaluations, in which every plant is evaluated in the light of every
case."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pandas
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..history.case import Case
from ..history.estimate import Estimate, relative_gain, with_interval
from ..history.file import HistoryError
from ..history.interval import Interval, interval, meaning, over_searches
from . import style


@dataclass(frozen=True)
class Cross:
    """A table of plants and cases. Means and standard errors are [plants,
    cases], in the unit of the objective; NaN for a plant that was not
    evaluated in a case."""

    plants: tuple[str, ...]
    cases: tuple[str, ...]
    mean: NDArray[np.float64]
    standard_error: NDArray[np.float64]

    def estimate(self, plant: str, case: str) -> Estimate | None:
        """Returns the estimate of a plant in a case, None if the plant was not
        evaluated in the case."""
        if plant not in self.plants or case not in self.cases:
            return None
        at = self.plants.index(plant), self.cases.index(case)
        if np.isnan(self.mean[at]):
            return None
        return Estimate(float(self.mean[at]), float(self.standard_error[at]))

    def seeds_together(self) -> list[tuple[str, list[Interval | None]]]:
        """Returns plants by name, "ames_all" for the best of ames_all_r1,
        ames_all_r2 and so on, with the means of the seeds in each case; None
        if no seed was evaluated in a case."""
        members: dict[str, list[str]] = {}
        for plant in self.plants:
            name = re.sub(r"[_-]r\d+$", "", plant)
            members.setdefault(name, []).append(plant)
        table = []
        for name, plants in members.items():
            row: list[Interval | None] = []
            for case in self.cases:
                known = [self.estimate(plant, case) for plant in plants]
                found = [figure for figure in known if figure]
                row.append(interval(found) if found else None)
            # A plant with a single seed keeps its full name, which contains
            # the seed.
            table.append((name if len(plants) > 1 else plants[0], row))
        return table

    def intervals(self) -> str:
        """Explains the intervals of seeds_together()."""
        table = self.seeds_together()
        return meaning(x.seeds for _, row in table for x in row if x)

    def relative_gain(self, case: Case, plant: str) -> Interval | None:
        """Returns the gain [%] of the best plants of a case's seeds over a
        plant in the same light; None if the plant was not evaluated in this
        case."""
        known = [
            self.estimate(plant, name) for name in (case.name, case.light)
        ]
        if (other := known[0] or known[1]) is None:
            return None
        return over_searches(
            [relative_gain(pair.best.objective, other) for pair in case.pairs],
            [pair.gain for pair in case.pairs],
        )


def read_cross(path: str | Path) -> Cross:
    """Reads JSON {"plants": [names], "cases": [names], "mean": [[...]],
    "standard_error": [[...]]}, a row per plant; or CSV with the columns plant,
    case, mean, standard_error. `ideotype compare` writes both formats; the
    first quantity of a file counts.

    Raises FileNotFoundError, or HistoryError if the file is no
    cross-evaluation."""
    path = Path(path)
    try:
        cross = _from_csv(path) if path.suffix == ".csv" else _from_json(path)
    except (KeyError, ValueError, TypeError) as error:
        raise HistoryError(
            f"{path}: this is no cross-evaluation ({error!r}); give JSON with "
            "plants, cases, mean and standard_error, or CSV with the columns "
            "plant, case, mean and standard_error"
        ) from error
    if not cross.plants or not cross.cases:
        raise HistoryError(
            f"{path}: this file has no plant or no case; write it again with "
            "ideotype compare"
        )
    return cross


def _from_json(path: Path) -> Cross:
    data = json.loads(path.read_text(encoding="utf-8"))
    plants, cases = tuple(data["plants"]), tuple(data["cases"])
    mean, error = (
        np.array(data[name], float).reshape(len(plants), len(cases))
        for name in ("mean", "standard_error")
    )
    return Cross(plants, cases, mean, error)


def _from_csv(path: Path) -> Cross:
    table = pandas.read_csv(
        path, dtype={"plant": str, "case": str}, float_precision="round_trip"
    )
    if "quantity" in table:
        table = table[table["quantity"].isin(table["quantity"][:1])]
    plants, cases = (tuple(table[x].unique()) for x in ("plant", "case"))
    mean, error = (
        table.pivot(index="plant", columns="case", values=name)
        .reindex(index=plants, columns=cases)
        .to_numpy(float)
        for name in ("mean", "standard_error")
    )
    return Cross(plants, cases, mean, error)


def draw_cross(cross: Cross) -> Figure:
    """Draws each plant in each case, with the seeds of a case put together, in
    % of the best plant of the case; half of the interval stands below each
    number."""
    table = cross.seeds_together()
    mean, error = (
        np.array(
            [
                [getattr(x, attribute) if x else np.nan for x in row]
                for _, row in table
            ]
        )
        for attribute in ("mean", "below")
    )
    best = np.nanmax(mean, axis=0)
    share, error = 100 * mean / best, 100 * error / best
    width = max(style.WIDTH, 2.0 + 0.62 * len(cross.cases))
    figure = style.new_figure(width, 2.8 + 0.5 * len(table))
    axes = figure.add_subplot()
    image = axes.imshow(share, cmap="viridis", aspect="auto")
    axes.grid(visible=False)
    middle = (np.nanmin(share) + np.nanmax(share)) / 2
    for (i, j), value in np.ndenumerate(share):
        if np.isnan(value):
            continue
        axes.text(
            j, i, _cell(float(value), float(error[i, j])),
            ha="center", va="center", fontsize=8,
            color="white" if value < middle else "black",
        )  # fmt: skip
    axes.set_xticks(
        range(len(cross.cases)), cross.cases, rotation=30, ha="right"
    )
    axes.set_yticks(range(len(table)), [name for name, _ in table])
    axes.set_xlabel("in the light of")
    axes.set_ylabel("plant")
    figure.colorbar(
        image,
        location="bottom",
        aspect=40,
        label="% of the best plant in this light",
    )
    worst = np.nanmin(share, axis=1)
    robust = int(np.nanargmax(worst))
    style.set_answer(
        figure,
        f"The most robust plant is {table[robust][0]}: it reaches at least "
        f"{worst[robust]:.1f} % of the best plant in the light of each case.",
    )
    return figure


def _cell(value: float, error: float) -> str:
    return with_interval(value, error, error).replace(" ± ", "\n±")
