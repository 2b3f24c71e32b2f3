# SPDX-License-Identifier: Apache-2.0
"""The script analysis/study/study.py makes tables from histories, and detects
missing data."""

from __future__ import annotations

import re
from pathlib import Path

from real_program import CAMPAIGNS
from short_study import PARTS, make_tables, run

ELSEWHERE = {
    *("strips", "invaders", "panels_measured", "panels_trial", "panels_bred"),
    *("growth_best", "growth_tops", "seasons", "front_water", "water"),
    *("selection_grain", "selection_carbon", "over_draws"),
}
"""The parts that test_campaign_scripts.py makes."""


def test_numbers_without_support_in_histories_are_found(
    tmp_path: Path,
) -> None:
    assert set(PARTS) > ELSEWHERE
    text = make_tables(tmp_path, [x for x in PARTS if x not in ELSEWHERE])
    results = tmp_path / "results" / "erect_tops.md"
    page = results.read_text()
    row = re.search(r"\| clear \| area \| 42 \| ([+-][\d.]+) ±", text)
    assert row is not None
    assert re.search(r"\d of 1\d facts pass", text)
    # A sentence below the table of each part with searches for one best plant.
    stated = re.findall(
        r"(?m)^Searches: (\d+)\. Converged: yes (\d+), no (\d+), unknown "
        r"(\d+).*\. At a bound: .+\.$",
        text,
    )
    assert len(stated) > 5, text
    for total, *verdicts in stated:
        assert int(total) == sum(map(int, verdicts)) > 0

    again = run(tmp_path, "--only", "erect_tops", "--check")
    assert again.returncode == 0, again.stderr
    assert re.search(r"erect_tops: .* [1-9]\d* evaluations", again.stdout)
    assert results.read_text() == page
    changed = f"{float(row[1]) + 1:+.1f}"
    wrong_row = row[0].replace(row[1], changed)
    results.write_text(page.replace(row[0], wrong_row, 1))
    wrong = run(tmp_path, "--only", "erect_tops", "--check")
    assert wrong.returncode != 0
    assert f"{results}: short study: erect_tops is not" in wrong.stderr
    assert re.search(rf"(?m)^\+.*{re.escape(row[0])}", wrong.stderr)
    assert re.search(rf"(?m)^-.*{re.escape(wrong_row)}", wrong.stderr)
    assert "| overcast |" not in wrong.stderr
    assert changed in results.read_text()


def test_the_small_study_agrees_with_its_histories(
    tmp_path: Path,
) -> None:
    quoted = CAMPAIGNS.parent / "docs" / "results"
    done = run(tmp_path, "--only", "erect_tops", "--check", results=quoted)
    assert done.returncode == 0, done.stderr


def test_a_missing_mark_in_results_is_reported(tmp_path: Path) -> None:
    results = tmp_path / "results"
    results.mkdir()
    (results / "index.md").write_text("# Results\n")
    done = run(tmp_path, "--only", "plants_differ")
    assert done.returncode != 0
    assert "has no place" in done.stderr
    assert "<!-- short study: plants_differ -->" in done.stderr


def test_two_places_of_a_table_are_reported(tmp_path: Path) -> None:
    results = tmp_path / "results"
    results.mkdir()
    for name in ("first", "second"):
        (results / f"{name}.md").write_text(
            "<!-- short study: plants_differ -->\n<!-- end of study -->\n"
        )
    done = run(tmp_path, "--only", "plants_differ")
    assert done.returncode != 0
    assert "several places" in done.stderr
    assert "first.md, second.md" in done.stderr


def test_every_part_has_one_place_in_the_results() -> None:
    pages = (CAMPAIGNS.parent / "docs" / "results").glob("*.md")
    marks = [
        mark
        for page in pages
        for mark in re.findall(
            r"(?s)<!-- study: (\w+) -->\n.*?<!-- end of study -->",
            page.read_text(encoding="utf-8"),
        )
    ]
    assert sorted(marks) == sorted(PARTS)
