# SPDX-License-Identifier: Apache-2.0
"""The script analysis/study/study.py makes tables from histories, and finds
missing data."""

from __future__ import annotations

import re
from pathlib import Path

from real_program import CAMPAIGNS
from short_study import PARTS, run, tables_of

ELSEWHERE = {
    *("strips", "invaders", "panels_measured", "panels_trial", "panels_bred"),
    *("growth_best", "growth_tops", "seasons", "front_water", "water"),
}
"""The parts that test_campaign_scripts.py makes."""


def test_a_number_that_histories_do_not_say_is_found(tmp_path: Path) -> None:
    assert set(PARTS) > ELSEWHERE
    text = tables_of(tmp_path, [x for x in PARTS if x not in ELSEWHERE])
    results = tmp_path / "RESULTS.md"
    row = re.search(r"\| clear \| area \| 42 \| ([+-][\d.]+) ±", text)
    assert row is not None
    assert re.search(r"\d of 1\d facts pass", text)

    again = run(tmp_path, "--only", "erect_tops", "--check")
    assert again.returncode == 0, again.stderr
    assert re.search(r"erect_tops: .* [1-9]\d* evaluations", again.stdout)
    assert results.read_text() == text
    changed = f"{float(row[1]) + 1:+.1f}"
    wrong_row = row[0].replace(row[1], changed)
    results.write_text(text.replace(row[0], wrong_row, 1))
    wrong = run(tmp_path, "--only", "erect_tops", "--check")
    assert wrong.returncode != 0
    assert "erect_tops is not" in wrong.stderr and row[1] in wrong.stderr
    assert changed in results.read_text()


def test_the_small_study_of_results_is_what_histories_say(
    tmp_path: Path,
) -> None:
    quoted = CAMPAIGNS.parent / "analysis" / "study" / "RESULTS.md"
    done = run(tmp_path, "--only", "erect_tops", "--check", results=quoted)
    assert done.returncode == 0, done.stderr


def test_a_place_that_is_missing_is_told(tmp_path: Path) -> None:
    (tmp_path / "RESULTS.md").write_text("# Results\n")
    done = run(tmp_path, "--only", "plants_differ")
    assert done.returncode != 0
    assert "has no place" in done.stderr
    assert "<!-- short study: plants_differ -->" in done.stderr
