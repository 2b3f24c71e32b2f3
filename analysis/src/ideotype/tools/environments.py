# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype environments`."""

from __future__ import annotations

import argparse
import json
import sys
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import tomli_w

from ..common.output import REFUSED, OutputRefused, write_file
from ..common.settings import number_within
from ..environments import (
    Features,
    Representatives,
    choose_representatives,
    read_features,
)
from ..errors import Error, printable_lines


def main(arguments: Sequence[str] | None = None) -> int:
    """Prints representative climates of a campaign and returns the exit code:
    0, 1 if the file cannot be written, 2 for a wrong command line, 3 for an
    invalid campaign, 4 for an output that exists."""
    parser = argparse.ArgumentParser(
        prog="ideotype environments",
        description="Chooses a few years that represent a long record of "
        "weather, by k-medoids over radiation, temperature, vapour pressure "
        "deficit and rain by phase of the season. CAMPAIGN has a [[climate]] "
        "for each year of the record, or one with 'years'. "
        "docs/decision.md has an example.",
    )
    add = parser.add_argument
    add("campaign", type=Path, metavar="CAMPAIGN", help="campaign file")
    add(
        "-k", "--count", type=number_within(int, 1, 1000), default=5,
        metavar="N", help="number of years to choose (default: 5)",
    )  # fmt: skip
    add(
        "--set", action="append", default=[], metavar="KEY=VALUE",
        help="replace a key of the campaign; may be repeated",
    )  # fmt: skip
    add(
        "--seed", type=number_within(int, 0, 2**31), default=1, metavar="N",
        help="seed of the random starts (default: 1)",
    )  # fmt: skip
    add("--json", action="store_true", help="print JSON")
    add(
        "--to", type=Path, metavar="FILE",
        help="write the campaign with these years and weights, in the folder "
        "of the campaign, since paths in it are relative; comments are lost",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    try:
        features = read_features(options.campaign, options.set)
        chosen = choose_representatives(features, options.count, options.seed)
        if options.to:
            _write(options.campaign, options.to, features, chosen)
    except OutputRefused as error:
        return _fail(REFUSED, error)
    except Error as error:
        return _fail(3, error)
    except OSError as error:
        return _fail(1, error)
    print(
        json.dumps(to_json(chosen), indent=1)
        if options.json
        else format_text(features, chosen)
    )
    return 0


def to_json(chosen: Representatives) -> dict[str, Any]:
    """Returns the choice for JSON."""
    return {
        "climates": list(chosen.names),
        "weights": chosen.weights.tolist(),
        "represented_by": chosen.represented_by,
        "kept_variance": chosen.kept,
        "features": {
            str(name): {key: float(x) for key, x in row.items()}
            for name, row in chosen.loss.iterrows()
        },
    }


def format_text(features: Features, chosen: Representatives) -> str:
    """Returns the choice, its loss and the lines of a campaign as text."""
    lines = [
        f"{len(chosen.names)} of {len(features.values)} climates keep "
        f"{100 * chosen.kept:.0f} % of the variance of {len(chosen.loss)} "
        "features."
    ]
    lines += [
        f"The weather has no {name}, so that no feature describes it."
        for name in features.missing
    ]
    width = max(len(str(name)) for name in chosen.loss.index)
    head = f"{'feature':{width}}{'record':>16}{'chosen':>16}{'shift [sd]':>12}"
    lines += ["", head]
    for name, row in chosen.loss.iterrows():
        record = f"{row['mean']:.4g} ({row['deviation']:.2g})"
        some = f"{row['chosen_mean']:.4g} ({row['chosen_deviation']:.2g})"
        lines.append(
            f"{name:{width}}{record:>16}{some:>16}{row['shift']:12.2f}"
        )
    lines += ["", "Mean, with the standard deviation between climates.", ""]
    for name, weight in zip(chosen.names, chosen.weights):
        others = [
            x
            for x, by in chosen.represented_by.items()
            if by == name and x != name
        ]
        lines.append(
            f"{name}, weight {weight:.3f}"
            + (f", represents {', '.join(others)}" if others else "")
        )
    years = [name.rpartition("_")[2] for name in chosen.names]
    if all(year.isdecimal() for year in years):
        weights = ", ".join(f"{x:.4g}" for x in chosen.weights)
        lines += [
            "",
            "In [[climate]] of the campaign:",
            "",
            f"years = [{', '.join(years)}]",
            f"weights = [{weights}]",
        ]
    return printable_lines("\n".join(lines))


def _write(
    campaign: Path, to: Path, features: Features, chosen: Representatives
) -> None:
    """Writes a campaign that has only the chosen climates."""
    if to.parent.resolve() != campaign.parent.resolve():
        raise Error(
            f"--to {to} is not in the folder of {campaign} (paths in the "
            "campaign are relative to it); give a file in that folder"
        )
    if to.exists():
        raise OutputRefused(f"{to} exists; give a new file")
    tables = tomllib.loads(campaign.read_text(encoding="utf-8"))
    # Climates are in the order of the tables, and of the years in them.
    left = [str(name) for name in features.values.index]
    weights = dict(zip(chosen.names, chosen.weights.tolist()))
    climates = []
    for table in tables["climate"]:
        count = len(table.get("years", [0]))
        names, left = left[:count], left[count:]
        some = [i for i, name in enumerate(names) if name in weights]
        if not some:
            continue
        if "years" in table:
            table["years"] = [table["years"][i] for i in some]
        table["weights"] = [weights[names[i]] for i in some]
        climates.append(table)
    tables["climate"] = climates
    write_file(to, tomli_w.dumps(tables))


def _fail(code: int, error: Exception) -> int:
    print(printable_lines(f"ideotype environments: {error}"), file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
