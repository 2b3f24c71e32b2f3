# SPDX-License-Identifier: Apache-2.0
"""What the 3D view shows: baseline and best plants, or all members of a front,
and what their leaves absorb."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from .case import Case
from .file import HistoryError
from .geometry import Mesh, export_plant
from .front_scene import front_scene
from .history import History
from .quantity import Profile
from .rows import Evaluation, Origin, Rows
from .stand import places, row_direction
from .style import organ_color, short, unit_label

_LARGEST = 2**15 - 1
"""Of a coordinate in the page: a step is a tenth of a millimetre in a plant
of three metres."""

_NEIGHBOURS = 3
"""Shown before and behind a plant in its row."""


@dataclass(frozen=True)
class Plants:
    """The meshes of a case."""

    baseline: Mesh
    best: Mesh
    members: tuple[Mesh, ...] = ()
    """Of the fronts of all seeds."""


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
        tuple(
            export_plant(program, history.path, row)
            for history, front in case.fronts
            for row in _rows_of(history, front.members)
        ),
    )


def _baseline_row(history: History) -> list[str]:
    first = history.evaluations(0)
    found = np.flatnonzero(first.origin == Origin.BASELINE)
    if not len(found):
        raise HistoryError(f"{history.path}: generation 0 has no baseline")
    return _row(first, int(found[0]))


def _rows_of(history: History, plants: Rows) -> Iterator[list[str]]:
    """Where plants stand in the run, finalists too."""
    known = history.evaluations()
    for genome in plants.genome:
        found = np.flatnonzero((known.genome == genome).all(axis=1))
        if not len(found):
            raise HistoryError(
                f"{history.path}: a finalist is in no generation"
            )
        yield _row(known, int(found[-1]))


def _row(rows: Rows, index: int) -> list[str]:
    place = rows.generation[index], rows.slot[index]
    return ["--generation", str(place[0]), "--slot", str(place[1])]


def scene_of(shown: Sequence[tuple[Case, Plants | None]]) -> str:
    """JSON for viewer.js, safe inside a script element. Of a case without
    plants only the front is shown."""
    shapes: list[dict[str, Any]] = []
    cases = [_case(case, plants, shapes) for case, plants in shown]
    scene = {"shapes": shapes, "cases": cases}
    return json.dumps(scene, separators=(",", ":")).replace("<", "\\u003c")


def _case(
    case: Case, plants: Plants | None, shapes: list[dict[str, Any]]
) -> dict[str, Any]:
    front = front_scene(case) if case.fronts else None
    scene: dict[str, Any] = {"name": case.name, "front": front, "plants": []}
    if plants is None:
        return scene
    pairs = [(case.baseline, plants.baseline)]
    if front:
        # the numbers are in the tables
        titles = [
            "baseline",
            *(member["title"] for member in front["members"]),
        ]
        members = [
            f.one(i) for _, f in case.fronts for i in range(len(f.members))
        ]
        pairs += zip(members, plants.members)
    else:
        pairs.append((case.best, plants.best))
        titles = [
            f"{name}: {plant.objective.number().replace('+-', '±')} "
            f"{unit_label(plant.objective.unit)}"
            for name, (plant, _) in zip(("baseline", "best"), pairs)
        ]
    return scene | {
        "plants": [
            {"title": title, **_mesh(mesh, shapes)}
            for title, (_, mesh) in zip(titles, pairs)
        ],
        "quantities": _quantities(case, pairs),
        "row_direction": row_direction(case),
        "neighbours": [
            place.tolist() for place in places(case, _NEIGHBOURS)[1:]
        ],
    }


def _mesh(mesh: Mesh, shapes: list[dict[str, Any]]) -> dict[str, Any]:
    """What plants share is kept once, in `shapes`."""
    names = list(dict.fromkeys(mesh.groups))
    shape = {
        "faces": mesh.faces,
        "groups": names,
        "group": [names.index(group) for group in mesh.groups],
        "colors": [_rgb(name) for name in names],
    }
    if shape not in shapes:
        shapes.append(shape)
    return {"shape": shapes.index(shape), **packed(mesh.vertices)}


def packed(vertices: NDArray[np.float64]) -> dict[str, Any]:
    """Coordinates as whole steps [m] of 16 bits, for unpack() of the page."""
    step = float(np.abs(vertices).max()) / _LARGEST
    points = np.round(vertices / step).astype("<i2").tobytes()
    return {"step": step, "points": base64.b64encode(points).decode("ascii")}


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
    if {"row_spacing", "plant_spacing"} <= {*has} and not case.is_over(
        "spacing"
    ):
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
        f"leaf{leaf:02}": short(value)
        for leaf, value in zip(profile.labels, profile.values)
    }
    return [known.get(group) for group in dict.fromkeys(mesh.groups)]
