# SPDX-License-Identifier: Apache-2.0
"""Workflows name jobs of `.ci/job` and hold no logic, so that each job runs
here as it does there."""

from __future__ import annotations

import itertools
import re
import subprocess
from pathlib import Path

import pytest
import yaml

TOP = Path(__file__).parents[3]
WORKFLOWS = sorted((TOP / ".github/workflows").glob("*.yml"))
KEYS = {"strategy", "runs-on", "container", "timeout-minutes", "steps"}
CONTAINER = re.compile(r"buildpack-deps:(bookworm|trixie)-scm")


def known_jobs() -> list[str]:
    """Returns the jobs that `.ci/job` names where it is given none."""
    done = subprocess.run(
        [TOP / ".ci/job"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    names = done.stderr.rpartition("one of ")[2].split()
    assert len(names) > 5
    return names


def expanded(job: dict) -> list[dict]:
    """Returns the job once for each combination of its matrix, with the values
    of the matrix in its texts."""
    matrix = job.get("strategy", {}).get("matrix", {})
    found = []
    for values in itertools.product(*matrix.values()):
        text = yaml.safe_dump(job)
        for name, value in zip(matrix, values, strict=True):
            place = f"${{{{ matrix.{name} }}}}"
            text = text.replace(place, str(value))
        found.append(yaml.safe_load(text))
    return found


def offences(workflow: dict, known: list[str]) -> list[str]:
    """Returns what is wrong with jobs: each checks out, then runs one line."""
    found = []
    for name, job in workflow["jobs"].items():
        for each in expanded(job):
            container = each["container"]
            image = (
                container["image"]
                if isinstance(container, dict)
                else container
            )
            if not CONTAINER.fullmatch(image):
                found.append(f"{name}: {image} is no Debian 12 or 13")
            checkout, *rest = each["steps"]
            if "run" in checkout or "checkout" not in checkout["uses"]:
                found.append(f"{name}: the first step is no checkout")
            if rest not in [[{"run": f".ci/job {job}"}] for job in known]:
                found.append(f"{name}: {rest} is not one job of .ci/job")
            if job.keys() - KEYS:
                found.append(f"{name}: {job.keys() - KEYS}")
    return found


def jobs_of(path: Path) -> set[tuple[str, str]]:
    """Returns the Debian and the name of each job of a workflow."""
    found = set()
    for job in yaml.safe_load(path.read_text())["jobs"].values():
        for each in expanded(job):
            text = yaml.safe_dump(each["container"])
            suite = CONTAINER.search(text)
            assert suite
            name = each["steps"][-1]["run"].removeprefix(".ci/job ")
            found.add((suite[1], name))
    return found


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.stem)
def test_workflows_run_jobs_and_hold_no_logic(path: Path) -> None:
    text = path.read_text()
    assert not offences(yaml.safe_load(text), known_jobs())
    assert text.count("- run: ") == len(yaml.safe_load(text)["jobs"])


def test_each_job_runs_where_it_should() -> None:
    push = jobs_of(TOP / ".github/workflows/ci.yml")
    night = jobs_of(TOP / ".github/workflows/nightly.yml")
    assert push == {
        *itertools.product(["bookworm", "trixie"], ["gcc", "clang"]),
        ("bookworm", "lint"),
    }
    assert {job for _, job in push | night} == set(known_jobs())


def test_a_change_passes_the_jobs_of_a_push() -> None:
    lines = (TOP / ".ci/run").read_text().splitlines()
    jobs = [x.split()[1] for x in lines if x.startswith(".ci/job ")]
    assert jobs == ["lint", "gcc"]


def test_logic_in_a_workflow_is_found() -> None:
    steps = [{"uses": "actions/checkout@v4"}, {"run": ".ci/job gcc"}]
    image = "buildpack-deps:trixie-scm"

    def found(**changes: object) -> list[str]:
        job = {"container": image, "steps": steps} | changes
        return offences({"jobs": {"a": job}}, ["gcc"])

    assert not found()
    assert found(container="ubuntu:24.04")
    assert found(steps=[*steps, {"run": "echo done"}])
    assert found(steps=steps[1:] + steps[:1])
    assert found(steps=[steps[0], {"run": ".ci/job gcc && true"}])
    assert found(steps=[steps[0], {"run": ".ci/job msvc"}])
    assert found(steps=[steps[0], steps[1] | {"if": "always()"}])
    assert found(env={"CI": "yes"})
    matrix = {"matrix": {"job": ["gcc", "msvc"]}}
    step = {"run": ".ci/job ${{ matrix.job }}"}
    assert len(found(strategy=matrix, steps=[steps[0], step])) == 1
