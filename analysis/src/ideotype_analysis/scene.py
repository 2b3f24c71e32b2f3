"""What the 3D view shows: baseline and best plants, and what their leaves
absorb."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import to_rgb

from .case import Case
from .file import HistoryError
from .geometry import Mesh, export_plant
from .history import History
from .quantity import Profile
from .rows import Evaluation, Origin
from .stand import places, row_direction
from .style import organ_color, unit_label

_DECIMALS = 4
"""Of a coordinate: a tenth of a millimetre."""

_NEIGHBOURS = 3
"""Shown before and behind a plant in its row."""


@dataclass(frozen=True)
class Plants:
    """The two meshes of a case."""

    baseline: Mesh
    best: Mesh


def export_plants(case: Case, program: Path | None) -> Plants:
    """Raises HistoryError if the program is missing or fails."""
    if program is None:
        raise HistoryError(
            "the shape of plants comes from the program `ideotype`, which was "
            "not found; name it with --ideotype PATH"
        )
    case.need_pairs()
    history = case.best_history
    return Plants(
        export_plant(program, history.path, _baseline_row(history)),
        export_plant(program, history.path, ["--best"]),
    )


def _baseline_row(history: History) -> list[str]:
    first = history.evaluations(0)
    found = np.flatnonzero(first.origin == Origin.BASELINE)
    if not len(found):
        raise HistoryError(f"{history.path}: generation 0 has no baseline")
    slot = int(first.slot[found[0]])
    return ["--generation", "0", "--slot", str(slot)]


def scene_of(shown: Sequence[tuple[Case, Plants]]) -> str:
    """JSON for viewer.js, safe inside a script element."""
    cases = [_case(case, plants) for case, plants in shown]
    return json.dumps({"cases": cases}, separators=(",", ":")).replace(
        "<", "\\u003c"
    )


def _case(case: Case, plants: Plants) -> dict[str, Any]:
    pairs = ((case.baseline, plants.baseline), (case.best, plants.best))
    titles = [
        f"{name}: {plant.objective.number().replace('+-', '±')} "
        f"{unit_label(plant.objective.unit)}"
        for name, (plant, _) in zip(("baseline", "best"), pairs)
    ]
    return {
        "name": case.name,
        "plants": [
            {"title": title, **_mesh(mesh)}
            for title, (_, mesh) in zip(titles, pairs)
        ],
        "quantities": _quantities(case, pairs),
        "row_direction": row_direction(case),
        "neighbours": [
            place.tolist() for place in places(case, _NEIGHBOURS)[1:]
        ],
    }


def _mesh(mesh: Mesh) -> dict[str, Any]:
    names = list(dict.fromkeys(mesh.groups))
    return {
        "vertices": np.round(mesh.vertices, _DECIMALS).tolist(),
        "faces": [list(face) for face in mesh.faces],
        "groups": names,
        "group": [names.index(group) for group in mesh.groups],
        "colors": [_rgb(name) for name in names],
    }


def _rgb(group: str) -> list[int]:
    """Of a group whose light is not shown."""
    return [round(255 * part) for part in to_rgb(organ_color(group))]


def _quantities(
    case: Case, pairs: Sequence[tuple[Evaluation, Mesh]]
) -> list[dict[str, Any]]:
    """Absorbed PAR of each group of each plant; None for a group that is no
    leaf."""
    profiles = [_leaves(plant) for plant, _ in pairs]
    meshes = [mesh for _, mesh in pairs]
    by_leaf = [*map(_by_group, profiles, meshes)]
    unit = profiles[0].unit
    quantities = [
        {
            "label": f"by each leaf [{unit_label(unit)} of ground]",
            "values": by_leaf,
        }
    ]
    has = case.attributes
    if "row_spacing" in has and "plant_spacing" in has:
        ground = float(has["row_spacing"]) * float(has["plant_spacing"])
        per_area = [
            [
                None if value is None else value * ground / mesh.area(group)
                for value, group in zip(values, dict.fromkeys(mesh.groups))
            ]
            for values, mesh in zip(by_leaf, meshes)
        ]
        quantities.append(
            {
                "label": f"per leaf area [{unit_label(unit)} of leaf]",
                "values": per_area,
            }
        )
    return quantities


def _leaves(plant: Evaluation) -> Profile:
    """Empty where the history does not tell leaves apart."""
    try:
        return plant.profile("absorbed_by_leaf")
    except HistoryError:
        none = np.empty(0)
        return Profile(none, "1", none, none)


def _by_group(profile: Profile, mesh: Mesh) -> list[float | None]:
    known = {
        f"leaf{leaf:02}": float(value)
        for leaf, value in zip(profile.labels, profile.values)
    }
    return [known.get(group) for group in dict.fromkeys(mesh.groups)]
