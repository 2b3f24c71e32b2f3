# SPDX-License-Identifier: Apache-2.0
"""Workflows only name jobs of `.ci/job` and contain no logic, so that all jobs
can also be run locally."""

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
    """Returns the jobs that `.ci/job` lists if no job is given."""
    done = subprocess.run(
        [TOP / ".ci/job"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    names = done.stderr.rpartition("one of ")[2].split()
    assert len(names) > 5
    return names


def expanded(job: dict) -> list[dict]:
    """Returns the job for each combination of its matrix, with the values
    inserted in its texts."""
    matrix = job.get("strategy", {}).get("matrix", {})
    workflows = []
    for values in itertools.product(*matrix.values()):
        text = yaml.safe_dump(job)
        for name, value in zip(matrix, values, strict=True):
            place = f"${{{{ matrix.{name} }}}}"
            text = text.replace(place, str(value))
        workflows.append(yaml.safe_load(text))
    return workflows


def offences(workflow: dict, known: list[str]) -> list[str]:
    """Returns the jobs that break the rule: a job checks out the project, then
    runs a single line."""
    offences = []
    for name, job in workflow["jobs"].items():
        for variant in expanded(job):
            container = variant["container"]
            image = (
                container["image"]
                if isinstance(container, dict)
                else container
            )
            if not CONTAINER.fullmatch(image):
                offences.append(f"{name}: {image} is no Debian 12 or 13")
            checkout, *rest = variant["steps"]
            if "run" in checkout or "checkout" not in checkout["uses"]:
                offences.append(f"{name}: the first step is no checkout")
            if rest not in [[{"run": f".ci/job {job}"}] for job in known]:
                offences.append(f"{name}: {rest} is not one job of .ci/job")
            if job.keys() - KEYS:
                offences.append(f"{name}: {job.keys() - KEYS}")
    return offences


def list_jobs(path: Path) -> set[tuple[str, str]]:
    """Returns the Debian release and the name of each job of a workflow."""
    jobs = set()
    for job in yaml.safe_load(path.read_text())["jobs"].values():
        for variant in expanded(job):
            text = yaml.safe_dump(variant["container"])
            suite = CONTAINER.search(text)
            assert suite
            name = variant["steps"][-1]["run"].removeprefix(".ci/job ")
            jobs.add((suite[1], name))
    return jobs


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.stem)
def test_workflows_run_jobs_and_hold_no_logic(path: Path) -> None:
    text = path.read_text()
    assert not offences(yaml.safe_load(text), known_jobs())
    assert text.count("- run: ") == len(yaml.safe_load(text)["jobs"])


def test_each_job_runs_on_its_debian_releases() -> None:
    push = list_jobs(TOP / ".github/workflows/ci.yml")
    night = list_jobs(TOP / ".github/workflows/nightly.yml")
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

    def find_offences(**changes: object) -> list[str]:
        job = {"container": image, "steps": steps} | changes
        return offences({"jobs": {"a": job}}, ["gcc"])

    assert not find_offences()
    assert find_offences(container="ubuntu:24.04")
    assert find_offences(steps=[*steps, {"run": "echo done"}])
    assert find_offences(steps=steps[1:] + steps[:1])
    assert find_offences(steps=[steps[0], {"run": ".ci/job gcc && true"}])
    assert find_offences(steps=[steps[0], {"run": ".ci/job msvc"}])
    assert find_offences(steps=[steps[0], steps[1] | {"if": "always()"}])
    assert find_offences(env={"CI": "yes"})
    matrix = {"matrix": {"job": ["gcc", "msvc"]}}
    step = {"run": ".ci/job ${{ matrix.job }}"}
    assert len(find_offences(strategy=matrix, steps=[steps[0], step])) == 1
