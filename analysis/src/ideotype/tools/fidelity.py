# SPDX-License-Identifier: Apache-2.0
"""`ideotype fidelity CAMPAIGN` measures the cost of accuracy, and tells the
cheapest setting that is accurate enough."""

from __future__ import annotations

import argparse
import json
import re
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import tomli_w

from ..__main__ import compiled_program
from ..common.output import (
    REFUSED,
    OutputRefused,
    figure_path,
    require_output,
    save_figure,
    write_file,
)
from ..common.settings import number_within
from ..errors import Error, printable_lines
from .survey import FEWEST, OWN, Draw, Refused, Setting, Survey, result, words


class Program:
    """The program `ideotype serve`, one process for each setting, which
    evaluates two plants: the baseline, and a plant whose free genes are moved
    by a tenth of their ranges, a typical distance between candidates."""

    def __init__(self, *arguments: str) -> None:
        if not (program := compiled_program()):
            raise Error(
                "there is no compiled program; build it by ./quickstart.sh, "
                "then put it in the PATH or name it in IDEOTYPE_EXECUTABLE"
            )
        own = ["--threads", "1", "--quiet"]
        self._command = [program, "serve", *arguments, *own]
        self._servers: dict[Setting, subprocess.Popen[str]] = {}
        self.hello = self._start(OWN)
        self.objective = self.hello["objectives"][0]["name"]
        genes = self.hello["genes"]
        baseline = [gene["baseline"] for gene in genes]
        self._plants = [baseline, list(map(_moved, genes))]

    def draw(self, setting: Setting, number: int) -> Draw:
        """Evaluates both plants; equal numbers share random numbers."""
        if setting not in self._servers:
            self._start(setting)
        server = self._servers[setting]
        assert server.stdin and server.stdout
        # Linux numbers the clock of a process's processor time so.
        clock = (~server.pid << 3) | 2
        values, seconds = [], 0.0
        for genome in self._plants:
            # The last generation always has the tolerance of the campaign.
            request = {"genome": genome, "seed": number, "generation": 1 << 30}
            began = time.clock_gettime(clock)
            print(json.dumps(request), file=server.stdin, flush=True)
            answer = json.loads(server.stdout.readline() or "{}")
            if answer.get("status") != "done":
                why = answer.get("message", "the program has ended")
                raise Error(f"{words(setting)}: {why}")
            values.append(answer["objectives"][self.objective]["mean"])
            # The time of the second plant counts: a process needs longer for
            # its very first plant.
            seconds = time.clock_gettime(clock) - began
        return Draw(values[0], values[1] - values[0], seconds)

    def end(self) -> None:
        """Ends all processes."""
        for server in self._servers.values():
            server.kill()

    def _start(self, setting: Setting) -> dict[str, Any]:
        sets = [w for pair in setting for w in ("--set", words((pair,)))]
        # The new process has a separate group, so that Ctrl-C reaches only the
        # present process.
        server = subprocess.Popen(
            [*self._command, *sets],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            process_group=0,
        )
        self._servers[setting] = server
        assert server.stdout and server.stderr
        if line := server.stdout.readline():
            return json.loads(line)
        message = server.stderr.read().strip() or "the program has ended"
        # The time and the name of the program are removed from the message,
        # because this command adds its own name.
        message = re.sub(r"^\S+  ideotype: ", "", message, flags=re.MULTILINE)
        raise Refused(message, server.wait())


def _moved(gene: dict[str, Any]) -> float:
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
    program = None
    code = 0
    # Both signals end the survey, even in a background job of a script, which
    # would ignore SIGINT.
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.default_int_handler)
    try:
        began = time.monotonic()
        sets = [word for each in options.set for word in ("--set", each)]
        case = ["--case", str(options.case)]
        program = Program(str(options.campaign), *case, *sets)
        left = options.seconds - (time.monotonic() - began)
        survey = Survey(program.hello["accuracy"], program.draw, left)
        try:
            survey.run(options.tolerance)
        except KeyboardInterrupt:
            code = 5
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        if len(survey.draws[OWN]) < FEWEST:
            raise KeyboardInterrupt
        found = {
            "case": program.hello["case"],
            "objective": program.objective,
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
    finally:
        if program:
            program.end()
    return code


def _fail(error: Exception) -> int:
    print(printable_lines(f"ideotype fidelity: {error}"), file=sys.stderr)
    if isinstance(error, OutputRefused):
        return REFUSED
    return error.code if isinstance(error, Refused) else 1


if __name__ == "__main__":
    sys.exit(main())
