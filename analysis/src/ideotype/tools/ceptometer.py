# SPDX-License-Identifier: Apache-2.0
"""`ideotype ceptometer CAMPAIGN TABLE` compares light that was measured in a
field with the light that the program computes."""

from __future__ import annotations

import argparse
import json
import re
import sys
import tomllib
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd

from ..common.arrays import read_columns
from ..common.output import (
    REFUSED,
    OutputRefused,
    figure_path,
    require_output,
    save_figure,
)
from ..errors import Error, printable_lines
from ..history.estimate import NORMAL
from ..history.interval import student
from ..stand.stand import Stand

_UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001}


def _column(table: pd.DataFrame, name: str) -> pd.Series | None:
    """Returns the column with the given name and a unit of length at its end,
    in m."""
    for unit, factor in _UNITS.items():
        if f"{name}_{unit}" in table:
            return table[f"{name}_{unit}"].astype(float) * factor
    return None


def _hour(text: object) -> float:
    """Returns the hour that `13.5` or `13:30` denotes."""
    if match := re.fullmatch(r"\s*(\d{1,2}):(\d\d)(?::\d\d)?\s*", str(text)):
        return int(match[1]) + int(match[2]) / 60
    return float(str(text))


def read_table(path: Path) -> pd.DataFrame:
    """Reads measurements of a ceptometer, with columns height [m], position
    [m, NaN: mean across the row], hour [h, NaN: the whole day] and measured,
    the fraction of the light above the canopy.

    Raises Error with the line that cannot be read."""
    table = read_columns(path)
    found = pd.DataFrame(index=table.index)
    try:
        height = _column(table, "height")
        if height is None:
            raise Error(
                f"{path}:1: there is no column of the height above the soil; "
                "add height_cm or height_m"
            )
        found["height"] = height
        position = _column(table, "position")
        found["position"] = np.nan if position is None else position
        found["hour"] = table["hour"].map(_hour) if "hour" in table else np.nan
        if "fraction" in table:
            found["measured"] = table["fraction"].astype(float)
        elif "percent" in table:
            found["measured"] = table["percent"].astype(float) / 100
        elif {"below", "above"} <= set(table):
            found["measured"] = table["below"] / table["above"]
        else:
            raise Error(
                f"{path}:1: there is no column of the light; add fraction "
                "or percent of the light above the canopy, or below and above"
            )
    except ValueError as error:
        raise Error(f"{path}: a number cannot be read ({error})") from None
    bad = found.index[
        ~found.measured.between(0, 1.2) | ~found.height.between(0, 10)
    ]
    if len(bad):
        raise Error(
            f"{path}: row {bad[0] + 1} of the table has the height "
            f"{found.height[bad[0]]:g} m and the fraction "
            f"{found.measured[bad[0]]:g}; heights are 0 to 10 m, and "
            "fractions at most 1.2 of the light above the canopy"
        )
    return found


def compare(stand: Stand, table: pd.DataFrame) -> pd.DataFrame:
    """Returns the table with two more columns: `model`, the light that the
    baseline of a stand transmits, and `model_standard_error`."""
    sensors = table[["height", "position"]].drop_duplicates()
    found = stand.light_at(stand.baseline, sensors.height, sensors.position)
    hours = found.hour.to_numpy()
    weights = found.incident.to_numpy()
    columns: dict[str, list[float]] = {"model": [], "model_standard_error": []}
    for each in table.itertuples():
        place = (sensors.height == each.height) & (
            (sensors.position == each.position)
            | (sensors.position.isna() & np.isnan(each.position))
        )
        here = found.isel(sensor=int(np.flatnonzero(place)[0]))
        for to, name in zip(
            columns.values(), ("fraction", "fraction_standard_error")
        ):
            by_hour = here[name].to_numpy()
            if np.isnan(each.hour):
                to.append(np.average(by_hour, weights=weights))
            elif hours[0] <= each.hour <= hours[-1]:
                to.append(np.interp(each.hour, hours, by_hour))
            else:
                raise Error(
                    f"hour {each.hour:g} of the table is not in the day of the "
                    f"campaign, {hours[0]:g} to {hours[-1]:g} h; see [[day]]"
                )
    return table.assign(**columns)


def _choice_of_day(stand: Stand) -> str:
    """Returns the words that choose one of several days."""
    if "climate" in tomllib.loads(stand.campaign):
        return (
            "--set climate.from=DATE --set climate.to=DATE, or give the "
            "campaign a [[day]] if it was clear"
        )
    return "--set day.date=DATE"


def days_of(stand: Stand) -> int:
    """Returns the number of days over which a stand averages its light."""
    return len(stand.axes.get("day", [0]))


def agreement(found: pd.DataFrame) -> dict[str, float | None]:
    """Returns the mean difference of the model from the measurements and its
    standard error, the root of the mean square of the differences, and the
    correlation; None for numbers that so few rows do not have."""
    apart = found.model - found.measured
    several = len(apart) > 1

    def known(value: float) -> float | None:
        return float(value) if np.isfinite(value) else None

    return {
        "rows": len(apart),
        "bias": float(apart.mean()),
        "bias_standard_error": known(apart.sem()) if several else None,
        "rms": float(np.sqrt((apart**2).mean())),
        "correlation": known(_correlation(found)) if several else None,
    }


def _correlation(found: pd.DataFrame) -> float:
    with np.errstate(invalid="ignore", divide="ignore"):
        return float(found.model.corr(found.measured))


def page_of(stand: Stand, found: pd.DataFrame) -> str:
    """Returns the table and the agreement of a stand as text."""
    rows = [["height [m]", "position [m]", "time", "measured", "model"]]
    for each in found.itertuples():
        half_width = NORMAL * each.model_standard_error
        minutes = 0 if np.isnan(each.hour) else round(60 * each.hour)
        rows.append(
            [
                f"{each.height:.2f}",
                "mean" if np.isnan(each.position) else f"{each.position:.2f}",
                "whole day"
                if np.isnan(each.hour)
                else f"{minutes // 60}:{minutes % 60:02}",
                f"{each.measured:.3f}",
                f"{each.model:.3f} ± {half_width:.3f}",
            ]
        )
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = [
        "  ".join(x.rjust(width) for x, width in zip(row, widths))
        for row in rows
    ]
    return "\n".join([*lines, "", *_sentences(stand, found)])


def _sentences(stand: Stand, found: pd.DataFrame) -> list[str]:
    known = agreement(found)
    count = len(found)
    bias = f"model − measured: {known['bias']:+.3f}"
    if (error := known["bias_standard_error"]) is not None:
        bias += f" ± {student(count - 1) * error:.3f}"
    parts = [bias, f"root mean square {known['rms']:.3f}"]
    if (correlation := known["correlation"]) is not None:
        parts.append(f"correlation {correlation:.2f}")
    parts.append(f"{count} row{'s' if count > 1 else ''}")
    lines = [
        ", ".join(parts),
        "Light is a fraction of that above the canopy; ± is half of a 95 % "
        "confidence interval.",
    ]
    if (days := days_of(stand)) > 1:
        lines.append(
            f"The model has the mean light of {days} days. For the day of the "
            f"measurement add {_choice_of_day(stand)}."
        )
    return lines


def draw(found: pd.DataFrame, path: Path) -> None:
    """Draws computed against measured light, coloured by height."""
    from ..figures.style import new_figure

    figure = new_figure(6, 5)
    axes = figure.add_subplot()
    points = axes.scatter(
        found.measured, found.model, c=found.height, cmap="viridis", zorder=3
    )
    axes.errorbar(
        found.measured, found.model, NORMAL * found.model_standard_error,
        fmt="none", color="0.6",
    )  # fmt: skip
    limit = 1.05 * max(found.measured.max(), found.model.max())
    axes.plot([0, limit], [0, limit], color="0.5", linewidth=1)
    axes.set(
        title="Light among the plants, as a fraction of that above",
        xlabel="measured fraction",
        ylabel="fraction of the model, with 95 % confidence intervals",
    )
    figure.colorbar(points, label="height above the soil [m]")
    save_figure(figure, path)


def main(arguments: Sequence[str] | None = None) -> int:
    """Compares, prints and returns the exit code: 0, 1 if the figure cannot be
    written, 2 for a wrong command line, 3 for a wrong campaign or table, 4 for
    a figure that is a symbolic link."""
    parser = argparse.ArgumentParser(
        prog="ideotype ceptometer",
        description="Compares light that was measured in a field with the "
        "light that the baseline of a campaign transmits. The table has "
        "columns height_cm (or height_m), position_cm across the row from a "
        "row, hour on the clock of the site, and fraction (or percent, or "
        "below and above); without position it is a mean across the row, and "
        "without hour a mean of the day.",
    )
    add = parser.add_argument
    add("campaign", type=Path, metavar="CAMPAIGN", help="a TOML file")
    add("table", type=Path, metavar="TABLE", help="a CSV file")
    add("--set", action="append", default=[], metavar="KEY=VALUE")
    add("--case", type=int, default=0, metavar="N", help="of `check --cases`")
    add("--json", action="store_true", help="print JSON instead of text")
    add(
        "--figure", type=figure_path, metavar="FILE",
        help="PNG, PDF or SVG to draw",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    try:
        if options.figure:
            require_output(options.figure)
        table = read_table(options.table)
        stand = Stand.from_campaign(
            options.campaign, case=options.case, settings=options.set
        )
        found = compare(stand, table)
    except OutputRefused as error:
        return _fail(REFUSED, error)
    except Error as error:
        return _fail(3, error)
    if options.json:
        rows = json.loads(found.to_json(orient="records"))
        about = {**agreement(found), "days": days_of(stand)}
        print(json.dumps({**about, "table": rows}, indent=1))
    else:
        print(page_of(stand, found))
    if options.figure:
        try:
            draw(found, options.figure)
        except (OutputRefused, OSError) as error:
            return _fail(
                REFUSED if isinstance(error, OutputRefused) else 1, error
            )
    return 0


def _fail(code: int, error: Exception) -> int:
    print(printable_lines(f"ideotype ceptometer: {error}"), file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
