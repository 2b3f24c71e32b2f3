# SPDX-License-Identifier: Apache-2.0
"""Formats a calibration as a page in Markdown."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pandas as pd

from ..common.markdown import markdown_table
from .answers import Predictions, combinations, pairs
from .calibration import Calibration

SHARE = 0.1
"""The share of a combination from which a parameter is named."""
LEARNED = 0.5
"""The variance over the prior's below which a combination is listed."""


def format_table(table: pd.DataFrame, titles: Sequence[str] = ()) -> list[str]:
    """Returns a table with numbers of three digits."""
    rows = [
        [f"{x:.3g}" if isinstance(x, float) else str(x) for x in line]
        for line in table.itertuples(index=False)
    ]
    return markdown_table(list(titles or table.columns), rows)


def describe_work(calibration: Calibration) -> str:
    """Returns sentences about convergence and evaluations."""
    samples, stored = calibration.samples, calibration.model.evaluations
    state = "has converged" if samples.has_converged else "HAS NOT CONVERGED"
    remedy = (
        ""
        if samples.has_converged
        else "Intervals are not reliable; raise the number of steps (--steps), "
        "or use fewer parameters. "
    )
    lines = (
        f"The sampler {state}: the largest R-hat is {samples.r_hat.max():.3f}, "
        f"the longest autocorrelation time {samples.autocorrelation.max():.0f} "
        f"of {samples.steps} steps, and the smallest effective size "
        f"{samples.effective_size:.0f}. {remedy}"
        f"The program computed {len(stored)} points in {stored.seconds:.1f} s of "
        f"processor time; {calibration.model.failed} failed."
    )
    if calibration.emulator is None:
        return f"{lines} Each point of the sampler was evaluated directly."
    return (
        f"{lines} The sampler used an emulator of "
        f"{calibration.emulator.count} points. At points of the posterior that "
        "it was not made from, its error is at most "
        f"{calibration.checks[-1].relative:.2f} of the known error of a row; it "
        "is part of the likelihood."
    )


def combinations_table(calibration: Calibration) -> list[str]:
    """Returns one row for each combination of parameters that the data
    determine."""
    table = combinations(calibration)
    rows = []
    for _, line in table[table.variance < LEARNED].iterrows():
        shares = line.drop("variance").sort_values(ascending=False)
        named = shares[shares >= SHARE]
        text = ", ".join(f"{key} ({x:.0%})" for key, x in named.items())
        rows.append([f"{line.variance:.2g}", text])
    return markdown_table(["variance over the prior's", "parameters"], rows)


def describe_pairs(calibration: Calibration) -> list[str]:
    """Returns a sentence for each pair of parameters that only act
    together."""
    return [
        f"* `{pair.first}` and `{pair.second}` act together: their correlation "
        f"is {pair.correlation:.2f}. With the second one known, the standard "
        f"deviation of the first would be "
        f"{pair.deviation_if_known:.2g} of the prior's instead of "
        f"{pair.deviation:.2g}."
        for pair in pairs(calibration).itertuples()
    ]


def format_page(
    calibration: Calibration,
    predictions: Predictions,
    others: Sequence[tuple[str, Predictions]] = (),
    decision: Sequence[pd.DataFrame] = (),
) -> str:
    """Returns the page.

    others: name and predictions of other tables.
    decision: the tables of next_measurements() and explained_by_parameter(),
        if there is a decision."""
    lines = ["# Calibration", "", describe_work(calibration), ""]
    lines += ["## Parameters", "", *format_table(calibration.summary()), ""]
    lines += [
        "`low` and `high` are the 5 and 95 % quantiles. `shrinkage` is the part "
        "of the prior variance that the data removed.",
        "",
    ]
    if calibration.posterior.quantities:
        values = calibration.discrepancies
        table = pd.DataFrame(
            {
                "quantity": calibration.posterior.quantities,
                "prior": 0.675 * calibration.posterior.scales,
                "posterior": np.median(values, axis=0),
                "low": np.quantile(values, 0.05, axis=0),
                "high": np.quantile(values, 0.95, axis=0),
            }
        )
        titles = ["discrepancy of", "median before", "median", "low", "high"]
        lines += ["## Discrepancies", "", *format_table(table, titles), ""]
    titles = [
        "quantity", "unit", "rows", "error before", "error after",
        "inside 90 % intervals",
    ]  # fmt: skip
    lines += ["## Measured and computed", ""]
    parts = [
        ("fitted", predictions, "is_fitted"),
        ("held out", predictions, "is_held_out"),
        *((name, x, "is_fitted") for name, x in others),
    ]
    for name, part, column in parts:
        table = part.errors(column)
        if len(table):
            left_out = f", without {part.failed} failed draws" * (
                part.failed > 0
            )
            lines += [f"Rows {name}{left_out}:", ""]
            lines += [*format_table(table, titles), ""]
    lines += [
        "Errors are root mean squares; before: with the parameters of the "
        "files.",
        "",
        "## What the data determine",
        "",
        *combinations_table(calibration),
        "",
        *(
            describe_pairs(calibration)
            or ["No two parameters have a correlation above 0.8."]
        ),
        "",
    ]
    if decision:
        following, explained = decision
        lines += ["## The decision", "", *format_table(explained), ""]
        if len(following):
            lines += [
                "Measurements that could be made, by the expected shrinkage of "
                "the variance of the decision:",
                "",
                *format_table(following),
                "",
            ]
    return "\n".join(lines)
