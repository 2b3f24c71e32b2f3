# SPDX-License-Identifier: Apache-2.0
"""Axes, bars and tables of a report are legible."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from made_history import MadeHistory
from made_kinds import Measured
from made_report import Made
from matplotlib.container import ErrorbarContainer
from phone import WIDTH, phone_with

import ideotype
from ideotype.figures.comparison import draw_energy
from ideotype.figures.profiles import draw_layers
from ideotype.history import open_history, open_study
from ideotype.history.state import State
from ideotype.report.programme import describe_reach, tabulate_reach
from ideotype.tools.commands import report


def test_the_axis_of_height_ends_above_the_plants(tmp_path: Path) -> None:
    heights = np.arange(0.125, 5.0, 0.25)
    parts = np.where(heights < 2.6, 0.1, 0.0)
    made = MadeHistory(
        tmp_path / "case.h5",
        extra={
            "absorbed_by_layer": (Measured("MJ m-2 day-1", "layer"), parts)
        },
        labels={"layer": heights},
    )
    made.evolve(1)
    made.finish()
    made.close()
    with open_study(tmp_path) as study:
        (axes,) = draw_layers(study.cases()[0]).axes
    assert axes.get_ylim() == pytest.approx((0, 2.625))


def test_highest_layers_lie_within_the_axis(sweep: Path) -> None:
    with open_study(sweep) as study:
        (axes,) = draw_layers(study.cases()[0]).axes
    assert axes.get_ylim() == pytest.approx((0, 0.75 + 0.375))


def test_short_intervals_are_not_drawn_on_parts_of_the_light(
    finished: Path,
) -> None:
    with open_study(finished) as study:
        (axes,) = draw_energy(study.cases()).axes
    assert not [x for x in axes.containers if isinstance(x, ErrorbarContainer)]


@pytest.mark.parametrize(
    ("reason", "text"),
    [
        ("generations", "finished (reached stop.generations)"),
        ("room", "finished (reached stop.generations)"),
        ("evaluations", "finished (reached stop.evaluations)"),
        ("unheard of", "finished (unheard of)"),
    ],
)
def test_the_reason_of_an_end_is_in_words(
    finished: Path, reason: str, text: str
) -> None:
    with open_history(finished) as history:
        writer = history.state().writer
    assert str(State(writer, True, reason, 1.0)) == text


def test_tables_of_the_origin_fit_on_a_phone(
    made: Made, tmp_path: Path
) -> None:
    cut = """
      [...document.querySelectorAll(".table")]
        .map((table) => [table, table.querySelector("caption")?.textContent])
        .filter(([table, caption]) =>
          ["Histories", "Sessions"].includes(caption))
        .map(([table]) => table.scrollWidth > table.clientWidth)
    """
    with phone_with(made.page, tmp_path, WIDTH) as phone:
        phone.value(
            "document.querySelectorAll('details:not(.listing)')"
            ".forEach((part) => { part.open = true; })"
        )
        assert phone.value(cut) == [False, False]
        right = "(e) => e.getBoundingClientRect().right"
        assert (
            phone.value(
                "Math.max(...[...document.querySelectorAll("
                f"'table.wide td')].map({right}))"
            )
            <= WIDTH
        )


def test_the_programme_of_a_selection_is_a_section(
    finished: Path, tmp_path: Path
) -> None:
    words = ["-o", str(tmp_path / "report"), "-j", "1", "--no-split"]
    words += ["--figures", "", "--selection", str(tmp_path)]
    reach = tmp_path / "reach.csv"
    reach.write_text("method,cycles\nindex,5\n")
    with pytest.raises(ideotype.Error, match="no column 'ceiling'"):
        tabulate_reach(tmp_path)
    reach.write_text(
        "method,ceiling,ceiling_standard_error,gain,gain_standard_error,"
        "cycles,half_cycles\n"
        "index,8,0.5,3.1,0.1,5,\nyield,8,0.5,6.2,0.1,5,2.25\n"
    )
    table = tabulate_reach(tmp_path)
    assert table.rows == [
        ["index", "5", "3.10 ± 0.20", "8.00 ± 0.98", "-"],
        ["yield", "5", "6.20 ± 0.20", "8.00 ± 0.98", "2.2"],
    ]
    assert describe_reach(tmp_path).startswith(
        "Selection of measured lines by index gains 3.10 ± 0.20 % in 5 cycles; "
        "the ideotype gains 8.00 ± 0.98 %. Selection of measured lines by yield"
    )
    assert report([str(finished), *words]) == 0
    page = (tmp_path / "report/report.html").read_text()
    assert "Breeding programme" in page and "6.20 ± 0.20" in page
