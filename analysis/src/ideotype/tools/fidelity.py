# SPDX-License-Identifier: Apache-2.0
"""`ideotype fidelity CAMPAIGN` measures the cost of accuracy, and tells the
cheapest setting that is accurate enough."""

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
from ..stand.stand import Stand
from .survey import FEWEST, OWN, Draw, Setting, Survey, result, words


class Evaluator:
    """Evaluates two plants with settings of a campaign: the baseline, and a
    plant whose free genes are moved by a tenth of their ranges, a typical
    distance between candidates."""

    def __init__(
        self, campaign: Path, case: int, settings: Sequence[str]
    ) -> None:
        self._campaign, self._number = campaign, case
        self._settings = list(settings)
        self._stands: dict[Setting, Stand] = {}
        own = self._stand(OWN)
        self.case = own.name
        self.objective = next(iter(own.objectives))
        self.accuracy = own.accuracy.to_dict("records")
        moved = own.genes.apply(_moved, axis="columns")
        self._plants = [own.baseline, moved.to_numpy(float)]

    def draw(self, setting: Setting, number: int) -> Draw:
        """Evaluates both plants; equal numbers share random numbers."""
        stand = self._stand(setting)
        values, seconds = [], 0.0
        for genome in self._plants:
            began = time.thread_time()
            # The last generation always has the tolerance of the campaign.
            try:
                found = stand.evaluate_one(
                    genome, generation=1 << 30, seed=number
                )
            except Error as error:
                raise Error(f"{words(setting)}: {error}") from error
            # The time of the second plant counts: a stand needs longer for
            # its very first plant.
            seconds = time.thread_time() - began
            values.append(float(found.objectives[0, 0]))
        return Draw(values[0], values[1] - values[0], seconds)

    def _stand(self, setting: Setting) -> Stand:
        if setting not in self._stands:
            self._stands[setting] = Stand.from_campaign(
                self._campaign,
                case=self._number,
                settings=[*self._settings, *(words((x,)) for x in setting)],
            )
        return self._stands[setting]


def _moved(gene: pd.Series) -> float:
    step = gene["is_free"] * 0.1 * (gene["upper"] - gene["lower"])
    has_room = gene["baseline"] + step <= gene["upper"]
    return gene["baseline"] + (
        step if has_room or gene["is_circular"] else -step
    )


def table(rows: Sequence[dict[str, Any]]) -> list[str]:
    """Returns a table with a line for each setting, in % and milliseconds."""
    lines = []
    for row in rows:
        figures = [
            row[of][name]
            for of in ("value", "difference")
            for name in ("bias", "noise", "error")
        ]
        lines.append(
            "".join(f"{each!s:>14}" for each in figures)
            + f"{1e3 * row['seconds']:8.1f}{row['draws']:6}  "
            + words(tuple(row["settings"].items()))
            + (" *" if row.get("is_on_front") else "")
        )
    return lines


def block(campaign: str, settings: dict[str, float]) -> str:
    """Returns the changed tables of a campaign's text as TOML."""
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
        # TOML's short form of a list of tables may not follow a table.
        is_list = isinstance(tables, list)
        for table in tables if is_list else [tables]:
            header = f"[[{name}]]" if is_list else f"[{name}]"
            # Tables within the changed table, such as [field.variation], stay
            # unchanged.
            own = {k: v for k, v in table.items() if not isinstance(v, dict)}
            text += f"{header}\n{tomli_w.dumps(own)}\n"
    return text


def text(found: dict[str, Any], campaign: str) -> str:
    """Returns tables of keys and of settings, and the TOML to paste."""
    names = ("bias", "noise", "error", "bias of diff.", "noise", "error")
    lines = [
        f"{found['case']}: errors of one evaluation in % of "
        f"{found['objective']} (± half of a 95 % interval), milliseconds of it, "
        "draws",
        "".join(f"{each:>14}" for each in names) + f"{'ms':>8}{'draws':>6}",
    ]
    for rows in found["keys"]:
        lines += ["", *table(rows)]
    lines += ["", *(f"{k}: {v}" for k, v in found["left_out"].items()), ""]
    lines.append("keys together (*: what is cheaper is less accurate)")
    lines += [*table(found["settings"]), ""]
    wanted = f"# Within {100 * found['tolerance']:g} %"
    if not found["is_met"]:
        wanted += " is none; the most accurate"
    if not (settings := found["chosen"]["settings"]):
        return "\n".join([*lines, f"{wanted}: the campaign as it is"])
    lines.append(f"{wanted}: in the place of these tables of the campaign")
    return "\n".join([*lines, block(campaign, settings)])


def main(arguments: Sequence[str] | None = None) -> int:
    """Measures, prints and returns the exit code: 0, 1 if something failed, 2
    for a wrong command line, 3 for a wrong campaign, 4 for an output that is a
    symbolic link, 5 after Ctrl-C."""
    parser = argparse.ArgumentParser(
        prog="ideotype fidelity",
        description="Measures error and time of evaluations with each key "
        "that trades one for the other, and tells the cheapest that will do.",
    )
    add = parser.add_argument
    add("campaign", type=Path, metavar="CAMPAIGN", help="a TOML file")
    add("--set", action="append", default=[], metavar="KEY=VALUE")
    add("--case", type=int, default=0, metavar="N", help="of `check --cases`")
    add(
        "--tolerance", type=number_within(float, 1e-5, 1), default=0.008,
        help="relative error wanted",
    )  # fmt: skip
    add(
        "--seconds", type=number_within(float, 1, 1e6), default=60,
        help="to measure (default: 60)",
    )  # fmt: skip
    add("--json", type=Path, metavar="FILE", help="gets all figures")
    add(
        "--figure", type=figure_path, metavar="FILE",
        help="PNG, PDF or SVG to draw",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    try:
        for path in filter(None, (options.json, options.figure)):
            require_output(path)
    except OutputRefused as error:
        return _fail(error)
    code = 0
    # Both signals end the survey, even in a background job of a script, which
    # would ignore SIGINT.
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
        found = {
            "case": evaluator.case,
            "objective": evaluator.objective,
            **result(survey, options.tolerance),
        }
        print(
            ("stopped before the end\n" if code else "")
            + text(found, options.campaign.read_text())
        )
        if options.json:
            write_file(options.json, json.dumps(found, indent=1) + "\n")
        if options.figure:
            from ..figures.fidelity import draw_fidelity

            save_figure(draw_fidelity(found), options.figure)
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
