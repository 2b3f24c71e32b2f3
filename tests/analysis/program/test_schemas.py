# SPDX-License-Identifier: Apache-2.0
"""The JSON that the commands status, check, plan and compare print follows its
schema."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest
from real_program import executable, output_of, write_campaign
from schemas import assert_needs_all, validator


def print_json(expected: int, *words: object) -> dict[str, Any]:
    """Returns the document that a command prints, after a check of its exit
    code."""
    done = subprocess.run(
        [executable(), *map(str, words), "--json"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == expected, done.stderr
    document: dict[str, Any] = json.loads(done.stdout)
    return document


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Provides a folder with tiny.toml and its finished history."""
    folder = tmp_path_factory.mktemp("told")
    output_of("run", write_campaign(folder, 2), "--out", folder)
    return folder


def history(folder: Path) -> Path:
    (path,) = (folder / "tiny").glob("*.h5")
    return path


def test_status_prints_json_of_its_schema(
    folder: Path, tmp_path: Path
) -> None:
    document = print_json(0, "status", folder)
    assert_needs_all("status", document)
    (one,) = document["histories"]
    assert one["state"] == "finished"
    assert one["ended_by"] == "generations"
    assert (one["complete_generations"], one["generations"]) == (2, 2)
    assert one["evaluations"] == 12
    assert one["best"]["is_evaluated_again"]
    assert one["best"]["unit"] == "MJ m-2 day-1"
    broken = {**one, "state": "asleep"}
    assert not validator("status").is_valid(
        {**document, "histories": [broken]}
    )

    cut, no_history = tmp_path / "cut.h5", tmp_path / "none.h5"
    data = history(folder).read_bytes()
    cut.write_bytes(data[: len(data) - 4096])
    no_history.write_text("nothing")
    document = print_json(4, "status", cut, no_history, history(folder))
    validator("status").validate(document)
    assert [h["state"] for h in document["histories"]] == [
        "truncated",
        "finished",
    ]
    assert document["histories"][0]["missing_bytes"] == 4096
    assert [f["path"] for f in document["unreadable"]] == [str(no_history)]


def test_status_of_stopped_runs_prints_json_of_its_schema(
    tmp_path: Path,
) -> None:
    campaign = write_campaign(tmp_path, 5000)
    words = [executable(), "run", campaign, "--out", tmp_path]
    subprocess.run(
        [*words, "--wall-time", "1s"], check=False, capture_output=True
    )
    document = print_json(0, "status", tmp_path)
    assert_needs_all("status", document)
    (one,) = document["histories"]
    assert one["state"] == "drained"
    assert one["left_s"] > 0
    assert one["evaluations_per_second"] > 0
    assert document["go_on_with"][0].endswith("--resume")


def test_check_prints_json_of_its_schema(folder: Path, tmp_path: Path) -> None:
    document = print_json(0, "check", folder / "tiny.toml")
    assert_needs_all("check", document)
    (case,) = document["cases"]
    assert case["name"] == history(folder).stem
    assert [w["workers"] for w in document["cost"]["by_workers"]][:2] == [1, 2]
    assert not validator("check").is_valid(
        {**document, "cases": [{**case, "seed": "1"}]}
    )
    assert document["genes"] == 79 and document["free_genes"] == 40
    assert document["field"]["rows"] == 2
    assert document["cost"]["evaluations_per_case"] == 12
    assert document["leaves"] == [] and not document["grows"]
    assert document["development_stage"] == 1
    assert document["search"] == {
        "optimizer": "ga",
        "population": 6,
        "first_generation": 6,
        "streams": 1,
        "most_plants": 12,
    }
    settings = ("objective.maximise=net_assimilation", "search.optimizer=auto")
    words = [x for key in settings for x in ("--set", key)]
    more = ("--set", "search.population=8", "--set", "stop.generations=3")
    document = print_json(0, "check", folder / "tiny.toml", *words, *more)
    assert_needs_all("check", document)
    (leaves,) = document["leaves"]
    assert leaves["model"] == "hyperbola"
    assert leaves["file"].endswith("maize.toml")
    assert {x["name"]: x["values"] for x in leaves["numbers"]} == {
        "phi": [0.06],
        "theta": [0.7],
        "amax": [pytest.approx(63.929, abs=1e-3)],
        "rate_2000": [52],
        "rd": [2],
    }
    assert document["search"]["first_generation"] == 5
    cost = {**document["cost"], "evaluation_s": None}
    assert not validator("check").is_valid({**document, "cost": cost})

    campaign = write_campaign(tmp_path, 2)
    campaign.write_text(campaign.read_text().replace("rows", "lines"))
    document = print_json(3, "check", campaign)
    assert_needs_all("check", document)
    assert not document["is_valid"]
    problem = document["problems"][0]
    assert problem["file"] == str(campaign)
    assert (
        campaign.read_text().splitlines()[problem["line"] - 1] == "lines = 2"
    )
    assert "lines" in problem["message"]
    assert (problem["key"], problem["code"]) == ("field.lines", "unknown_key")


def test_check_of_scenarios_prints_json_of_its_schema(tmp_path: Path) -> None:
    campaign = write_campaign(tmp_path, 2)
    spacing = "\n[[spacing]]\nrow = 0.5\nplant = 0.2\n"
    over = '\n[objective]\nover = ["spacing"]\n'
    campaign.write_text(campaign.read_text() + spacing + over)
    document = print_json(0, "check", campaign)
    validator("check").validate(document)
    assert len(document["scenarios"]) == 2


def test_compare_prints_json_of_its_schema(folder: Path) -> None:
    campaign = folder / "tiny.toml"
    document = print_json(
        0, "compare", history(folder), campaign, "--under", campaign
    )
    assert_needs_all("compare", document)
    assert len(document["mean"]) == len(document["plants"]) == 2
    assert document["difference"]["mean"][0] == [0]
    leaves = document["profiles"]["absorbed_by_leaf"]
    assert len(leaves["mean"][1][0]) == len(leaves["coordinates"])
    broken = {**document, "mean": document["mean"][0]}
    assert not validator("compare").is_valid(broken)
