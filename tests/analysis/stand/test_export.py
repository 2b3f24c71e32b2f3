# SPDX-License-Identifier: Apache-2.0
"""Exported plants and fields can be opened by the readers of VTK, which
ParaView also uses."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from real_program import (
    CAMPAIGNS,
    FACES,
    executable,
    output_of,
    write_campaign,
)

from ideotype import Stand
from ideotype.history import open_history

pytest.importorskip(
    "vtkmodules",
    reason="without vtk exported files are not opened; install the extra "
    "`test` of the analysis package",
)

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

ABSORBED = "absorbed_par [MJ m-2 day-1]"
ERROR = "standard_error [MJ m-2 day-1]"
GROUPS = 16
"""The number of groups of a plant: its leaves, stalk and five kinds of other
organs."""
FINAL_PATHS = 256


def opened(reader: Any, path: Path) -> vtkPolyData:
    """Returns the data that VTK reads; errors are not permitted."""
    errors: list[str] = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.SetFileName(str(path))
    reader.Update()
    assert errors == []
    return reader.GetOutput()


def cells(data: vtkPolyData, name: str) -> NDArray[np.float64]:
    """Returns one value per face."""
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def areas(data: vtkPolyData) -> NDArray[np.float64]:
    """Returns the areas of faces as VTK computes them [m2]."""
    size = vtkCellSizeFilter()
    size.SetInputData(data)
    size.Update()
    return cells(size.GetOutput(), "Area")


def exported(own: Path, to: Path, *options: object) -> Path:
    """Exports to a file and returns its path."""
    output_of("export", own, *options, "--to", to)
    return to


def totals(data: vtkPolyData) -> tuple[float, float]:
    """Returns the light that leaves and stalks absorb, per area of ground [MJ
    m-2 day-1]."""
    fields = data.GetFieldData()
    ground = fields.GetArray("ground_area [m2]").GetValue(0)
    energy = cells(data, ABSORBED) * areas(data) / ground
    is_leaf = cells(data, "organ") > 0
    return energy[is_leaf].sum(), energy[~is_leaf].sum()


def test_exported_light_of_a_plant_agrees_with_its_evaluation(
    tiny_run: Path, tmp_path: Path
) -> None:
    paths = ("--paths", FINAL_PATHS)
    path = exported(tiny_run, tmp_path / "best.vtp", "--best", *paths)
    data = opened(vtkXMLPolyDataReader(), path)
    with open_history(tiny_run) as history:
        best = history.best()
        case = str(history.attributes["case"])
    assert best is not None and best.is_final
    assert data.GetNumberOfCells() == FACES
    assert case in data.GetFieldData().GetAbstractArray("title").GetValue(0)
    assert cells(data, "area [m2]") == pytest.approx(areas(data), abs=1e-7)
    assert set(cells(data, "organ")) == set(range(11))
    assert np.all(cells(data, ERROR) >= 0)
    leaves, stalks = totals(data)
    incident = best.estimate("incident").mean
    # Exported coordinates have seven decimals.
    assert leaves == pytest.approx(best.objective.mean, rel=1e-5)
    expected = best.estimate("stalk_fraction").mean * incident
    assert stalks == pytest.approx(expected, rel=1e-4)


def test_by_default_exported_light_of_faces_is_accurate(
    tiny_run: Path, tmp_path: Path
) -> None:
    path = exported(tiny_run, tmp_path / "best.vtp", "--best")
    data = opened(vtkXMLPolyDataReader(), path)
    absorbed = cells(data, ABSORBED)
    is_leaf = cells(data, "organ") > 0
    bright = is_leaf & (absorbed > absorbed.max() / 4)
    assert np.median((cells(data, ERROR) / absorbed)[bright]) < 0.1


def test_exported_light_of_a_field_agrees_with_its_evaluation(
    tiny_run: Path, tmp_path: Path
) -> None:
    row = ("--generation", 1, "--slot", 3)
    path = exported(
        tiny_run, tmp_path / "field.vtp", *row, "--field", "--paths", 64
    )
    data = opened(vtkXMLPolyDataReader(), path)
    assert data.GetNumberOfCells() == 4 * FACES
    assert list(np.bincount(cells(data, "plant"))) == [0, *[FACES] * 4]
    with open_history(tiny_run) as history:
        rows = history.evaluations(1)
        (at,) = np.flatnonzero(rows.slot == 3)
        expected = rows["absorbed_par"].values[at]
    assert totals(data)[0] == pytest.approx(expected, rel=1e-5)


def test_fields_exported_in_both_formats_have_the_same_surfaces(
    tiny_run: Path, tmp_path: Path
) -> None:
    field = ("--best", "--field")
    obj = exported(tiny_run, tmp_path / "field.obj", *field)
    vtp = exported(tiny_run, tmp_path / "field.vtp", *field, "--paths", 64)
    surfaces = opened(vtkOBJReader(), obj)
    lit = opened(vtkXMLPolyDataReader(), vtp)
    assert surfaces.GetNumberOfCells() == 4 * FACES
    assert surfaces.GetBounds() == pytest.approx(lit.GetBounds(), abs=1e-6)
    assert areas(surfaces) == pytest.approx(areas(lit), rel=1e-3, abs=1e-7)
    text = obj.read_text()
    assert "# repeats every 1.524000 m in x and 0.304800 m in y\n" in text
    assert "# y points 90 deg clockwise from north\n" in text
    groups = [x for x in text.splitlines() if x.startswith("g ")]
    assert len(groups) == len(set(groups)) == 4 * GROUPS


def test_growing_plants_are_exported_at_their_stage(tmp_path: Path) -> None:
    settings = [
        word
        for key in (
            *("light.stages=3", "light.paths=64", "light.randomisations=4"),
            *("search.optimizer=ga", "search.population=4"),
            "stop.generations=1",
            *(
                "final.paths=64",
                "final.randomisations=4",
                "final.candidates=1",
            ),
        )
        for word in ("--set", key)
    ]
    campaign = CAMPAIGNS / "growing_season.toml"
    output_of("run", campaign, "--out", tmp_path, *settings)
    (history,) = (tmp_path / "growing_season").glob("*.h5")
    stand = Stand.from_history(history, same_isa=False)
    with open_history(history) as opened_history:
        best = opened_history.best()
    assert best is not None
    for at in (300, 900, 1700):
        to = exported(history, tmp_path / f"{at}.obj", "--best", "--at", at)
        mesh = stand.mesh(best.row.genome[0], thermal_time=at)
        surfaces = opened(vtkOBJReader(), to)
        assert surfaces.GetNumberOfCells() == len(mesh.faces)
        ends = np.stack([mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)])
        assert surfaces.GetBounds() == pytest.approx(
            ends.T.ravel().tolist(), abs=1e-6
        )
    # Each file contains the light of one day; faces receive at most the light
    # above the canopy.
    light = []
    for day in ("2011-06-20", "2012-07-25"):
        to = exported(
            history, tmp_path / f"{day}.vtp", "--best", "--at", day,
            "--field", "--paths", 64,
        )  # fmt: skip
        data = opened(vtkXMLPolyDataReader(), to)
        title = data.GetFieldData().GetAbstractArray("title").GetValue(0)
        assert f"{day} (" in title
        light.append(sum(totals(data)))
    assert 0.5 < light[0] < light[1] < 15
    for at, to, why in (
        ("soon", "a.obj", "neither a date nor a number"),
        ("2011-12-24", "a.obj", "is not in the season"),
        ("4000", "a.obj", "is not in the season"),
        ("500", "a.csv", "write a .obj or .vtp"),
    ):
        words = (
            "export",
            history,
            "--best",
            "--at",
            at,
            "--to",
            tmp_path / to,
        )
        done = subprocess.run(
            [executable(), *map(str, words)],
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 2 and why in done.stderr, done.stderr


def test_tracking_modules_are_exported_once(tmp_path: Path) -> None:
    campaign = write_campaign(tmp_path, 1)
    rows = "pitch=1.524, height=4, width=1, azimuth=0, tracks=true"
    output_of(
        "run", campaign, "--out", tmp_path, "--set", f"panel=[{{{rows}}}]"
    )
    (history,) = (tmp_path / "tiny").glob("*.h5")
    row = ("--best", "--field")
    obj = exported(history, tmp_path / "field.obj", *row)
    vtp = exported(history, tmp_path / "field.vtp", *row, "--paths", 64)
    for reader, path in ((vtkOBJReader(), obj), (vtkXMLPolyDataReader(), vtp)):
        assert opened(reader, path).GetNumberOfCells() == 4 * FACES + 1
    (panel,) = re.findall(r"(?m)^g (panel.*)$", obj.read_text())
    assert re.fullmatch(r"panel_pose\d\d", panel)
    light = cells(opened(vtkXMLPolyDataReader(), vtp), ABSORBED)
    assert light[-1] > 0
