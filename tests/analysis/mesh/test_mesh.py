# SPDX-License-Identifier: Apache-2.0
"""Meshes are evaluated from Python."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh
from real_program import CAMPAIGNS, executable

import ideotype

SQUARE = np.array([[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
BLACK = {"leaf": (0.0, 0.0), "soil_albedo": 0.0}


def half_cover() -> ideotype.Canopy:
    """Returns a black square of 1 m2 above 2 m2 of ground."""
    return ideotype.mesh(SQUARE, [[0, 1, 2, 3]])


def test_a_square_absorbs_the_light_of_its_shadow() -> None:
    light = half_cover().evaluate(
        period=(2, 1), sun=(90, 0), **BLACK, paths=4096, by_face=True
    )
    assert light.incident == 1
    assert light.leaves.item() == pytest.approx(0.5, abs=1e-3)
    assert light.soil.item() == pytest.approx(0.5, abs=1e-3)
    assert light.absorbed.sel(group="leaf") == light.leaves
    assert light.absorbed_by_face.item() == pytest.approx(1, abs=2e-3)
    assert light.lai.item() == pytest.approx(0.5)
    assert light.attrs["balance_error"] < 1e-12
    beam = light.leaves_by_origin.sel(origin="beam")
    assert beam.item() == pytest.approx(light.leaves.item())
    assert light.leaves_by_side.sel(side="lower").item() == 0


def test_a_polygon_is_one_face() -> None:
    corner = np.array([[0.5, 0.5, 1], [0.5, 1, 1]])
    vertices = np.vstack([SQUARE[:2], [[1, 0.5, 1]], corner, [[0, 1, 1]]])
    shape_of_an_l = ideotype.mesh(vertices, [range(6)])
    light = shape_of_an_l.evaluate(
        period=(2, 1), sun=(90, 0), **BLACK, paths=4096, by_face=True
    )
    assert light.lai.item() == pytest.approx(0.75 / 2)
    assert light.absorbed_by_face.values == pytest.approx([1], abs=5e-3)


def test_triangles_and_quadrilaterals_may_be_mixed() -> None:
    two = ideotype.mesh(SQUARE, [[0, 1, 2], [0, 2, 3]], groups=["a", "stalk"])
    light = two.evaluate(period=(2, 1), sun=(90, 0), **BLACK, stalk=(0, 0))
    assert list(light.group.values) == ["a", "stalk"]
    assert light.leaves.item() == pytest.approx(0.25, abs=1e-3)
    assert light.stalks.item() == pytest.approx(0.25, abs=1e-3)


def test_a_mesh_from_trimesh_is_accepted() -> None:
    box = trimesh.creation.box((1, 1, 1))
    box.apply_translation((0, 0, 1))
    light = ideotype.mesh(box.vertices, box.faces).evaluate(
        period=(2, 2), sun=(90, 0), **BLACK, by_face=True
    )
    assert light.leaves.item() == pytest.approx(0.25, abs=1e-3)
    assert light.sizes["face"] == len(box.faces)
    top = box.face_normals[:, 2] > 0.5
    lit = light.absorbed_by_face.values > 0.5
    np.testing.assert_array_equal(lit, top)


def test_many_faces_take_little_time() -> None:
    n = 300
    side = np.linspace(0, 1, n + 1)
    x, y = np.meshgrid(side, side)
    vertices = np.column_stack([x.ravel(), y.ravel(), np.ones(x.size)])
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    faces = corner[:, None] + [0, 1, n + 2, n + 1]
    light = ideotype.mesh(vertices, faces).evaluate(
        period=(2, 1), sun=(90, 0), **BLACK, paths=4096
    )
    assert light.leaves.item() == pytest.approx(0.5, abs=1e-3)


def test_a_mesh_agrees_bitwise_with_the_command_line(tmp_path: Path) -> None:
    stand = ideotype.Stand.from_campaign(CAMPAIGNS / "ames_quick.toml")
    plant = stand.mesh(stand.baseline)
    # Noise makes the quadrilaterals non-planar.
    noise = np.random.default_rng(1).uniform(0, 5e-4, plant.vertices.shape)
    vertices = plant.vertices + noise
    path = tmp_path / "plant.obj"
    lines, group = [], ""
    lines += [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    for face, name in zip(plant.faces, plant.groups):
        if name != group:
            lines.append(f"g {name}")
        group = name
        lines.append("f " + " ".join(str(i + 1) for i in face))
    path.write_text("\n".join(lines) + "\n")
    said = subprocess.run(
        [
            *(executable(), "light", path, "--json"),
            *("--field", "2", "2", ".762", ".15", "--jitter", "10"),
            *("--site", "42", "-93.6", "-5", "--date", "2021-07-01"),
            *("--paths", "2048"),
        ],
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    report = json.loads(said)
    light = ideotype.mesh(vertices, plant.faces, groups=plant.groups).evaluate(
        field=(2, 2, 0.762, 0.15),
        jitter=10,
        site=(42, -93.6, -5),
        day="2021-07-01",
        paths=2048,
    )
    assert light.incident.item() == 1e-6 * report["incident"]
    for name, value in report["quantities"].items():
        assert light[name].item() == pytest.approx(value["mean"], rel=1e-15)
    for group, value in report["groups"].items():
        part = light.absorbed.sel(group=group) / light.incident
        assert part.item() == pytest.approx(value["mean"], rel=1e-14)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"sun": (90, 0)}, "period X Y is missing"),
        ({"period": (1, 1)}, "sun"),
        ({"period": (1, 1), "sky": "grey"}, 'sky is "grey"'),
        ({"period": (1, 1), "sun": (95, 0)}, "sun: elevation is 95 deg"),
        ({"period": (1, 1), "sun": (60,)}, "sun takes 2 values: elevation"),
        (
            {"period": (1, 1), "sun": (60, 0), "leaf": (0.7, 0.4)},
            r"leaf\[0\] and leaf\[1\] exceed 1",
        ),
        (
            {"period": (1, 1), "site": (42, 0, 0), "day": "7.8.2025"},
            r"day is 7.8.2025 \(not a date\)",
        ),
        (
            {"period": (1, 1), "site": (42, 0, 0)},
            "site and day belong together",
        ),
        ({"isolated": True, "sun": (90, 0)}, "needs ground_area"),
    ],
)
def test_invalid_options_are_errors(
    options: dict[str, object], words: str
) -> None:
    with pytest.raises(ideotype.Error, match=words) as caught:
        half_cover().evaluate(**options)  # type: ignore[arg-type]
    assert "--" not in str(caught.value)


@pytest.mark.parametrize(
    ("vertices", "faces", "groups", "words"),
    [
        (SQUARE[:, :2], [[0, 1, 2]], None, r"give \[vertices, 3\]"),
        (SQUARE, [[0, 1, 4]], None, r"faces\[0\] has the corner 4"),
        (SQUARE, [[0, 1, -1]], None, r"faces\[0\] has the corner -1"),
        (SQUARE, [[0, 1]], None, r"faces\[0\] has 2 corners"),
        (SQUARE, [], None, "faces is empty"),
        (SQUARE * np.nan, [[0, 1, 2]], None, r"vertices\[0\]"),
        (SQUARE, [[0, 1, 2]], ["a", "b"], "2 names for 1 faces"),
    ],
)
def test_invalid_meshes_are_errors(
    vertices: np.ndarray, faces: list, groups: list | None, words: str
) -> None:
    with pytest.raises(ideotype.Error, match=words):
        ideotype.mesh(vertices, faces, groups=groups)


def test_a_scene_file_defines_components_and_bands(tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(
        "soil_albedo = { par = 0.1, nir = 0.3 }\n"
        '[[material]]\ngroups = ""\npar = [0.1, 0.1]\nnir = [0.4, 0.4]\n'
        '[[component]]\nname = "leaf"\n'
        "photosynthesis = { amax = 40 }\n"
    )
    canopy = ideotype.mesh(SQUARE, [[0, 1, 2, 3]], groups=["leaf01"])
    light = {
        "period": (1, 1),
        "sun": (60, 180),
        "beam_ppfd": 1000,
        "scene": scene,
    }
    evaluated = canopy.evaluate(**light)
    assert evaluated.sizes == {"band": 2, "component": 1, "group": 1}
    absorbed = evaluated.absorbed_by_component.sel(component="leaf")
    closed = absorbed + evaluated.soil + evaluated.reflected
    assert np.allclose(closed, evaluated.incident)
    assert absorbed.sel(band="par") > 3 * absorbed.sel(band="nir") / 1.2
    assert evaluated.gross_assimilation.units == "umol m-2 s-1"
    assert 20 < evaluated.gross_assimilation.item() < 40
    assert evaluated.net_assimilation < evaluated.gross_assimilation
    with pytest.raises(ideotype.Error, match="scene excludes leaf"):
        canopy.evaluate(**light, leaf=(0.1, 0.1))
