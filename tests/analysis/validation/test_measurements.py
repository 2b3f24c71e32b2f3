# SPDX-License-Identifier: Apache-2.0
"""Tables of measurements are read with their units, and all problems are
reported together with their lines."""

from __future__ import annotations

import math
import tomllib
from datetime import date, time
from pathlib import Path

import pytest
from real_program import CAMPAIGNS

import ideotype
from ideotype.validation.comparison import Conditions
from ideotype.validation.quantities import Seen
from ideotype.validation.table import Measurement, factor_to, read_table


def test_a_table_is_read(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_text(
        "# by hand\n"
        "date, hour, quantity, height, position, value, error, unit,"
        " spacing.density\n"
        "2025-07-01, 12:20-14:20, light, 0.4, 0.38, 35, 2, %, 7.5\n"
        ",,lai,,,4.1,,m2 m-2,\n"
    )
    first, second = read_table(path)
    assert first.date == date(2025, 7, 1)
    assert first.hours == (time(12, 20), time(14, 20))
    assert (first.height, first.position) == (0.4, 0.38)
    assert (first.low, first.high, first.error) == (35, 35, 2)
    assert first.keys == {"spacing.density": 7.5}
    assert first.where == f"{path}:3"
    assert second.date is second.hours is None and not second.keys
    assert math.isnan(second.error) and second.value == 4.1


@pytest.mark.parametrize(
    ("unit", "to", "factor"),
    (
        ("%", "1", 0.01),
        ("kg/ha", "t ha-1", 1e-3),
        ("g m-2", "t ha-1", 1e-2),
        ("µmol/m²/s", "mol m-2 day-1", 0.0864),
        ("MJ m^-2 d^-1", "MJ m-2 day-1", 1.0),
        ("cm", "m", 0.01),
        ("", "1", 1.0),
    ),
)
def test_units_are_read_in_many_spellings(
    unit: str, to: str, factor: float
) -> None:
    assert factor_to(unit, to) == pytest.approx(factor, rel=1e-12)


def test_units_of_other_dimensions_are_refused() -> None:
    with pytest.raises(ideotype.Error, match="kg ha-1.*cannot be read as"):
        factor_to("kg ha-1", "m")


def test_all_problems_of_a_table_are_reported(tmp_path: Path) -> None:
    path = tmp_path / "bad.csv"
    path.write_text(
        "date,hours,quantity,value,low,error,unit\n"
        "1 May,,lai,4,,,1\n"
        "2025-05-01,,,x,,,1\n"
        "2025-05-01,,lai,4,3,-1,1\n"
        "2025-05-01,,lai,4\n"
        "2025-05-01,,lai,inf,,,parsec2 parsec\n"
    )
    with pytest.raises(ideotype.Error) as found:
        read_table(path)
    problems = str(found.value).splitlines()
    for line, words in (
        (1, "there is no column 'hours'; did you mean 'hour'"),
        (2, "date is '1 May'; write it as 2025-08-07"),
        (3, "value is 'x'; give a finite number"),
        (3, "quantity is empty"),
        (4, "error is -1; give 0 or more"),
        (4, "a value or a range"),
        (5, "this row has 4 cells and the table 7 columns"),
        (6, "value is 'inf'; give a finite number"),
    ):
        assert any(
            problem.startswith(f"{path}:{line}: ") and words in problem
            for problem in problems
        ), (line, words, problems)


def test_devices_and_empty_files_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ideotype.Error, match="no regular file"):
        read_table(Path("/dev/zero"))
    (path := tmp_path / "empty.csv").write_text("# nothing\n")
    with pytest.raises(ideotype.Error, match="this file is empty"):
        read_table(path)


def test_a_row_with_an_hour_has_the_rate_of_that_hour() -> None:
    """The rates of two hours add up to that of both."""
    fast = {"light.tolerance": 0, "light.paths": 256, "field.rows": 1,
            "field.plants": 1}  # fmt: skip
    conditions = Conditions(CAMPAIGNS / "ames_quick.toml", 2, False)

    def rate(begin: int, end: int) -> float:
        row = Measurement(
            "gross_assimilation", "mol m-2 day-1", 1, 1, 1,
            hours=(time(begin), time(end)),
        )  # fmt: skip
        keys = {"photosynthesis.model": "hyperbola", **fast}
        settings = conditions.settings({**keys, **conditions.keys(row)})
        return conditions.values(settings, [row], 1)[0]

    both, first, second = rate(11, 13), rate(11, 12), rate(12, 13)
    assert both == pytest.approx((first + second) / 2, rel=0.05)
    # A rate, not the amount of one hour.
    assert first > 2


def test_the_photon_flux_above_the_canopy_is_that_of_the_sky() -> None:
    conditions = Conditions(CAMPAIGNS / "ames_quick.toml", 2, False)
    row = Measurement("ppfd", "umol m-2 s-1", 1, 1, 1, height=4.0,
                      hours=(time(12), time(13)))  # fmt: skip
    settings = conditions.settings(conditions.keys(row))
    seen = Seen(conditions.stand(settings, 1))
    (flux,) = conditions.values(settings, [row], 1)
    incident = seen.number("incident") * 1e6 / 3600
    assert flux == pytest.approx(4.57 * incident, rel=0.02)


def test_angles_of_a_rank_and_of_its_third_agree() -> None:
    conditions = Conditions(CAMPAIGNS / "ames_quick.toml", 2, False)
    count = len(
        tomllib.loads((CAMPAIGNS / "crops/maize.toml").read_text())["leaf"]
    )
    names = [str(rank) for rank in range(1, count + 1)]
    rows = [
        Measurement("inclination", "deg", 1, 1, 1, leaves=name)
        for name in ["", *names]
    ]
    whole, *ranks = conditions.values(conditions.settings({}), rows, 1)
    assert min(ranks) < whole < max(ranks)
    assert len(set(ranks)) == count
