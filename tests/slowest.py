#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of ./test.sh, one after the other, and lists the CPU time
(user and system, with all processes that a test starts and waits for): sums by
area, and the slowest 20 tests.

    tests/slowest.py [--all] [ctest [OPTION...] | pytest [OPTION...]]

--all includes the long tests. Run it with the Python that has the package:
.venv/bin/python tests/slowest.py"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build/dev"


def cpu_seconds() -> float:
    """Returns the CPU time of this process and its finished children [s]."""
    both = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    used = [resource.getrusage(who) for who in both]
    return sum(usage.ru_utime + usage.ru_stime for usage in used)


def show(title: str, seconds: dict[str, float], failed: list[str]) -> None:
    """Prints the sums by area and the slowest tests."""
    areas: dict[str, float] = defaultdict(float)
    for name, spent in seconds.items():
        areas[name.split("::")[0].split(".")[0]] += spent
    total = sum(seconds.values())
    print(f"\n{title}: {total:.1f} s of CPU in {len(seconds)} tests")
    for kind, values in (("areas", areas), ("tests", seconds)):
        print(f"slowest {kind}:")
        ranked = sorted(values.items(), key=lambda item: -item[1])
        for name, spent in ranked[:20]:
            print(f"{spent:8.2f} s  {name}")
    if failed:
        print("failed:", *failed)


def ctest(options: list[str]) -> list[str]:
    """Runs the tests of CTest, and returns the names of those that failed."""
    command = ["ctest", "--preset", "dev", "--show-only=json-v1", *options]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, check=True)
    seconds, failed = {}, []
    for test in json.loads(listed.stdout)["tests"]:
        properties = {x["name"]: x["value"] for x in test["properties"]}
        environment = dict(os.environ)
        for line in properties.get("ENVIRONMENT", []):
            name, value = line.split("=", 1)
            environment[name] = value
        environment["PATH"] = f"{BUILD}/tests/bin:{environment['PATH']}"
        before = cpu_seconds()
        done = subprocess.run(
            test["command"],
            cwd=properties.get("WORKING_DIRECTORY", BUILD),
            env=environment,
            capture_output=True,
            check=False,
        )
        seconds[test["name"]] = cpu_seconds() - before
        if done.returncode != 0:
            failed.append(test["name"])
    show("ctest", seconds, failed)
    return failed


def pytest_runs(options: list[str]) -> int:
    """Runs the Python tests and returns the exit code. The time of a fixture
    counts for the first test that needs it."""
    # For CTest the package is not needed.
    import pytest

    seconds: dict[str, float] = {}

    class Measure:
        @pytest.hookimpl(hookwrapper=True)
        def pytest_runtest_protocol(self, item):  # type: ignore
            before = cpu_seconds()
            yield
            name = item.nodeid.split("analysis/")[-1]
            seconds[name] = cpu_seconds() - before

    code = pytest.main(options, plugins=[Measure()])
    show("pytest", seconds, [])
    return int(code)


def main(arguments: list[str]) -> int:
    """Runs the tests given by the command line."""
    is_all = "--all" in arguments
    kind, *options = [x for x in arguments if x != "--all"] or ["both"]
    os.environ["IDEOTYPE_EXECUTABLE"] = str(BUILD / "src/ideotype")
    failed: list[str] = []
    code = 0
    if kind in ("both", "ctest"):
        failed = ctest([*([] if is_all else ["-LE", "long"]), *options])
    if kind in ("both", "pytest"):
        marks = [] if is_all else ["-m", "not long"]
        tests = options or [str(ROOT / "tests/analysis")]
        code = pytest_runs(["-q", *marks, *tests])
    return 1 if failed or code else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
