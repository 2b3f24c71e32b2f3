# SPDX-License-Identifier: Apache-2.0
"""Intervals of gains include differences between searches, and a plant has the
same value everywhere."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from made_history import MadeHistory

from ideotype.figures.comparison import draw_energy, draw_gains
from ideotype.figures.convergence import draw_convergence
from ideotype.figures.places import draw_latitudes
from ideotype.history import Estimate
from ideotype.history.estimate import NORMAL
from ideotype.history.interval import (
    BEYOND,
    ONE_SEED,
    SEARCH_SCATTER,
    gain_interval,
    interval,
)
from ideotype.history.study import open_study
from ideotype.report import tables
from ideotype.report.answer import make_answer
from ideotype.report.tables import (
    SCREEN,
    format_markdown,
    tabulate_gains,
    tabulate_screen,
)


def make(
    path: Path,
    **place: str | float,
) -> None:
    """Makes a finished history of one generation."""
    place = {"case": path.stem, "campaign": "made", **place}
    made = MadeHistory(path, attributes=place)
    made.evolve(1)
    made.finish()
    made.close()


@pytest.mark.parametrize("seeds", [(1, 1), (2, 2), (1, 2)])
def test_intervals_of_gains_include_the_scatter_between_searches(
    tmp_path: Path, seeds: tuple[int, int]
) -> None:
    """For a single search the scatter is assumed from other searches, and the
    text states this."""
    place = (("ames", 42.0), ("edmonton", 53.5))
    for (site, latitude), count in zip(place, seeds):
        for seed in range(1, count + 1):
            name = f"{site}_r{seed}"
            attributes = {"site": site, "latitude": latitude, "case": name}
            make(tmp_path / f"{name}.h5", **attributes)
    with open_study(tmp_path) as study:
        cases = study.cases()
        table, *_ = tabulate_gains(cases, None)
        facts = make_answer(cases).uncertainty
        results = study.results()
        pairs = [case.pairs for case in cases]
        drawn = [
            segment
            for group in draw_gains(cases).axes[0].containers
            for segment in group.lines[2][0].get_segments()
        ]
    said = (
        " ".join(table.caption.split()),
        " ".join(fact.value for fact in facts).replace("\u00a0", " "),
    )
    for text in said:
        assert (ONE_SEED in text) == (1 in seeds)
    assert ("over searches" in said[0]) == (2 in seeds)
    for k, case_pairs in enumerate(pairs):
        low, high = results.gain_percent_low[k], results.gain_percent_high[k]
        assert drawn[k][:, 0] == pytest.approx((low, high))
        mean = results.gain_percent[k]
        light = NORMAL * case_pairs[0].gain.standard_error
        if len(case_pairs) == 1:
            search = NORMAL * SEARCH_SCATTER * case_pairs[0].gain.mean
            assert mean - low == pytest.approx(np.hypot(light, search))
        else:
            assert mean - low >= light / np.sqrt(len(case_pairs))
        assert high - mean == pytest.approx(max(mean - low, BEYOND * mean))


@pytest.mark.parametrize(("sign", "least"), [(1, "above"), (-1, "below")])
def test_equal_searches_do_not_exclude_a_better_optimum(
    sign: int, least: str
) -> None:
    gains = [Estimate(sign * 10.0, 0.1, "%")] * 3
    gain = gain_interval(gains, sign)
    light = NORMAL * 0.1 / np.sqrt(3)
    other = "below" if least == "above" else "above"
    assert getattr(gain, least) == pytest.approx(10 * BEYOND)
    assert getattr(gain, other) == pytest.approx(light)
    ends = f"{gain.below:.2f}", f"{gain.above:.2f}"
    assert gain.number() == f"{sign * 10:.2f} −{ends[0]} +{ends[1]}"
    assert gain.is_sure
    # If searches differ more, the interval extends equally far above and below
    # the mean.
    apart = gain_interval([Estimate(x, 0.1, "%") for x in (5.0, 15.0)], sign)
    assert apart.below == apart.above and not apart.is_sure


def test_the_best_plant_has_the_same_number_everywhere(tmp_path: Path) -> None:
    """Each seed evaluates the same baseline with different noise."""
    for seed, shift in enumerate((0.0, 0.1, 0.2), start=1):
        for latitude in (10.0, 20.0):
            made = MadeHistory(
                tmp_path / f"{latitude}_{seed}.h5",
                attributes={
                    "case": f"{latitude:.0f}_r{seed}", "latitude": latitude,
                },
                shift=shift,
                baseline_shift=shift / 7,
            )  # fmt: skip
            made.evolve(1)
            made.finish()
            made.close()
    with open_study(tmp_path) as study:
        cases = study.cases()
        for case in cases:
            case.remember()
        results = study.results()
        table, *_ = tabulate_gains(cases, None)
        upper, _ = draw_latitudes(cases).axes
        energy = draw_energy(cases).axes[0]
        line = draw_convergence(cases[0]).axes[0].lines
    (level,) = [x for x in line if x.get_label() == "baseline"]
    assert level.get_ydata()[0] == results.baseline[0]
    for who, column in (("baseline", 4), ("best", 5)):
        (drawn,) = [
            group.lines[0].get_ydata()
            for group in upper.containers
            if str(group.get_label()).endswith(who)
        ]
        assert [*drawn] == [*results[who]]
        cells = [row[column].split("\u00a0")[0] for row in table.rows]
        assert cells == [
            getattr(case, who).objective.interval_text().split()[0]
            for case in cases
        ]
    leaves = [x for x in energy.containers if x.get_label() == "leaves"]
    widths = [x.patches[0].get_width() for x in leaves]
    assert widths == [
        getattr(case, who).estimate("absorbed_fraction").mean
        for case in cases
        for who in ("baseline", "best")
    ]


def test_the_interval_of_several_seeds_is_from_their_scatter() -> None:
    """The gains are those of four searches; their standard errors include only
    the noise of the light."""
    gains = [
        Estimate(mean, error, "%")
        for mean, error in (
            *((2.71, 0.16), (4.57, 0.24)),
            *((2.81, 0.26), (4.41, 0.16)),
        )
    ]
    gain = interval(gains)
    # The interval is Student's t with three degrees of freedom.
    scatter = np.std([x.mean for x in gains], ddof=1) / 2
    assert gain.below == pytest.approx(3.1824 * scatter, rel=1e-4)
    assert str(gain) == "3.6 ± 1.6 %"
    # If seeds agree by chance, the interval is that of the noise of the light.
    alike = interval([Estimate(3.0, 0.2), Estimate(3.0, 0.2)])
    assert alike.below == pytest.approx(1.96 * 0.2 / 2**0.5)


def test_the_summary_shows_the_largest_and_smallest_gains(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    few, count = 6, 10
    monkeypatch.setattr(tables, "SCREEN", few)
    for k in range(count):
        made = MadeHistory(
            tmp_path / f"lat{k}.h5",
            attributes={"case": f"lat{k}_r1", "latitude": float(k)},
            shift=0.01 * (k * 7 % count),
        )
        made.evolve(1)
        made.finish()
        made.close()
    with open_study(tmp_path) as study:
        cases = study.cases()
        text = format_markdown(tabulate_screen(cases))
        all_of_them = format_markdown(tabulate_screen(cases[:few]))
        ranked = sorted(cases, key=lambda case: -case.relative_gain().mean)
    lines = [x for x in text.splitlines() if x.startswith("| lat")]
    assert len(text.splitlines()) - few + SCREEN < 24 and len(lines) == few
    half = few // 2
    expected = [*ranked[:half], *ranked[-half:]]
    assert [x.split()[1] for x in lines] == [case.name for case in expected]
    assert f"{few} of {count} cases" in text and "--all" in text
    assert all_of_them.count("\n| lat") == few
    assert "--all" not in all_of_them
