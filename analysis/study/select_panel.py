#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Computes by which traits, and how fast, 281 inbred lines approach an
ideotype.

select_panel.py FOLDER [--only carbon|grain|faults] [--evaluations N]
                [--figure FILE.png] [--rough]

Lines with the means and covariances of campaigns/lines/maize_panel.toml stand
at 7 and 12 plants m-2 in the season of quickstart.toml (net carbon balance),
and in growing_season.toml (grain of 2011), where the lines vary around the
hybrid of the campaign instead of around their own mean. 40 lines are tested
in nine plots each and four are selected, for five cycles: by yield
(heritability of a plot 0.12, of the mean 0.55), by the index of the gradient,
and by genomic prediction. SIZES are the numbers of programmes. A search over
both densities gives the ideotype. Prints one table for each question;
--figure draws the gain of lines against the cycle. `faults` prints the
messages for a made trial of 40 lines with faults. ± is half of a 95 %
interval. --rough is for tests.
"""

from __future__ import annotations

import argparse
import resource
import shutil
import tomllib
from dataclasses import replace
from pathlib import Path
from time import process_time

import pandas as pd
from estimates import plus_minus, print_table
from shared import (
    CAMPAIGNS,
    breed,
    guard,
    parser_of_searches,
    run_parts,
    say,
)

import ideotype
from ideotype.common.settings import format_settings
from ideotype.selection import (
    Field,
    Options,
    Plan,
    Selection,
    Store,
    make_trial,
    read_lines,
    read_trial,
    select,
    write_selection,
)

PANEL = CAMPAIGNS / "lines/maize_panel.toml"
LINES = 281
#: Plants m-2, in rows of 30 inches.
DENSITIES = (7, 12)
#: The numbers of programmes of each method, and of draws at the mean of each
#: cycle. Growing seasons are thinned: each evaluation takes four times as long.
SIZES = {"carbon": (5, 4), "grain": (5, 2)}
PLAN = Plan(cycles=5, lines=40, parents=4, crosses=4, plots=9, untested=40)


def campaign_of(goal: str) -> tuple[Path, list[str]]:
    """Returns the campaign of an objective, and its keys."""
    entries = ",".join(f"{{row=0.762,density={x}}}" for x in DENSITIES)
    spacings = f"spacing=[{entries}]"
    if goal == "carbon":
        return CAMPAIGNS / "quickstart.toml", [spacings]
    campaign = CAMPAIGNS / "growing_season.toml"
    table = ideotype.Stand.from_campaign(campaign).campaign
    years = tomllib.loads(table)["climate"]
    keys = format_settings({"climate": years[:1]})
    return campaign, [
        spacings, *keys, "objective.maximise=grain_yield", "objective.over=[]",
    ]  # fmt: skip


def ideotype_of(
    goal: str, campaign: Path, keys: list[str], options: argparse.Namespace
) -> Path:
    """Returns the history of a search for the mean over both densities."""
    settings = [
        *keys,
        'objective.over=["spacing"]',
        "replicates=1",
        "search={}",
        f"stop={{evaluations={96 if options.rough else options.evaluations}}}",
    ]
    return breed(campaign, f"select_{goal}", settings, options.folder)[0]


def study(goal: str, options: argparse.Namespace) -> None:
    campaign, keys = campaign_of(goal)
    before = process_time()
    history = ideotype_of(goal, campaign, keys, options)
    lines = read_lines(PANEL, count=LINES)
    folder = options.folder / f"selection_{goal}"
    folder.mkdir(exist_ok=True)
    plan, draws = PLAN, 16
    repeats, line_draws = SIZES[goal]
    if options.rough:
        plan = Plan(cycles=1, lines=12, parents=3, crosses=3, untested=3)
        repeats, draws, line_draws = 1, 2, 1
    store = Store(folder / "evaluations.sqlite", f"{goal} {options.rough}")
    field = Field(campaign, lines.traits, settings=keys, store=store)
    if goal == "grain":
        lines = replace(lines, mean=field.plant)
    done = select(
        lines,
        field,
        Options(
            plan=plan, repeats=repeats, draws=draws, line_draws=line_draws
        ),
        history=history,
    )
    write_selection(done, folder)
    if options.figure:
        shutil.copyfile(folder / "reach.png", options.figure)
    print_all(goal, done)
    usage = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000
    say(
        f"{len(store)} evaluations, {process_time() - before:.0f} CPU-s "
        f"(without the search), {usage:.0f} MB; tables in {folder}"
    )


def print_all(goal: str, done: Selection) -> None:
    """Prints the tables of a selection."""

    def cell(row: pd.Series, name: str, digits: int = 1) -> str:
        pair = row[name], row[f"{name}_standard_error"]
        return plus_minus(pair, digits)

    response = done.tables["response"]
    places = dict(zip(response["case"], [*map(str, DENSITIES), "mean"]))
    print_table(
        [f"{goal}: plants m-2", "of the mean plant", "index, one cycle [%]",
         "first trait", "first in draws"],
        [
            [
                places[row["case"]], cell(row, "objective", 3),
                cell(row, "gain"), str(row["first_trait"]),
                f"{row['first_probability']:.0%}",
            ]
            for _, row in response.iterrows()
        ],
    )  # fmt: skip
    print()
    index = done.tables["index"]
    print_table(
        [f"{goal}: trait",
         *(f"economic weight, {x} [% per unit]" for x in places.values()),
         "response to one cycle", "this trait alone [%]"],
        [
            [
                f"{trait} [{rows['unit'].iloc[0]}]",
                *(cell(row, "economic_weight", 2)
                  for _, row in rows.iterrows()),
                cell(rows.iloc[-1], "response"),
                cell(rows.iloc[-1], "single_gain"),
            ]
            for trait, rows in index.groupby("trait", sort=False)
        ],
    )  # fmt: skip
    print()
    programme = done.tables["programme"]
    print_table(
        [f"{goal} [%]: selection by",
         *(f"cycle {x}" for x in range(1, PLAN.cycles + 1)),
         "ideotype", "cycles to half", "variance left"],
        [
            [
                method,
                *(cell(row, "gain") for _, row in rows[1:].iterrows()),
                plus_minus((reach.ceiling, reach.ceiling_standard_error)),
                f"{reach.half_cycles:.1f}",
                f"{rows['variance'].iloc[-1]:.2f}",
            ]
            for method, reach in done.reaches.items()
            for rows in [programme[programme["method"] == method]]
        ],
    )  # fmt: skip
    print()
    print_table(
        [f"{goal}: trait", "mean of lines", "after the index",
         "difference [sd]"],
        [
            [
                f"{row.trait} [{row.unit}]", f"{row.now:.1f}",
                f"{row.target:.1f}", f"{row.distance:+.1f}",
            ]
            for row in done.tables["targets"].itertuples()
        ],
    )  # fmt: skip
    missed = programme["mean_plant_approximate"] - programme["mean_plant"]
    print(
        f"\nMean plants of all cycles: the quadratic approximation misses "
        f"traced light by up to {missed.abs().max():.1f} points."
    )


def carbon(options: argparse.Namespace) -> None:
    study("carbon", options)


def grain(options: argparse.Namespace) -> None:
    study("grain", options)


def faults(options: argparse.Namespace) -> None:
    """Prints the messages for a trial with faults."""
    path = options.folder / "faults.csv"
    table = make_trial(read_lines(PANEL), 40, 2, 1).astype(object)
    table.loc[3, "middle leaf length [cm]"] = "71,5"
    table.loc[8, "plant height [cm]"] = 1.42
    table.loc[12, "middle leaf width [cm]"] = "narrow"
    table.loc[20, "line"] = table.loc[20, "line"].upper()
    table.loc[30, "line"] = ""
    table.loc[41, "upper leaf angle [deg]"] = "NA"
    doubled = pd.concat([table, table.iloc[[5]]])
    names = {"middle leaf width [cm]": "leaf widht [cm]",
             "middle leaf angle [deg]": "middle leaf angle [degC]",
             "tassel length [cm]": "tassel length"}  # fmt: skip
    doubled.rename(columns=names).to_csv(path, index=False)
    try:
        read_trial(path)
    except ideotype.Error as error:
        print(str(error).replace(f"{options.folder}/", ""))


def main() -> None:
    parser = parser_of_searches(__doc__, has_figure=True, evaluations=720)
    run_parts(parser, {"carbon": carbon, "grain": grain, "faults": faults})


if __name__ == "__main__":
    guard(main)
