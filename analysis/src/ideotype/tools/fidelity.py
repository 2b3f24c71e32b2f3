# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype fidelity`: measures the cost of accuracy, and
recommends the cheapest setting that is accurate enough."""

from __future__ import annotations

import argparse
import json
import signal
import sys
import time
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pandas as pd
import tomli_w

from ..common.output import (
    REFUSED,
    OutputRefused,
    figure_path,
    require_output,
    save_figure,
    write_file,
)
from ..common.settings import number_within
from ..errors import Error, InputError, printable_lines
from ..history.estimate import NORMAL
from ..stand.stand import Stand
from .survey import (
    FEWEST,
    OWN,
    Draw,
    Setting,
    Survey,
    format_setting,
    summarize,
)


class Evaluator:
    """Evaluates two plants with settings of a campaign: the baseline, and a
    plant with all free genes moved by a tenth of their ranges, a typical
    distance between candidates."""

    def __init__(
        self, campaign: Path, case: int, settings: Sequence[str]
    ) -> None:
        self._campaign, self._number = campaign, case
        self._settings = list(settings)
        self._stands: dict[Setting, Stand] = {}
        stand = self._stand(OWN)
        self.case = stand.name
        self.objective = next(iter(stand.objectives))
        self.accuracy = stand.accuracy.to_dict("records")
        moved = stand.genes.apply(_moved, axis="columns")
        self._plants = [stand.baseline, moved.to_numpy(float)]

    def draw(self, setting: Setting, number: int) -> Draw:
        """Evaluates both plants. Draws of one number have common random
        numbers."""
        stand = self._stand(setting)
        values, seconds = [], 0.0
        for genome in self._plants:
            began = time.thread_time()
            # The last generation always has the tolerance of the campaign.
            try:
                evaluated = stand.evaluate_one(
                    genome, generation=1 << 30, seed=number
                )
            except Error as error:
                raise Error(f"{format_setting(setting)}: {error}") from error
            # The time of the second plant counts, since the first evaluation
            # of a stand takes longer.
            seconds = time.thread_time() - began
            values.append(float(evaluated.objectives[0, 0]))
        return Draw(values[0], values[1] - values[0], seconds)

    def _stand(self, setting: Setting) -> Stand:
        if setting not in self._stands:
            self._stands[setting] = Stand.from_campaign(
                self._campaign,
                case=self._number,
                settings=[
                    *self._settings,
                    *(format_setting((x,)) for x in setting),
                ],
            )
        return self._stands[setting]


def _moved(gene: pd.Series) -> float:
    step = gene["is_free"] * 0.1 * (gene["upper"] - gene["lower"])
    has_room = gene["baseline"] + step <= gene["upper"]
    return gene["baseline"] + (
        step if has_room or gene["is_circular"] else -step
    )


def table(rows: Sequence[dict[str, Any]]) -> list[str]:
    """Returns one line for each setting, in % and milliseconds."""
    lines = []
    for row in rows:
        figures = [
            row[part][name]
            for part in ("value", "difference")
            for name in ("bias", "noise", "error")
        ]
        lines.append(
            "".join(f"{figure!s:>14}" for figure in figures)
            + f"{1e3 * row['seconds']:8.1f}{_cost(row):>14}{row['draws']:6}  "
            + format_setting(tuple(row["settings"].items()))
            + (" *" if row.get("is_on_front") else "")
        )
    return lines


def _cost(row: dict[str, Any]) -> str:
    mean, error = row["cost"]
    return f"{mean:.2f} ± {NORMAL * error:.2f}"


def block(campaign: str, settings: dict[str, float]) -> str:
    """Returns the tables of a campaign that the settings change, as TOML."""
    data = tomllib.loads(campaign)
    changed: dict[str, Any] = {}
    for path, value in settings.items():
        name, key = path.split(".")
        tables = data.setdefault(name, {})
        first = tables[0] if isinstance(tables, list) else tables
        first[key] = int(value) if value == int(value) else value
        changed[name] = tables
    text = ""
    for name, tables in changed.items():
        # The short form of a list of tables may not follow a table in TOML.
        is_list = isinstance(tables, list)
        for table in tables if is_list else [tables]:
            header = f"[[{name}]]" if is_list else f"[{name}]"
            # Subtables, such as [field.variation], remain unchanged.
            keys = {k: v for k, v in table.items() if not isinstance(v, dict)}
            text += f"{header}\n{tomli_w.dumps(keys)}\n"
    return text


def text(results: dict[str, Any], campaign: str) -> str:
    """Returns tables of keys and settings, and TOML for the campaign."""
    names = ("bias", "noise", "error", "bias of diff.", "noise", "error")
    lines = [
        f"{results['case']}: errors of one evaluation in % of "
        f"{results['objective']} (± half of a 95 % interval), its time in ms, "
        "cost of a search relative to the campaign (ms times the square of "
        "the error of the difference), draws",
        "".join(f"{name:>14}" for name in names)
        + f"{'ms':>8}{'cost':>14}{'draws':>6}",
    ]
    for rows in results["keys"]:
        lines += ["", *table(rows)]
    lines += ["", *(f"{k}: {v}" for k, v in results["left_out"].items()), ""]
    lines.append("keys together (*: all cheaper settings are less accurate)")
    lines += [*table(results["settings"]), ""]
    best = format_setting(
        tuple(results["best_for_search"]["settings"].items())
    )
    lines += [f"lowest cost of a search: {best}", ""]
    wanted = f"# Within {100 * results['tolerance']:g} %"
    if not results["is_met"]:
        wanted += " there is none; the most accurate"
    if not (settings := results["chosen"]["settings"]):
        return "\n".join([*lines, f"{wanted}: the campaign as it is"])
    lines.append(f"{wanted}: replace these tables of the campaign")
    return "\n".join([*lines, block(campaign, settings)])


def main(arguments: Sequence[str] | None = None) -> int:
    """Measures settings and returns the exit code: 0, 1 after a failure, 2 for
    a wrong command line, 3 for an invalid campaign, 4 for an output that is a
    symbolic link, 5 after Ctrl-C."""
    parser = argparse.ArgumentParser(
        prog="ideotype fidelity",
        description="Measures the error and time of evaluations for each key "
        "that trades accuracy for speed, and recommends the cheapest setting "
        "within the tolerance.",
    )
    add = parser.add_argument
    add("campaign", type=Path, metavar="CAMPAIGN", help="TOML file")
    add("--set", action="append", default=[], metavar="KEY=VALUE")
    add(
        "--case",
        type=int,
        default=0,
        metavar="N",
        help="index of the case, as `ideotype check --cases` lists it",
    )
    add(
        "--tolerance", type=number_within(float, 1e-5, 1), default=0.008,
        help="target relative error (default: 0.008)",
    )  # fmt: skip
    add(
        "--seconds", type=number_within(float, 1, 1e6), default=60,
        help="time for measurements (default: 60)",
    )  # fmt: skip
    add("--json", type=Path, metavar="FILE", help="file for all results")
    add(
        "--figure", type=figure_path, metavar="FILE",
        help="PNG, PDF or SVG file for a figure",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    try:
        for path in filter(None, (options.json, options.figure)):
            require_output(path)
    except OutputRefused as error:
        return _fail(error)
    code = 0
    # Both signals end the survey, even in background jobs of scripts, which
    # ignore SIGINT by default.
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.default_int_handler)
    try:
        began = time.monotonic()
        evaluator = Evaluator(options.campaign, options.case, options.set)
        left = options.seconds - (time.monotonic() - began)
        survey = Survey(evaluator.accuracy, evaluator.draw, left)
        try:
            survey.run(options.tolerance)
        except KeyboardInterrupt:
            code = 5
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        if len(survey.draws[OWN]) < FEWEST:
            raise KeyboardInterrupt
        results = {
            "case": evaluator.case,
            "objective": evaluator.objective,
            **summarize(survey, options.tolerance),
        }
        print(
            ("stopped before the end\n" if code else "")
            + text(results, options.campaign.read_text())
        )
        if options.json:
            write_file(options.json, json.dumps(results, indent=1) + "\n")
        if options.figure:
            from ..figures.fidelity import draw_fidelity

            save_figure(draw_fidelity(results), options.figure)
    except KeyboardInterrupt:
        print(
            "ideotype fidelity: stopped, nothing is measured", file=sys.stderr
        )
        return 5
    except (Error, OSError) as error:
        return _fail(error)
    return code


def _fail(error: Exception) -> int:
    print(printable_lines(f"ideotype fidelity: {error}"), file=sys.stderr)
    if isinstance(error, OutputRefused):
        return REFUSED
    return 3 if isinstance(error, InputError) else 1


if __name__ == "__main__":
    sys.exit(main())
