# SPDX-License-Identifier: Apache-2.0
"""The numbers of analysis/study have 95 % intervals and are compared by means
of them."""

from __future__ import annotations

import importlib
import re
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from real_program import CAMPAIGNS
from short_study import make_tables

STUDY = CAMPAIGNS.parent / "analysis" / "study"
PAGES = sorted((CAMPAIGNS.parent / "docs" / "results").glob("*.md"))
RESULTS = "\n".join(page.read_text(encoding="utf-8") for page in PAGES)


def module(name: str, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(STUDY)
    return importlib.import_module(name)


def test_95_of_100_printed_intervals_contain_the_truth(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    estimates = module("estimates", monkeypatch)
    draws = np.random.default_rng(1).normal(7.0, 1.0, (2000, 64))
    printed = [
        estimates.plus_minus(estimates.estimate(x), 4) for x in draws.tolist()
    ]
    hits = sum(
        abs(float(mean) - 7) < float(half)
        for mean, half in (text.split(" ± ") for text in printed)
    )
    # The tolerance is four standard errors of a frequency of 0.95.
    assert abs(hits / 2000 - 0.95) < 4 * np.sqrt(0.95 * 0.05 / 2000)


def test_gains_over_a_loss_are_differences(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """In per cent of a loss, a plant with a smaller loss would appear
    worse."""
    estimates = module("estimates", monkeypatch)
    erect_tops = module("erect_tops", monkeypatch)
    flat, erect = [-0.16, -0.15, -0.16], [-0.06, -0.05, -0.05]
    assert estimates.gain(flat, erect)[0] < 0
    assert not estimates.has_percent(flat)
    assert not estimates.has_percent([0.01, -0.02, 0.02])
    assert estimates.has_percent([0.16, 0.15, 0.16])

    over_loss = erect_tops.gains([(flat, erect)])
    assert over_loss.is_positive and not over_loss.percents
    assert re.fullmatch(r"\+0\.103 ± 0\.\d+ mol", over_loss.text())
    over_gain = erect_tops.gains([([1.0, 1.1], [1.2, 1.32])])
    assert over_gain.text().startswith("+20.0 ±")


def test_intervals_may_differ_in_the_last_digit_only(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    agree = module("study", monkeypatch).agree
    row = "| sizes | +2.38 ± 0.49 | 12 ± 3 |"
    assert agree(row, row)
    assert agree(row, "| sizes | +2.38 ± 0.50 | 12 ± 2 |")
    assert not agree(row, "| sizes | +2.38 ± 0.51 | 12 ± 3 |")
    assert not agree(row, "| sizes | +2.38 ± 0.5 | 12 ± 3 |")
    assert not agree(row, "| sizes | +2.39 ± 0.49 | 12 ± 3 |")
    assert not agree(row, "| sizes | -2.38 ± 0.49 | 12 ± 3 |")
    assert not agree(row, "| sizes | +2.38 ± 0.49 | 12 ± 3 | 1 ± 1 |")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_documents_have_one_meaning_of_plus_minus(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    assert "± is half of a 95 % confidence" in " ".join(text.split())
    assert not re.search(
        r"±[^.|]{0,40}standard (error|deviation)", " ".join(text.split())
    )
    assert not re.findall(r"(?m)(?<![\w./\])])\.\d.*", text)


MARKED = r"(?s)<!-- (?:short )?study: \w+ -->\n.*?<!-- end of study -->"
INTERVAL = r"(\d[\d,]*(?:\.\d+)?) ± (\d+(?:\.\d+)?)"
SUMMARIES = ("index", "gains")
"""The pages with a table that quotes tables of the study."""
OTHER_SOURCES = {
    "errata",
    "how_made",
    "organs_and_leaves",
    "searches",
    "costs",
}
"""The pages with numbers that no table of the study has."""


def decimals(number: str) -> int:
    return len(number.partition(".")[2])


def value(number: str) -> float:
    return float(number.replace(",", ""))


def test_texts_quote_numbers_of_their_tables() -> None:
    """A number with an interval in a text must agree with its table, which may
    have more decimals. The last digit of the interval may differ by one."""
    quoted, tabulated = [], []
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        outside = re.sub(MARKED, "", text)
        for table in re.findall(MARKED, text):
            tabulated += re.findall(INTERVAL, table)
        rows = "\n".join(re.findall(r"(?m)^\|.*$", outside))
        if page.stem in SUMMARIES:
            quoted += [
                (page.stem, *pair) for pair in re.findall(INTERVAL, rows)
            ]
        else:
            tabulated += re.findall(INTERVAL, rows)
        prose = re.sub(r"(?m)^\|.*$", "", outside)
        if page.stem not in OTHER_SOURCES:
            quoted += [
                (page.stem, *pair) for pair in re.findall(INTERVAL, prose)
            ]
    numbers = [(value(mean), value(half)) for mean, half in tabulated]
    assert len(quoted) > 50
    for name, mean, half in quoted:
        assert any(
            abs(other - value(mean)) <= 0.501 * 10 ** -decimals(mean)
            and abs(other_half - value(half)) <= 1.001 * 10 ** -decimals(half)
            for other, other_half in numbers
        ), f"{name}: no table has {mean} ± {half}"


def test_each_varied_trait_is_changed_alone_in_both_directions(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    interventions = module("interventions", monkeypatch)
    shared = module("shared", monkeypatch)
    stand = interventions.Stand(shared.campaign_of("quickstart"))
    bred = set(stand.genes.trait[stand.free])
    plants = dict(interventions.changes(stand))
    assert len(plants) == 4 * len(bred)
    for genome in plants.values():
        is_changed = genome != stand.baseline
        assert len(set(stand.genes.trait[is_changed])) == 1
        assert (genome <= stand.genes.upper + 1e-9).all()
        assert (genome >= stand.genes.lower - 1e-9).all()
    is_height = (stand.genes.trait == "height").to_numpy()
    for name, height in {
        "0.7": 0.7,
        "0.85": 0.85,
        "1.15": 1.15,
        "1.3": 1.3,
    }.items():
        found = plants[f"height x {name}"][is_height]
        assert found == pytest.approx([height])

    table = make_tables(tmp_path, ["interventions"])
    cell = r" ([+-]\d+\.\d\d) ± \d+\.\d\d(?: mol)? \|"
    rows = re.findall(
        rf"(?m)^\| (.* (?:x \S+|deg\S*)[^|]*) \|{8 * cell}", table
    )
    assert {row[0] for row in rows[: len(plants)]} == set(plants)
    for row in rows:
        whole, dead, alone, carbon, light, *par = map(float, row[1:9])
        assert carbon == pytest.approx(whole - dead, abs=0.016)
        assert light == pytest.approx(dead - alone, abs=0.016)
        assert par[2] == pytest.approx(par[0] - par[1], abs=0.016)
    assert table.count("| height x 0.7 |") == 2
    assert len(re.findall(r"(?m)^\| [12] \| x \d\.\d\d \|", table)) == 2


def test_leaves_alone_have_no_other_organs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    interventions = module("interventions", monkeypatch)
    shared = module("shared", monkeypatch)
    tables = shared.campaign_of("quickstart", **shared.ROUGH)
    stands = interventions.stands_of(tables, 4)
    names = [each.name for each, _ in stands]
    assert names == ["all_organs", "dead_organs", "leaves_alone"]
    for variant, stand in stands:
        found = interventions.evaluate(stand, [stand.baseline])
        assert found.carbon.shape == found.par.shape == (1, 4)
        assert (found.others[0] > 5) == (variant.name != "leaves_alone")


def test_the_sign_of_the_height_effect_agrees_with_interventions() -> None:
    """Searches cannot show in which direction a change of a single trait
    gains. The text must therefore agree with the table of such changes."""
    table = RESULTS.partition("<!-- study: interventions -->")[2]
    cell = r" (\S+) ± (\S+) \|"
    row = re.search(rf"(?m)^\| height x 0.7 \|{3 * cell}", table)
    assert row is not None
    living, error, dead, of_dead, alone, other = map(float, row.groups())
    assert living > error and dead > of_dead and alone < -other
    assert "Taller plants gain**" not in RESULTS
    text = " ".join(RESULTS.split()).replace("**", "")
    assert (
        "Shorter plants gain with other organs, and lose with leaves alone"
        in text
    )


def test_a_cause_needs_an_intervention(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    study = module("study", monkeypatch)
    found = study.causes_without_intervention
    assert found(STUDY.parents[1] / "docs" / "results") == []

    cause = "# Height\n\nPlants gain because they are short.\n"
    (tmp_path / "height.md").write_text(cause)
    (message,) = found(tmp_path)
    assert 'height.md: "Plants gain because they are short."' in message
    # A page with such a table may be linked from the paragraph.
    table = "\n<!-- intervention: height -->\n\n| height |\n|---|\n"
    (tmp_path / "other.md").write_text(table)
    assert len(found(tmp_path)) == 1
    linked = cause.replace("short.", "short ([table](other.md#height)).")
    (tmp_path / "height.md").write_text(linked)
    assert found(tmp_path) == []
    (tmp_path / "other.md").write_text(table.replace("| height |", "none"))
    assert len(found(tmp_path)) == 1
    (tmp_path / "height.md").write_text(cause + table)
    assert found(tmp_path) == []
