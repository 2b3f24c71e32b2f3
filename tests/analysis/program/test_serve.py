# SPDX-License-Identifier: Apache-2.0
"""`ideotype serve` gives bitwise the results of a run, and its output follows
its schemas."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from real_program import executable, output_of, write_campaign
from schemas import assert_needs_all, validator


def serve(campaign: Path, *requests: Any) -> list[dict[str, Any]]:
    """Returns the first line (hello) and the answers, in the order of the
    requests."""
    text = "\n".join(
        r if isinstance(r, str) else json.dumps(r) for r in requests
    )
    done = subprocess.run(
        [executable(), "serve", "--quiet", campaign],
        input=text,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stderr == ""
    hello, *answers = map(json.loads, done.stdout.splitlines())
    return [hello, *sorted(answers, key=lambda answer: answer["line"])]


@pytest.fixture(scope="module")
def history(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("served")
    output_of("run", write_campaign(folder, 2), "--out", folder)
    (path,) = (folder / "tiny").glob("*.h5")
    return path


@pytest.fixture(scope="module")
def campaign(history: Path) -> Path:
    return history.parents[1] / "tiny.toml"


def test_served_evaluations_reproduce_rows(
    history: Path, campaign: Path
) -> None:
    names = ["absorbed_by_leaf", "lai"]
    with h5py.File(history) as file:
        rows = file["evaluations"]
        genomes = rows["genome"][:].tolist()
        generations = [row // 6 for row in range(len(genomes))]
        finals = file["final"]["genome"][:].tolist()
        asked = [n for n in names if n in rows]
        assert asked
        requests = [
            {"genome": g, "generation": at, "quantities": asked}
            for g, at in zip(genomes, generations, strict=True)
        ] + [{"genome": g, "final": True} for g in finals]
        hello, *answers = serve(campaign, *requests)
        assert len(answers) == len(genomes) + len(finals) > 12
        for name in ["absorbed_par", *asked]:
            for row, answer in enumerate(answers[: len(genomes)]):
                served = (
                    answer["objectives"]
                    if name == "absorbed_par"
                    else answer["quantities"]
                )[name]["mean"]
                assert np.array_equal(served, rows[name][row]), (name, row)
        again = [
            a["objectives"]["absorbed_par"]["mean"]
            for a in answers[len(genomes) :]
        ]
        assert again == read_finals(file)
    assert hello["case"] == history.stem


def read_finals(file: h5py.File) -> list[float]:
    return file["final"]["absorbed_par"][:].tolist()


def test_options_of_requests_change_results(campaign: Path) -> None:
    genome = [g["baseline"] for g in serve(campaign)[0]["genes"]]
    variants: list[dict[str, Any]] = [
        {},
        {"seed": 2},
        {"seed": 2**53 + 1},
        {"seed": 2**53 + 2},
        {"generation": 1},
        {"final": True},
        {"tolerance": 0.001},
    ]
    _, *answers = serve(campaign, *[{"genome": genome, **v} for v in variants])
    means = [a["objectives"]["absorbed_par"]["mean"] for a in answers]
    assert len(set(means)) == len(variants)
    text = campaign.read_text()
    seeded = campaign.with_name("seeded.toml")
    seeded.write_text("seed = 2\n" + text)
    (again,) = serve(seeded, {"genome": genome})[1:]
    assert again["objectives"] == answers[1]["objectives"]
    error = answers[-1]["objectives"]["absorbed_par"]["standard_error"]
    assert error < 0.002 * means[-1]


def test_lines_of_serve_follow_their_schemas(campaign: Path) -> None:
    hello = serve(campaign)[0]
    assert_needs_all("serve_hello", hello)
    gene = hello["genes"][0]
    assert not validator("serve_hello").is_valid(
        {**hello, "genes": [{**gene, "lower": None}]}
    )
    full = {
        "id": {"any": 1},
        "genome": [g["baseline"] for g in hello["genes"]],
        "seed": 3,
        "generation": 1,
        "tolerance": 0.01,
        "quantities": [q["name"] for q in hello["quantities"]],
    }
    validator("serve_request").validate(full)
    _, done, failed = serve(campaign, full, "nonsense")
    assert_needs_all("serve_answer", done)
    assert_needs_all("serve_answer", failed)
    assert done["id"] == full["id"]
    sizes = {a["name"]: len(a["coordinates"]) for a in hello["axes"]}
    for quantity in hello["quantities"]:
        shape = tuple(sizes[axis] for axis in quantity["axes"])
        for figure in ("mean", "standard_error"):
            found = done["quantities"][quantity["name"]][figure]
            assert np.shape(found) == shape, quantity["name"]


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("genome", "x"),
        ("seed", -1),
        ("seed", 1.5),
        ("generation", 2**32),
        ("tolerance", 0.1),
        ("final", 1),
        ("quantities", "lai"),
        ("genes", []),
    ],
)
def test_the_schema_refuses_what_the_program_refuses(
    campaign: Path, key: str, value: Any
) -> None:
    genome = [g["baseline"] for g in serve(campaign)[0]["genes"]]
    request = {"genome": genome, key: value}
    assert not validator("serve_request").is_valid(request)
    (answer,) = serve(campaign, request)[1:]
    assert answer["status"] == "failed"
    assert key in answer["message"]
