# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype compare`."""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..common.compiled import _core
from ..common.output import REFUSED, OutputRefused, require_output, write_file
from ..common.progress import Progress
from ..common.settings import number_within
from ..errors import Error, InputError, did_you_mean, printable_lines
from ..history.file import HistoryError
from ..stand.comparison import Comparison, Quantity, format_page
from ..stand.plants import Plant, compare_plants, list_quantities


def make_stands(
    campaign: Path, settings: Sequence[str]
) -> list[tuple[str, _core.CaseStand, int | None]]:
    """Returns the name, stand and index of each scenario of each case of a
    campaign, without replicates."""
    cases: list[tuple[str, _core.CaseStand, int | None]] = []
    for index, (_, replicate) in enumerate(
        _core.case_names(str(campaign), list(settings))
    ):
        if replicate > 1:
            continue
        stand = _core.CaseStand.from_file(
            str(campaign), index, list(settings), ""
        )
        names = stand.scenarios
        for scenario, name in enumerate(names):
            cases.append((name.rpartition("_r")[0], stand, scenario))
    return cases


def to_json(comparison: Comparison, seed: int) -> dict[str, Any]:
    """Returns the comparison in the form of `compare.schema.json`."""
    objective = comparison.objective
    plants, cases = range(len(comparison.plants)), range(len(comparison.cases))
    draws = [
        [
            comparison.numbers[p, c][objective.name, 0].draws.tolist()
            for c in cases
        ]
        for p in plants
    ]
    profiles = {
        quantity.name: {
            "unit": quantity.unit,
            "axis": quantity.axis,
            "axis_unit": "m" if quantity.axis == "layer" else "1",
            "coordinates": list(quantity.coordinates),
            **_matrices(comparison, quantity),
        }
        for quantity in comparison.quantities
        if quantity.axis
    }
    numbers = {
        quantity.name: {
            "unit": quantity.unit,
            **({"names": list(quantity.names)} if quantity.names else {}),
            **_matrices(comparison, quantity),
        }
        for quantity in comparison.quantities
        if not quantity.axis
    }
    correlation = comparison.rank_correlation(objective.name)
    return {
        "objective": objective.name,
        "unit": objective.unit,
        "seed": seed,
        "plants": list(comparison.plants),
        "reference": comparison.plants[comparison.reference],
        "cases": list(comparison.cases),
        "rank": comparison.ranks(objective.name).tolist(),
        "rank_correlation": [
            [None if np.isnan(x) else float(x) for x in row]
            for row in correlation
        ],
        **_matrices(comparison, objective),
        "by_randomisation": draws,
        "quantities": numbers,
        "profiles": profiles,
    }


def _matrices(comparison: Comparison, quantity: Quantity) -> dict[str, Any]:
    """Returns the means and standard errors by plant and case, for profiles
    also along the axis, and those of the differences from the reference."""

    def matrix(take: Any, statistic: str) -> list[list[Any]]:
        return [
            [
                _entry(take, p, c, quantity, statistic)
                for c in range(len(comparison.cases))
            ]
            for p in range(len(comparison.plants))
        ]

    def both(take: Any) -> dict[str, Any]:
        return {x: matrix(take, x) for x in ("mean", "standard_error")}

    return {
        **both(comparison.value),
        "difference": both(comparison.difference),
    }


def _entry(
    take: Any, plant: int, case: int, quantity: Quantity, statistic: str
) -> Any:
    count = len(quantity.coordinates)
    indices = range(count) if quantity.axis != "leaf" else range(count)[::-1]
    values = [take(plant, case, (quantity.name, i)) for i in indices]
    numbers = [None if x is None else getattr(x, statistic) for x in values]
    return numbers if quantity.axis else numbers[0]


def main(arguments: Sequence[str] | None = None) -> int:
    """Compares plants and returns the exit code: 0, 1 after a failure, 2 for a
    wrong command line, 3 for an invalid campaign or plant, 4 for a damaged
    history or an output file that exists."""
    options = _parser().parse_args(arguments)
    try:
        if options.csv:
            require_output(options.csv, replaces=False)
        return _compare(options)
    except InputError as error:
        return _fail(3, error)
    except (HistoryError, OutputRefused) as error:
        return _fail(REFUSED, error)
    except (Error, OSError, MemoryError) as error:
        return _fail(1, error)


def _fail(code: int, error: Exception) -> int:
    print(printable_lines(f"ideotype: {error}"), file=sys.stderr)
    return code


def _compare(options: argparse.Namespace) -> int:
    settings = list(options.set)
    if options.seed is not None:
        settings.append(f"seed={options.seed}")
    stands = make_stands(options.under, settings)
    first = stands[0][1]
    _require_sort(options.sort, [name for name, *_ in stands], first)
    plants = [
        plant for path in options.plants for plant in Plant.read(path, first)
    ]
    with Progress("evaluated") as progress:
        comparison = compare_plants(
            plants,
            stands,
            tolerance=options.tolerance,
            threads=options.threads,
            reference=options.reference,
            on_progress=progress.show,
        )
    if options.csv:
        columns = [x for x in comparison.table if not x.startswith("percent")]
        text = comparison.table[columns].to_csv(index=False)
        write_file(options.csv, text, replaces=False)
    if options.json:
        import tomllib

        seed = int(tomllib.loads(first.resolved)["seed"])
        print(json.dumps(to_json(comparison, seed), indent=2))
    else:
        print(format_page(comparison, options.all, options.sort))
    return 0


def _require_sort(
    word: str, cases: Sequence[str], stand: _core.CaseStand
) -> None:
    """Raises Error unless the word is a case or a quantity without axes."""
    names = [x.name for x in list_quantities(stand) if not x.axis]
    if word and word not in (*cases, *names):
        raise Error(
            f"--sort {word}: this is no case or quantity of the campaign"
            f"{did_you_mean(word, [*cases, *names])} (cases: "
            f"{', '.join(cases)}; quantities: {', '.join(names)})"
        )


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="ideotype compare",
        description="Evaluates plants in the same light, with the accuracy of "
        "finalists, and reports the difference of each from a reference with "
        "paired standard errors. More than three plants are ranked, with a line "
        "each.",
        epilog="example: ideotype compare maize.toml field.csv --under "
        "campaigns/ames_quick.toml",
    )
    add = parser.add_argument
    add(
        "plants", nargs="+", metavar="PLANT",
        help="crop files (.toml), measured leaves of one or more plants "
        "(.csv), histories (.h5: their best plant) and campaigns (.toml: "
        "their baseline)",
    )  # fmt: skip
    add(
        "--under", type=Path, required=True, metavar="CAMPAIGN",
        help="campaign with the cases in which plants are evaluated",
    )  # fmt: skip
    add(
        "--set", action="append", default=[], metavar="KEY=VALUE",
        help="replace a key of the campaign",
    )  # fmt: skip
    add(
        "--seed", type=number_within(int, 0, 2**63 - 1), metavar="N",
        help="seed of all random numbers (default: that of the campaign)",
    )  # fmt: skip
    add(
        "--tolerance", type=number_within(float, 1e-5, 0.05), metavar="X",
        help="relative standard error of the light absorbed by leaves "
        "(default: [final] of the campaign)",
    )  # fmt: skip
    add(
        "--threads", type=number_within(int, 1, 4096), metavar="N",
        default=len(os.sched_getaffinity(0)),
        help="number of threads (default: one per core)",
    )  # fmt: skip
    add(
        "--reference", default="", metavar="NAME",
        help="plant to which differences refer (default: the first)",
    )  # fmt: skip
    add(
        "--sort", default="", metavar="QUANTITY|CASE",
        help="rank plants, with a line each, by a quantity (default: the "
        "objective) or by the objective in one case (default: its mean)",
    )  # fmt: skip
    add("--all", action="store_true", help="print every quantity")
    add(
        "--csv", type=Path, metavar="FILE",
        help="also write every number, including those by leaf and layer, to "
        "this new file",
    )  # fmt: skip
    add("--json", action="store_true", help="print JSON instead of text")
    return parser


if __name__ == "__main__":
    sys.exit(main())
