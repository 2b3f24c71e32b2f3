# SPDX-License-Identifier: Apache-2.0
"""Writes a selection: its tables, a figure and a page of text."""

from __future__ import annotations

import math
from pathlib import Path

import pandas as pd

from ..common.labels import words
from ..common.markdown import markdown_table
from ..common.output import save_figure, write_file
from ..history.estimate import Estimate
from .figure import draw_reach
from .genetics import Population
from .index import Advice
from .results import columns_table
from .selection import Selection

FILES = ("selection.md", "columns.csv", "reach.png")
"""The files of a selection in addition to its tables."""

_SHOWN_LINES = 10


def interval(mean: float, standard_error: float) -> str:
    """Returns a mean ± half of its 95 % interval."""
    return Estimate(float(mean), float(standard_error)).interval_text()


def write_selection(
    selection: Selection, folder: Path, taken: pd.DataFrame | None = None
) -> list[Path]:
    """Writes the tables as CSV, their columns, the figure and the page into a
    folder, and returns the paths.

    taken: what the columns of a trial were taken for.

    Raises OutputRefused if a file cannot be replaced."""
    tables = dict(selection.tables)
    if taken is not None:
        tables = {"taken": taken, **tables}
    paths = []
    for name, table in tables.items():
        paths.append(folder / f"{name}.csv")
        write_file(paths[-1], table.to_csv(index=False), folder)
    page, columns, figure = (folder / name for name in FILES)
    write_file(columns, columns_table().to_csv(index=False), folder)
    write_file(page, format_page(selection, taken), folder)
    save_figure(draw_reach(selection), figure)
    return [*paths, page, columns, figure]


def format_taken(taken: pd.DataFrame) -> list[str]:
    """Returns a table of what each column was taken for."""
    return markdown_table(
        ["column", "taken for", "unit", "values", "missing", "note"],
        [[str(x) for x in row] for row in taken.itertuples(index=False)],
    )


def format_page(
    selection: Selection, taken: pd.DataFrame | None = None
) -> str:
    """Returns the page as Markdown: the answer, then tables."""
    population, index = selection.population, selection.index
    goal = words(selection.objective)
    response = selection.tables["response"].iloc[-1]
    lines = [
        "# From these lines to an ideotype",
        "",
        f"One cycle of the index changes {goal} by "
        f"{interval(index.gain, index.gain_standard_error)} % (linear "
        f"response of lines). The most effective single trait is "
        f"{response['first_trait']} (in {response['first_probability']:.0%} of "
        "the draws of errors).",
        "",
    ]
    for method, reach in selection.reaches.items():
        lines += [f"* {method}: {reach.sentence()}"]
    lines += ["", "![Gain by cycle](reach.png)", "", "## Traits", ""]
    lines += _advice_table(selection)
    lines += [
        "",
        "A response is that of inbred lines; a hybrid with one improved parent "
        "changes by half of it, times the correlation of lines with their "
        "testcrosses.",
    ]
    if "lines" in selection.tables:
        table = selection.tables["lines"]
        level = int((~table["is_apart"]).sum()) - 1
        lines += ["", "## Lines", ""]
        lines += markdown_table(
            ["rank", "line", f"{goal} over the mean plant [%]",
             "differs from the best"],
            [
                [
                    str(row.rank),
                    row.line,
                    interval(row.gain, row.gain_standard_error),
                    "yes" if row.is_apart else "",
                ]
                for row in table.head(_SHOWN_LINES).itertuples()
            ],
        )  # fmt: skip
        lines += [
            "",
            f"No significant difference from the best line in {level} of "
            f"{len(table) - 1} others.",
        ]
    if len(selection.tables.get("crosses", ())):
        lines += ["", "## Crosses", ""]
        lines += markdown_table(
            ["parents", "halfway [%]", "usefulness [%]"],
            [
                [
                    f"{row.parent_1} x {row.parent_2}",
                    interval(row.gain, row.gain_standard_error),
                    f"{row.usefulness:.1f}",
                ]
                for row in selection.tables["crosses"].itertuples()
            ],
        )
    lines += ["", "## Targets", "", *_targets_table(selection)]
    lines += ["", "## Remarks", ""]
    lines += [f"* {note}." for note in selection.notes]
    lines += [f"* {_describe_heritability(population)}."]
    if taken is not None:
        lines += ["", "## Columns of the trial", "", *format_taken(taken)]
    lines += [
        "",
        "± is half of a 95 % interval; columns.csv describes tables.",
    ]
    return "\n".join(lines) + "\n"


def _advice_table(selection: Selection) -> list[str]:
    index = selection.index
    rows = []
    for i, trait in enumerate(selection.population.traits):
        factor = trait.factor
        rows.append(
            [
                trait.label,
                str(index.advice[i]),
                interval(
                    index.smith_hazel[i] / factor,
                    index.smith_hazel_standard_error[i] / factor,
                ),
                interval(
                    index.weights[i] / factor,
                    index.weights_standard_error[i] / factor,
                ),
                interval(
                    factor * index.trait_response[i],
                    factor * index.trait_response_standard_error[i],
                ),
                interval(
                    index.single_gain[i], index.single_gain_standard_error[i]
                ),
            ]
        )
    rows.sort(key=lambda row: list(map(str, Advice)).index(row[1]))
    return markdown_table(
        ["trait", "advice", "index weight [% per unit]",
         "economic weight [% per unit]", "response in a cycle",
         "gain by this trait alone [%]"],
        rows,
    )  # fmt: skip


def _targets_table(selection: Selection) -> list[str]:
    def number(x: float) -> str:
        return "any" if math.isnan(x) else f"{x:.3g}"

    return markdown_table(
        ["trait", "now", "target", "distance [sd]", "costs 1 % below",
         "costs 1 % above"],
        [
            [
                f"{row.trait} [{row.unit}]",
                number(row.now),
                number(row.target),
                f"{row.distance:.1f}",
                number(row.lowest),
                number(row.highest),
            ]
            for row in selection.tables["targets"].itertuples()
        ],
    )  # fmt: skip


def _describe_heritability(population: Population) -> str:
    if population.is_heritability_assumed:
        return "heritabilities are estimates from the literature (traits.csv)"
    return "heritabilities are REML estimates of the trial (traits.csv)"
