# SPDX-License-Identifier: Apache-2.0
"""The results of the program are bitwise those in tests/data/golden."""

from __future__ import annotations

import golden
import pytest


@pytest.mark.parametrize("name", [*golden.CAMPAIGNS, *golden.MESHES])
def test_results_agree_bitwise_with_golden_files(name: str) -> None:
    expected = (golden.DATA / "golden" / f"{name}.txt").read_text()
    found = golden.text(golden.figures(name))
    changed = sorted(set(expected.splitlines()) ^ set(found.splitlines()))
    assert not changed, "\n".join(changed[:20])
