# SPDX-License-Identifier: Apache-2.0
"""The commands `ideotype summary` and `ideotype report`."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from ..common.output import REFUSED, OutputRefused
from ..common.progress import Progress
from ..errors import Error, printable_lines
from ..history.study import Study, open_study

_EXIT_CODES = (
    "Exit codes: 0 success, 1 failure, 2 wrong usage, 3 success without the "
    "histories that can't be read, which are named, 4 the output is a symbolic "
    "link or a special file."
)


def summary(arguments: Sequence[str] | None = None) -> int:
    """Prints the table of gains and returns the exit code: 0, 1 if no file can
    be used, 2 for a wrong command line, 3 if some files cannot be used."""
    parser = argparse.ArgumentParser(
        prog="ideotype summary",
        description="Prints the table of gains of the report as Markdown, with "
        "one line for each case over all its seeds. ideotype status reports the "
        "result of each history.",
        epilog=_EXIT_CODES,
    )
    _add_results(parser)
    _add_split(parser)
    parser.add_argument(
        "--csv",
        action="store_true",
        help="print one line of CSV for each case, with its coordinates",
    )
    parser.add_argument(
        "--all",
        action="store_true",
        help="print all cases, and remarks on the numbers",
    )
    return guarded(parser, arguments, _summarize)


def report(arguments: Sequence[str] | None = None) -> int:
    """Writes a report and returns an exit code, as summary()."""
    parser = argparse.ArgumentParser(
        prog="ideotype report",
        description="Writes a self-contained HTML page about all histories, "
        "finished or being written, and its figures as files.",
        epilog=_EXIT_CODES,
    )
    _add_results(parser)
    _add_split(parser)
    add = parser.add_argument
    add(
        "-o", "--output", type=Path, default=Path("report"), metavar="DIR",
        help="folder for report.html, decision.html, results.csv, the figure "
        "for a paper (figure.pdf, figure.png) and figures/ (default: report)",
    )  # fmt: skip
    add(
        "--figures", action="append", metavar="CASE",
        help="draw figures of the cases with names that contain this; \"\": all "
        "(default: all, if there are three or fewer)",
    )  # fmt: skip
    add(
        "--plant", action="append", default=[], type=Path, metavar="FILE",
        help="another plant for the three-dimensional view: a crop file, "
        "measured leaves (.csv), or a digitised plant (.obj, .ply, .dat); may "
        "be repeated",
    )  # fmt: skip
    add(
        "--selection", type=Path, metavar="DIR",
        help="a folder of ideotype select, for the gain of a breeding programme "
        "compared with that of its ideotype",
    )  # fmt: skip
    add(
        "--cross",
        type=Path,
        metavar="FILE",
        help="a cross-evaluation, .json or .csv",
    )
    add(
        "--no-decision", dest="has_decision", action="store_false",
        help="do not re-evaluate plants to decide between them at [prices] or "
        "over scenarios",
    )  # fmt: skip
    add(
        "--pdf",
        action="store_true",
        help="write figures as PDF in addition to SVG",
    )
    add(
        "-j", "--jobs", type=int, default=0, metavar="N",
        help="number of processes that draw figures (default: one per core)",
    )  # fmt: skip
    add(
        "--estimates", type=Path, metavar="FILE",
        help="a crop file with estimates that state a range (# E: LOW to HIGH), "
        "or priors as for ideotype calibrate: the report states the gain under "
        "20 draws of them",
    )  # fmt: skip
    words = sys.argv[1:] if arguments is None else arguments
    parser.set_defaults(command=shlex.join(["ideotype", "report", *words]))
    return guarded(parser, arguments, _report)


def _add_results(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "results",
        nargs="+",
        metavar="RESULTS",
        help="histories (.h5), folders of them, or patterns",
    )


def _add_split(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--no-split",
        dest="has_split",
        action="store_false",
        help="do not re-evaluate the best plant of each case and its baseline "
        "without other organs, which shows the share of the gain that is light "
        "gained from other organs",
    )


def guarded(
    parser: argparse.ArgumentParser,
    arguments: Sequence[str] | None,
    run: Callable[[argparse.Namespace, Study], None],
) -> int:
    """Parses the arguments, opens their histories and calls `run`; returns the
    exit code after errors are reported."""

    def warn(words: object) -> None:
        print(printable_lines(f"{parser.prog}: {words}"), file=sys.stderr)

    try:
        try:
            options = parser.parse_args(arguments)
            with open_study(*options.results, skip_damaged=True) as study:
                for error in study.damaged:
                    warn(f"left out: {error}")
                run(options, study)
                return 3 if study.damaged else 0
        finally:
            # The flush reports a full disk before Python exits.
            sys.stdout.flush()
    except BrokenPipeError:
        # The reader of the output has closed the pipe.
        _drop_output()
        return 1
    except (Error, OSError) as error:
        warn(error)
        _drop_output()
        return REFUSED if isinstance(error, OutputRefused) else 1


def _drop_output() -> None:
    """Discards output that cannot be written; otherwise Python would retry at
    exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _summarize(options: argparse.Namespace, study: Study) -> None:
    # These imports are slow, and wrong command lines need not wait for them.
    from ..history.results import results_of
    from ..report.organ_split import columns_of, split_cases, tabulate_splits
    from ..report.tables import (
        format_markdown,
        select_extremes,
        tabulate_gains,
        tabulate_screen,
    )

    cases = study.cases()
    if options.csv:
        cases = [case for case in cases if not case.is_sensitivity]
    is_whole = options.all or options.csv
    splits = {}
    if options.has_split:
        with Progress("cases split") as progress:
            splits = split_cases(
                cases if is_whole else select_extremes(cases), progress.show
            )
    if options.csv:
        table = results_of(cases, columns_of(splits))
        print(printable_lines(table.to_csv(index=False)), end="")
        return
    first, *others = (
        tabulate_gains(cases, None) if options.all else tabulate_screen(cases)
    )
    print(
        printable_lines(
            format_markdown([first, *tabulate_splits(splits), *others])
        )
    )


def _report(options: argparse.Namespace, study: Study) -> None:
    # These imports are slow, and wrong command lines need not wait for them.
    from ..calibration.parameters import read_priors
    from ..figures.cross import read_cross
    from ..report.report import write_report

    # Processes use all cores; threads of libraries would compete with them.
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    cross = read_cross(options.cross) if options.cross else None
    estimates = read_priors(options.estimates) if options.estimates else []
    with Progress("done") as progress:
        written = write_report(
            study,
            options.output,
            cross=cross,
            command=options.command,
            tell=progress.show,
            has_pdf=options.pdf,
            jobs=options.jobs or len(os.sched_getaffinity(0)),
            figures_of=options.figures,
            plants=options.plant,
            has_split=options.has_split,
            selection=options.selection,
            estimates=estimates,
            has_decision=options.has_decision,
        )
    size = written.page.stat().st_size / 1e6
    folder = written.page.parent
    print(
        f"{len(written.figures)} files of figures and their numbers in "
        f"{folder / 'figures'}, a line for each case in "
        f"{folder / 'results.csv'}\nopen {written.page} ({size:.1f} MB)"
    )
