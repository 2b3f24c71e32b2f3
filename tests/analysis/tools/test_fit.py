# SPDX-License-Identifier: Apache-2.0
"""Crop files are fitted to digitised plants: known plants are written in every
readable format, and the fit must recover their leaves."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from real_program import CAMPAIGNS
from scipy.interpolate import make_lsq_spline
from scipy.spatial.transform import Rotation

from ideotype import Mesh
from ideotype.tools import fit

MAIZE = CAMPAIGNS / "crops" / "maize.toml"
IOWA = CAMPAIGNS / "plants" / "iowa_T8.toml"
DEGREES = (2, 3)
SIZES = (3, 6)


def fitted(
    source: Path, capsys: pytest.CaptureFixture[str], *words: str
) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Returns the leaves of the crop file fitted to a source, and the printed
    table of deviations."""
    to = source.parent / f"{source.stem}_fitted.toml"
    to.unlink(missing_ok=True)
    arguments = [str(source), "--crop", str(MAIZE), "--to", str(to), "--json"]
    assert fit.main([*arguments, *words]) == 0, capsys.readouterr().err
    table = json.loads(capsys.readouterr().out)
    return tomllib.loads(to.read_text())["leaf"], table


def refused(
    source: Path, capsys: pytest.CaptureFixture[str], *words: str
) -> str:
    to = source.parent / "refused.toml"
    arguments = [str(source), "--crop", str(MAIZE), "--to", str(to), *words]
    assert fit.main(arguments) == 3
    assert not to.exists()
    return capsys.readouterr().err


def plant(path: Path) -> tuple[list[dict[str, Any]], Mesh]:
    crop = tomllib.loads(path.read_text())
    return crop["leaf"], fit.mesh_of(crop, path.parent)


def rows(mesh: Mesh) -> Iterator[np.ndarray]:
    """Yields the rows of vertices of each leaf [rows, left middle right,
    3]."""
    for group in sorted({g for g in mesh.groups if g.startswith("leaf")}):
        faces = [f for f, g in zip(mesh.faces, mesh.groups) if g == group]
        first = min(min(face) for face in faces)
        last = max(max(face) for face in faces)
        yield mesh.vertices[first : last + 1].reshape(-1, 3, 3)


def write_obj(mesh: Mesh, path: Path, unit: float, noise: float = 0) -> None:
    """Writes a mesh in the coordinates of a scanner, rotated by 40 deg about
    the vertical."""
    turned = Rotation.from_euler("z", 40, degrees=True)
    draw = np.random.default_rng(1).normal(0, noise, mesh.vertices.shape)
    points = turned.apply(mesh.vertices + draw) / unit + [30, -8, 900]
    lines = ["v {:.8g} {:.8g} {:.8g}".format(*each) for each in points]
    last = ""
    for face, group in zip(mesh.faces, mesh.groups):
        if group != last:
            lines.append(f"g {group}")
        last = group
        lines.append("f " + " ".join(f"{i + 1}//1" for i in face))
    path.write_text("\n".join(lines) + "\n")


@pytest.mark.parametrize("source", [MAIZE, IOWA])
def test_leaves_of_a_segmented_mesh_are_fitted(
    source: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    known, mesh = plant(source)
    write_obj(mesh, tmp_path / "plant.obj", unit=0.01)
    found, table = fitted(tmp_path / "plant.obj", capsys)
    assert len(found) == len(known)
    for ours, true, row in zip(found, known, table):
        assert ours["length"] == pytest.approx(true["length"], rel=0.02)
        assert ours["width"] == pytest.approx(true["width"], rel=0.06)
        height = pytest.approx(true["insertion_height"], abs=0.004)
        assert ours["insertion_height"] == height
        turn = (ours["azimuth"] + 40 - true["azimuth"] + 180) % 360 - 180
        assert abs(abs(turn) - 80) < 1 or abs(turn) < 1
        twist = true.get("twist", 0)
        assert ours["twist"] == pytest.approx(twist, rel=0.06, abs=2)
        roll = (ours["roll"] - true.get("roll", 0) + 90) % 180 - 90
        assert abs(roll) < 4
        assert row["midrib_rms_mm"] < 7
        assert row["surface_rms_mm"] < 5
        assert row["area_m2"] == pytest.approx(
            row["measured_area_m2"], rel=0.06
        )


def test_leaves_of_a_noisy_incomplete_mesh_are_fitted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    known, mesh = plant(MAIZE)
    left = {"leaf03", "leaf09", "stalk", "sheath"}
    kept = [
        i for i, g in enumerate(mesh.groups)
        if g not in left and g.startswith("leaf")
    ]  # fmt: skip
    part = Mesh(
        mesh.vertices,
        tuple(mesh.faces[i] for i in kept),
        tuple(mesh.groups[i] for i in kept),
    )
    write_obj(part, tmp_path / "part.obj", unit=1, noise=0.002)
    leaves, _ = fitted(tmp_path / "part.obj", capsys, "--ground", "900")
    names = [x for i, x in enumerate(known, 1) if i not in {3, 9}]
    assert len(leaves) == 8
    for ours, true in zip(leaves, names):
        assert ours["length"] == pytest.approx(true["length"], rel=0.03)
        assert ours["width"] == pytest.approx(true["width"], rel=0.15)
        height = pytest.approx(true["insertion_height"], abs=0.01)
        assert ours["insertion_height"] == height


def write_nurbs(
    mesh: Mesh, path: Path, unit: float, *, u_fastest: bool, from_tip: bool,
    names: bool, noise: float = 0,
) -> None:  # fmt: skip
    """Writes leaves in the format of MaizeField3D, as the control points that
    fit their rows best."""
    u = np.array([0.0, 0, 0, 1, 1, 1])
    v = np.array([0.0, 0, 0, 0, 1 / 3, 2 / 3, 1, 1, 1, 1])
    draw = np.random.default_rng(2)
    text = ""
    for number, leaf in enumerate(rows(mesh), 1):
        at = np.linspace(0, 1, len(leaf))
        along = make_lsq_spline(at, leaf, v, 3).c
        left, middle, right = along.transpose(1, 0, 2)
        # The cross section is a parabola through the midrib.
        net = np.stack([left, 2 * middle - (left + right) / 2, right])
        net = (net + draw.normal(0, noise, net.shape)) / unit + [2, 3, 40]
        if from_tip:
            net = net[:, ::-1]
        if u_fastest:
            net = net.transpose(1, 0, 2)
        if names:
            text += f"leaf {number}\n"
        text += "3\n{} {}\n{} {}\n".format(*DEGREES, *SIZES)
        text += " ".join(map(str, u)) + "\n" + " ".join(map(str, v)) + "\n"
        for x, y, z in net.reshape(-1, 3):
            text += f"{x:.18f} {y:.18f} {z:.18f} 1.0\n"
        text += "1\n"
    path.write_text(text)


@pytest.mark.parametrize(
    ("u_fastest", "from_tip", "names", "unit"),
    [
        (True, False, False, 1),
        (False, True, True, 0.01),
        (True, True, True, 0.001),
    ],
)
def test_leaves_of_nurbs_surfaces_are_fitted(
    u_fastest: bool, from_tip: bool, names: bool, unit: float,
    tmp_path: Path, capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    known, mesh = plant(MAIZE)
    path = tmp_path / "0001.dat"
    write_nurbs(mesh, path, unit, u_fastest=u_fastest, from_tip=from_tip,
                names=names, noise=0.001)  # fmt: skip
    found, table = fitted(path, capsys, "--ground", "40")
    assert len(found) == len(known)
    for ours, true, row in zip(found, known, table):
        assert ours["length"] == pytest.approx(true["length"], rel=0.02)
        assert ours["width"] == pytest.approx(true["width"], rel=0.06)
        height = pytest.approx(true["insertion_height"], abs=0.005)
        assert ours["insertion_height"] == height
        turn = (ours["azimuth"] - true["azimuth"] + 180) % 360 - 180
        assert abs(turn) < 2
        assert row["midrib_rms_mm"] < 6
        assert row["surface_rms_mm"] < 5
        assert row["area_m2"] == pytest.approx(
            row["measured_area_m2"], rel=0.06
        )


@pytest.mark.parametrize("cloud", [True, False])
def test_leaves_distinguished_by_colour_are_fitted(
    cloud: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    known, mesh = plant(MAIZE)
    parts, colours = [], []
    for i, group in enumerate(dict.fromkeys(mesh.groups)):
        faces = [f for f, g in zip(mesh.faces, mesh.groups) if g == group]
        part = trimesh.Trimesh(
            mesh.vertices, triangulated(faces), process=False
        )
        is_leaf = group.startswith("leaf")
        colour = [10 * i + 5, 200, 0, 255] if is_leaf else [0, 0, 0, 255]
        if cloud:
            parts.append(part.sample(3000, seed=i))
            colours += 3000 * [colour]
        else:
            part.remove_unreferenced_vertices()
            part.visual.vertex_colors = colour
            parts.append(part)
    path = tmp_path / "plant.ply"
    if cloud:
        trimesh.PointCloud(np.vstack(parts), colours).export(path)
    else:
        trimesh.util.concatenate(parts).export(path)
    found, table = fitted(path, capsys)
    assert len(found) == len(known)
    for ours, true, row in zip(found, known, table):
        assert ours["length"] == pytest.approx(true["length"], rel=0.03)
        assert ours["width"] == pytest.approx(true["width"], rel=0.06)
        assert row["surface_rms_mm"] < 5


def triangulated(faces: list[tuple[int, ...]]) -> list[tuple[int, ...]]:
    return [(face[0], *pair) for face in faces for pair in pairwise(face[1:])]


def test_leaves_of_midribs_are_fitted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The source has points in centimetres, two digitisations of each leaf,
    and another plant in the same file; lengths and azimuths are in a separate
    table."""
    known, mesh = plant(MAIZE)
    lines = ["plant,leaf,number,x_cm,z_cm", "other,1,0,0,0", "other,1,0,9,9"]
    measures = ["leaf,length_cm,width_cm,azimuth_deg,insertion_height_cm"]
    for rank, (leaf, true) in enumerate(zip(rows(mesh), known), 1):
        points = 100 * leaf[:, 1]
        out = np.linalg.norm(points[:, :2] - points[0, :2], axis=1)
        up = points[:, 2] - points[0, 2]
        for number, factor in enumerate((0.9, 1.1)):
            lines += [
                f"one,{rank},{number},{factor * x},{factor * z}"
                for x, z in zip(out, up)
            ]
        measures.append(
            f"{rank},{100 * true['length']},{100 * true['width']},"
            f"{true['azimuth']},{100 * true['insertion_height']}"
        )
    (tmp_path / "midribs.csv").write_text("\n".join(lines))
    (tmp_path / "leaves.csv").write_text("\n".join(measures))
    words = ("--plant", "one", "--leaves", str(tmp_path / "leaves.csv"))
    leaves, table = fitted(tmp_path / "midribs.csv", capsys, *words)
    assert max(row["midrib_rms_mm"] for row in table) < 4
    for ours, true in zip(leaves, known):
        for key in ("length", "width", "azimuth", "insertion_height"):
            assert ours[key] == pytest.approx(true[key], abs=1e-4)
    leaves, table = fitted(
        tmp_path / "midribs.csv", capsys, *words, "--form", "angles"
    )
    for ours, true in zip(leaves, known):
        assert ours["insertion_angle"] == pytest.approx(
            true["insertion_angle"], abs=2
        )
        assert ours["curvature"] == pytest.approx(true["curvature"], abs=5)


def test_the_error_names_the_file_and_a_remedy(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = tmp_path / "midribs.csv"
    table.write_text("leaf,x_m\n1,0\n")
    assert "midribs.csv:1: there is no column of the points up" in refused(
        table, capsys
    )
    table.write_text("plant,leaf,x_m,z_m\na,1,0,0\nb,1,0,0\n")
    assert "name one by --plant: a, b" in refused(table, capsys)
    surfaces = tmp_path / "x.dat"
    surfaces.write_text("3\n2 3\n3 6\n0 0 0 1 1 1\n0 0 0 0 1 1 1 1\n1 2 3 1\n")
    assert "x.dat:1: the surface that begins here" in refused(surfaces, capsys)
    surfaces.write_text("nothing\n")
    assert "x.dat: there is no leaf in this file" in refused(surfaces, capsys)
    mesh = tmp_path / "x.obj"
    mesh.write_text("v 0 0 zero\n")
    assert "x.obj: " in refused(mesh, capsys)
    assert "there is no such file" in refused(tmp_path / "no.ply", capsys)
    table.write_text("leaf,x,z\n1,0,0\n1,9000,0\n")
    assert "give the unit by --unit" in refused(table, capsys)


def test_leaves_with_petioles_are_not_fitted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table = tmp_path / "midribs.csv"
    table.write_text("leaf,x_m,z_m\n1,0,0\n1,0.1,0.2\n")
    soybean = str(CAMPAIGNS / "crops" / "soybean.toml")
    message = refused(table, capsys, "--crop", soybean)
    assert "soybean.toml: its leaves have petioles" in message
