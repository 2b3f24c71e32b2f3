# SPDX-License-Identifier: Apache-2.0
"""The data of the 3D view: baseline and best plants, or all members of a
front, and the light that their leaves absorb."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.colors import to_rgb
from numpy.typing import NDArray

from ..common.labels import unit_label
from ..figures.style import organ_color, short
from ..history.case import Case
from ..history.history import History
from ..history.layout import leaf_light, places, row_direction
from ..history.rows import Evaluation
from ..mesh.geometry import Mesh
from .front_scene import make_front_scene
from .own_plants import OwnPlant, evaluate_own_plants

_LARGEST = 2**15 - 1
"""The largest coordinate in the page: a step is a tenth of a millimetre in a
plant of three metres."""

_FINALISTS = 3
"""The number of finalists of each search that are shown."""

_NEIGHBOURS = 3
"""The number of neighbours shown before and behind a plant in its row."""


@dataclass(frozen=True)
class Plants:
    """The meshes of a case."""

    baseline: Mesh
    best: Mesh
    members: tuple[Mesh, ...] = ()
    """The members of the fronts of all seeds."""
    others: tuple[tuple[str, Evaluation | OwnPlant, Mesh], ...] = ()
    """Other finalists of all seeds and the user's own plants, with names."""


def select_best(
    cases: Sequence[Case], shapes: Sequence[Plants | None]
) -> tuple[Case, Plants | None]:
    """Returns the evaluated case with the largest gain, and its plants.
    `shapes` are the plants of each case."""
    known = [pair for pair in zip(cases, shapes, strict=True) if pair[0].pairs]
    return max(known, key=lambda pair: pair[0].relative_gain().mean)


def build_plants(case: Case, plant_files: Sequence[Path] = ()) -> Plants:
    """Builds the plants of a case, and the user's own plants from their files.
    Raises HistoryError if nothing is evaluated
    yet, Error if there is no compiled module, which knows the shapes of
    plants, or it cannot use a history."""
    pair = [case.baseline.row.genome[0], case.best.row.genome[0]]
    baseline, best = _shapes(case.best_history, pair)
    members = (
        mesh
        for history, front in case.fronts
        for mesh in _shapes(history, front.members.genome)
    )
    mine = (
        (each.name, each, each.mesh)
        for each in evaluate_own_plants(case, plant_files)
    )
    return Plants(baseline, best, tuple(members), (*_finalists(case), *mine))


def _finalists(case: Case) -> Iterator[tuple[str, Evaluation, Mesh]]:
    """Returns the finalists of all searches except the best plant of the case
    and the baseline, the best finalist of each search first; a case with a
    front returns none."""
    best = case.best.row.genome[0]
    for search, history in enumerate(case.histories, start=1):
        if case.fronts or not case.is_final:
            return
        done = history.finalists().done
        ranked = done.take(done.slot > 0).top(_FINALISTS)
        shapes = _shapes(history, ranked.genome)
        for place, mesh in enumerate(shapes):
            if not np.array_equal(ranked.genome[place], best):
                name = f"search {search}, finalist {place + 1}"
                yield name, ranked.one(place, True), mesh


def _shapes(
    history: History, genomes: Iterable[NDArray[np.float64]]
) -> list[Mesh]:
    """Returns the shapes of genomes, which do not depend on the instruction
    set."""
    from ..stand.stand import Stand

    stand = Stand.from_history(history.path, same_isa=False)
    return [stand.mesh(genome) for genome in genomes]


def make_scene(shown: Sequence[tuple[Case, Plants | None]]) -> str:
    """Returns JSON for viewer.js, safe inside a script element. A case without
    plants shows its front alone."""
    shapes: list[dict[str, Any]] = []
    cases = [_case(case, plants, shapes) for case, plants in shown]
    scene = {"shapes": shapes, "cases": cases}
    return json.dumps(scene, separators=(",", ":")).replace("<", "\\u003c")


def _case(
    case: Case, plants: Plants | None, shapes: list[dict[str, Any]]
) -> dict[str, Any]:
    front = make_front_scene(case) if case.fronts else None
    scene: dict[str, Any] = {"name": case.name, "front": front, "plants": []}
    if plants is None:
        return scene
    pairs: list[tuple[Evaluation | OwnPlant, Mesh]] = [
        (case.baseline, plants.baseline)
    ]
    if front:
        # The page shows the numbers of light in tables.
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
            _title(name, plant)
            for name, (plant, _) in zip(("baseline", "best"), pairs)
        ]
    pairs += [(plant, mesh) for _, plant, mesh in plants.others]
    titles += [_title(name, plant) for name, plant, _ in plants.others]
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


def _title(name: str, plant: Evaluation | OwnPlant) -> str:
    of = plant.objective
    return f"{name}: {of.interval_text()} {unit_label(of.unit)}"


def _mesh(mesh: Mesh, shapes: list[dict[str, Any]]) -> dict[str, Any]:
    """Returns a mesh for the page; parts that several plants share are stored
    once in `shapes`."""
    shape = describe_shape(mesh)
    if shape not in shapes:
        shapes.append(shape)
    return {"shape": shapes.index(shape), **pack_vertices(mesh.vertices)}


def describe_shape(mesh: Mesh) -> dict[str, Any]:
    """Returns a mesh for the page without its vertices: faces, the names of
    groups, the group of each face, and the colours of groups without a shown
    quantity."""
    names = list(dict.fromkeys(mesh.groups))
    return {
        "faces": mesh.faces,
        "groups": names,
        "group": [names.index(group) for group in mesh.groups],
        "colors": [_rgb(name) for name in names],
    }


def pack_vertices(vertices: NDArray[np.float64]) -> dict[str, Any]:
    """Returns coordinates as whole steps [m] of 16 bits, for unpack() of the
    page."""
    step = float(np.abs(vertices).max()) / _LARGEST
    points = np.round(vertices / step).astype("<i2").tobytes()
    return {"step": step, "points": base64.b64encode(points).decode("ascii")}


def _rgb(group: str) -> list[int]:
    """Returns the colour of a group without a shown quantity."""
    return [round(255 * part) for part in to_rgb(organ_color(group))]


def _quantities(
    case: Case, pairs: Sequence[tuple[Evaluation | OwnPlant, Mesh]]
) -> list[dict[str, Any]]:
    """Returns absorbed PAR of each group of each plant; None for a group that
    is no leaf."""
    light = case.baseline.row.quantities.get("absorbed_by_leaf")
    unit = unit_label(light.unit if light else "1")
    areas: dict[str, float | None] = {f"of each leaf [{unit} of ground]": None}
    has = case.attributes
    if {"row_spacing", "plant_spacing"} <= {*has} and not case.is_over(
        "spacing"
    ):
        ground = float(has["row_spacing"]) * float(has["plant_spacing"])
        areas[f"per leaf area [{unit} of leaf]"] = ground
    return [
        {
            "label": label,
            "values": [
                [
                    None if value is None else short(value)
                    for value in leaf_light(plant, mesh, ground).values()
                ]
                for plant, mesh in pairs
            ],
        }
        for label, ground in areas.items()
    ]
