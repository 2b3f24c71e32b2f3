# SPDX-License-Identifier: Apache-2.0
"""Live pages open plants, campaigns, and folders of histories."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from conftest import WriterProcess
from live_page import CAMPAIGNS
from made_obj import MIDRIBS, obj_of
from real_program import run_with, write_campaign

from ideotype import Error, Stand
from ideotype.live.conditions import make_tables
from ideotype.live.levers import make_levers
from ideotype.live.opened import CROPS, open_place
from ideotype.live.play import main as play
from ideotype.live.runs import Folder
from ideotype.live.watch import main as watch

pytestmark = pytest.mark.long


def test_measured_plants_are_opened(tmp_path: Path) -> None:
    midribs = tmp_path / "mine.csv"
    midribs.write_text(MIDRIBS)
    found = open_place(str(midribs))
    assert "2 leaves of mine.csv" in found.about
    obj = tmp_path / "mine.obj"
    obj.write_text(obj_of(MIDRIBS))
    again = open_place(str(obj))
    lengths = [
        [leaf["length"] for leaf in each.base["plant"]["baseline"]["leaf"]]
        for each in (found, again)
    ]
    assert lengths[1] == pytest.approx(lengths[0], rel=0.05)
    leaves = open_place(str(CAMPAIGNS / "plants" / "F331_S1.csv"))
    assert len(leaves.base["plant"]["baseline"]["leaf"]) == 11


@pytest.mark.parametrize("crop", CROPS)
def test_crops_that_come_with_the_package_are_opened(crop: str) -> None:
    found = open_place(crop)
    assert found.conditions.when == "season" and found.free.any()


def test_every_campaign_is_opened() -> None:
    for path in sorted(CAMPAIGNS.glob("*.toml")):
        found = open_place(str(path))
        tables = make_tables(found.base, found.conditions, found.conditions)
        stand = Stand(tables)
        assert len(stand.baseline) == len(found.genome), path
        assert len(make_levers(stand, tables)) == len(found.genome), path


def test_a_page_begins_with_the_entries_of_the_case(tmp_path: Path) -> None:
    campaign = write_campaign(tmp_path, 2)
    latitudes = {"X": 5, "North": 60, "2": 10, "north_2": 42}
    sites = "\n".join(
        f'[[site]]\nname = "{name}"\nlatitude = {latitude}\n'
        "longitude = -93.6\nutc_offset = -6\n"
        for name, latitude in latitudes.items()
    )
    text = campaign.read_text()
    campaign.write_text(
        text[: text.index("[[site]]")] + sites + text[text.index("[[day]]") :]
    )
    for case, latitude in enumerate(latitudes.values()):
        found = open_place(str(campaign), case=case)
        assert found.conditions.latitude == latitude


def test_the_best_plant_of_a_sensitivity_study_is_opened(
    tmp_path: Path,
) -> None:
    study = '\n[sensitivity]\nmethod = "morris"\nsamples = 4\n'
    path = run_with(tmp_path, study, "sensitivity")
    assert "The best plant of" in open_place(str(path)).about


BAD = {
    "missing.toml": None,
    "text.md": b"hello",
    "garbage.toml": b"\x00\xff = [",
    "empty.toml": b"",
    "wrong.toml": b"name = 'x'\n[[site]]\nlatitude = 'north'\n",
    "no.h5": b"\x89HDF\r\n\x1a\n and then nothing",
    "empty.csv": b"",
    "bad.csv": b"leaf,x_cm,z_cm\n1,zero,0\n",
    "no_faces.obj": b"v 0 0 0\n",
    "\x1b[2Jname.toml": b"x =",
}


@pytest.mark.parametrize("name", BAD)
def test_bad_files_are_refused_with_a_reason(
    tmp_path: Path, capsys: pytest.CaptureFixture, name: str
) -> None:
    path = tmp_path / name
    if (content := BAD[name]) is not None:
        path.write_bytes(content)
    assert play([str(path), "--no-browser"]) == 3
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith("ideotype play: ")
    assert path.name.replace("\x1b", "\\x1b") in printed.err
    assert "\x1b" not in printed.err and "Traceback" not in printed.err


def test_a_missing_folder_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture
) -> None:
    assert watch([str(tmp_path / "none"), "--no-browser"]) == 3
    assert "there is no such folder" in capsys.readouterr().err
    assert play(["maize", "--no-browser", "--port", "1234567"]) == 3


def test_a_folder_is_summarised_with_its_damaged_files(
    finished: Path, tmp_path: Path
) -> None:
    hostile = "<img src=x onerror=alert(1)>.h5"
    (tmp_path / hostile).write_bytes(b"no history")
    deep = tmp_path / "deep"
    deep.mkdir()
    (deep / "case.h5").write_bytes(finished.read_bytes())
    summary = Folder(tmp_path).summarise()
    by_file = {case["file"]: case for case in summary["cases"]}
    assert "problem" in by_file[hostile]
    case = by_file["deep/case.h5"]
    assert case["state"] == "finished" and case["core_hours_left"] == 0
    assert case["generation"] == len(case["convergence"][0])
    assert case["best"][0] > case["baseline"][0]
    assert (summary["finished"], summary["damaged"]) == (1, 1)
    json.dumps(summary, allow_nan=False)


def test_equal_cases_are_named_by_their_folders(
    finished: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("results", "long"):
        (tmp_path / name / "mine").mkdir(parents=True)
        (tmp_path / name / "mine" / "case.h5").write_bytes(
            finished.read_bytes()
        )
    folder = Folder(tmp_path)
    for _ in range(2):
        names = [case["name"] for case in folder.summarise()["cases"]]
        assert len({name.split(" ")[0] for name in names}) == 1
        assert [name.split(" ", 1)[1] for name in names] == [
            "(long)",
            "(results)",
        ]
    # The title of the page is the name of the current folder.
    monkeypatch.chdir(tmp_path)
    assert Folder(Path()).summarise()["folder"] == tmp_path.name


def test_a_running_case_is_summarised_while_it_grows(
    writer: WriterProcess,
) -> None:
    folder = Folder(writer.path.parent)
    case = folder.summarise()["cases"][0]
    assert (case["state"], case["evaluations"]) == ("running", 0)
    assert case["best"] is None and case["core_hours_left"] is None
    writer.do("record 0 3")
    assert folder.summarise()["cases"][0]["evaluations"] == 1
    writer.kill()
    summary = folder.summarise()
    assert summary["cases"][0]["state"] == "interrupted"
    assert summary["rate"] == 0


def test_an_error_is_raised_for_a_folder_that_is_not_there() -> None:
    with pytest.raises(Error, match="no such folder"):
        Folder(Path("/nowhere/at/all"))
