# SPDX-License-Identifier: Apache-2.0
"""Makes single calls fail in a small campaign: a short form of
tests/faults."""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

import pytest
from real_program import executable

_FAULTS = Path(__file__).parents[2] / "faults"
sys.path.insert(0, str(_FAULTS))

from disturbed import Setup  # noqa: E402
from faults import SETUPS, faults_of, prepared, tried  # noqa: E402

_SEED = 40


def _library() -> Path:
    program = Path(executable())
    library = program.parents[1] / "tests" / "faults" / "faults.so"
    assert library.exists(), f"{library} is missing; build the target faults"
    return library


@pytest.fixture(scope="module")
def setups(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Setup]:
    folder = tmp_path_factory.mktemp("faults")
    program = Path(executable())
    return {
        name: prepared(program, _library(), name, folder / name)
        for name in SETUPS
    }


@pytest.mark.parametrize("name", SETUPS)
def test_no_fault_loses_or_changes_a_row(
    setups: dict[str, Setup], name: str
) -> None:
    _, _, rank, file = SETUPS[name]
    setup = setups[name]
    counts = setup.counts(rank, file)
    faults = list(faults_of(name, counts, 1, 2, _SEED))
    outcomes: dict[tuple[str, str], Counter[str]] = {}
    for fault, verdict in tried(setup, faults, 2):
        assert not verdict.wrong, (fault, verdict)
        at = (fault.kind, fault.mode)
        outcomes.setdefault(at, Counter())[verdict.outcome] += 1
    # Interrupted or partial reads must have no effect.
    for at in {("read", "EINTR"), ("read", "short")} & outcomes.keys():
        if file is not None:
            assert set(outcomes[at]) == {"right"}, at


def test_data_that_the_disk_refuses_are_reported(
    setups: dict[str, Setup],
) -> None:
    setup = setups["day"]
    counts = setup.counts(None, None)
    assert counts["sync"] >= 3
    faults = [
        fault
        for fault in faults_of("day", counts, 9, 0, _SEED)
        if fault.kind == "sync"
    ]
    for fault, verdict in tried(setup, faults, 2):
        expected = "right" if fault.mode == "EINTR" else "told"
        assert verdict.outcome == expected, (fault, verdict)
        assert not verdict.wrong, (fault, verdict)
