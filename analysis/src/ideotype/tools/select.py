# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype select`: from a trial of lines to a selection index
and a breeding programme."""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

from ..common.output import REFUSED, OutputRefused
from ..common.progress import Progress
from ..common.settings import number_within
from ..errors import Error, InputError, printable_lines

STORE = "evaluations.sqlite"
"""The file with all evaluations, from which a selection resumes."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs a selection and returns the exit code: 0, 1 after a failure, 2 for
    a wrong command line, 3 for an invalid campaign or trial, 4 if the folder
    belongs to another selection."""
    options = _parser().parse_args(arguments)
    try:
        _select(options)
        return 0
    except OutputRefused as error:
        return _fail(REFUSED, error)
    except InputError as error:
        return _fail(3, error)
    except (Error, OSError, MemoryError) as error:
        return _fail(3 if isinstance(error, Error) else 1, error)


def _fail(code: int, error: Exception) -> int:
    print(printable_lines(f"ideotype select: {error}"), file=sys.stderr)
    return code


def _select(words: argparse.Namespace) -> None:
    # These imports are slow, and wrong command lines need not wait for them.
    from ..selection.field import Field
    from ..selection.genetics import estimate, read_lines
    from ..selection.page import format_page, format_taken, write_selection
    from ..selection.programme import Method, Plan
    from ..selection.selection import Options, digest_inputs, select
    from ..selection.store import Store
    from ..selection.trial import read_trial

    folder: Path = words.out
    _require_folder(folder)
    taken = None
    if words.trial:
        trial = read_trial(words.trial, dict(words.trait))
        taken = trial.taken
        print("\n".join(format_taken(taken)), "\n", sep="")
        population = estimate(trial, seed=words.seed)
    else:
        population = read_lines(
            words.lines, count=words.line_count, seed=words.seed
        )
    plan = Plan(
        cycles=words.cycles,
        lines=words.tested,
        parents=words.parents,
        crosses=words.crosses,
        plots=words.plots,
        untested=words.untested,
        **{f"{name}_cost": cost for name, cost in words.cost},
    )
    options = Options(
        plan=plan,
        methods=tuple(map(Method, words.method or Method)),
        repeats=words.repeats,
        draws=words.draws,
        line_draws=words.line_draws,
        is_traced=words.values == "traced",
        yield_heritability=words.yield_heritability,
        seed=words.seed,
    )
    inputs = (words.trial, words.lines, words.history, words.markers,
              words.effects)  # fmt: skip
    digest = digest_inputs(
        *inputs, words.campaign, words.set, words.trait, words.line_count,
        words.tolerance, options, version("ideotype"),
    )  # fmt: skip
    folder.mkdir(parents=True, exist_ok=True)
    store = Store(folder / STORE, digest)
    try:
        under = Field(
            words.campaign,
            population.of_plants().traits,
            settings=words.set,
            store=store,
            threads=words.threads,
            tolerance=words.tolerance,
        )
        with Progress("evaluated") as progress:
            selection = select(
                population,
                under,
                options,
                history=words.history,
                markers=words.markers,
                effects=words.effects,
                on_progress=progress.show,
            )
    finally:
        store.close()
    paths = write_selection(selection, folder, taken)
    page = format_page(selection)
    print(page)
    print(f"{len(paths)} files in {folder}; see {folder / 'selection.md'}")


def _require_folder(folder: Path) -> None:
    """Raises OutputRefused for a folder with other files than a selection."""
    if folder.exists() and (
        not folder.is_dir()
        or (any(folder.iterdir()) and not (folder / STORE).is_file())
    ):
        raise OutputRefused(
            f"{folder}: this exists and is no folder of a selection; name "
            "another"
        )


def _pair(word: str) -> tuple[str, str]:
    name, is_set, value = word.partition("=")
    if not is_set:
        raise argparse.ArgumentTypeError(f"{word} (expected: NAME=VALUE)")
    return name, value


def _cost(word: str) -> tuple[str, float]:
    name, value = _pair(word)
    kinds = ("plot", "cross", "line", "genotype")
    if name not in kinds:
        raise argparse.ArgumentTypeError(
            f"{word} (expected: {', '.join(kinds)} = a number)"
        )
    return name, float(number_within(float, 0, 1e12)(value))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="ideotype select",
        description="Computes by which traits, and in how many cycles, lines "
        "can be bred towards the objective of a campaign: economic weights "
        "from traced light, selection indices, and programmes. "
        "A stopped command resumes when it is repeated.",
        epilog="Exit codes: 0 success, 1 failure, 2 wrong usage, 3 invalid "
        "input, 4 the folder belongs to another selection.",
    )
    add = parser.add_argument
    add("campaign", type=Path, metavar="CAMPAIGN", help="campaign file")
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument(
        "--trial", type=Path, metavar="FILE",
        help="trial with a row for each plot or line (.csv), or observations "
        "of BrAPI 2 (.json)",
    )  # fmt: skip
    source.add_argument(
        "--lines", type=Path, metavar="FILE",
        help="file of lines (.toml), as campaigns/lines/maize_panel.toml",
    )  # fmt: skip
    add("-o", "--out", type=Path, required=True, metavar="FOLDER",
        help="folder for all results")  # fmt: skip
    add(
        "--trait", action="append", default=[], type=_pair,
        metavar="COLUMN=MEASURE@LEAF,UNIT",
        help="measure of a column that its name does not state, such as "
        "LL7=leaf.length@ear,cm",
    )  # fmt: skip
    add(
        "--line-count", type=number_within(int, 0, 10**6), default=0,
        metavar="N", help="number of lines behind --lines, for errors of G",
    )  # fmt: skip
    add(
        "--history", type=Path, metavar="FILE",
        help="history of a search with this objective: its best plant is the "
        "ceiling",
    )  # fmt: skip
    add("--markers", type=Path, metavar="FILE",
        help="markers of your lines (.csv)")  # fmt: skip
    add("--effects", type=Path, metavar="FILE",
        help="effects of these markers on the traits (.csv)")  # fmt: skip
    add("--set", action="append", default=[], metavar="KEY=VALUE",
        help="replace a key of the campaign")  # fmt: skip
    add(
        "--method", action="append", choices=["yield", "index", "genomic"],
        help="criterion of selection; may be repeated (default: all three)",
    )  # fmt: skip
    numbers = (
        ("cycles", 1, 100, 5, "number of cycles"),
        ("tested", 5, 10000, 100, "lines in the trial of each cycle"),
        ("parents", 2, 1000, 10, "selected lines of a cycle"),
        ("crosses", 1, 1000, 10, "crosses of a cycle, and listed crosses"),
        ("plots", 1, 1000, 2, "plots of a line"),
        ("untested", 0, 100000, 200,
         "further lines that genomic selection predicts"),
        ("repeats", 1, 10000, 3, "programmes of each method"),
        ("draws", 1, 10000, 16, "draws of fields and light for the gradient"),
        ("line-draws", 1, 10000, 8, "draws for lines, crosses and targets"),
        ("seed", 0, 2**31, 1, "seed of genetics and errors"),
    )  # fmt: skip
    for name, low, high, default, about in numbers:
        add(
            f"--{name}", type=number_within(int, low, high), metavar="N",
            default=default, help=f"{about} (default: {default})",
        )  # fmt: skip
    add(
        "--values", choices=["traced", "quadratic"], default="traced",
        help="genotypes of programmes are evaluated with traced light "
        "(default), or by a quadratic approximation",
    )  # fmt: skip
    add(
        "--yield-heritability", type=number_within(float, 0, 1),
        default=math.nan, metavar="X",
        help="of a plot (default: that of the trial, or 0.12)",
    )  # fmt: skip
    add(
        "--cost", action="append", default=[], type=_cost, metavar="KIND=X",
        help="cost of a plot, cross, line or genotype",
    )  # fmt: skip
    add(
        "--tolerance", type=number_within(float, 1e-5, 0.05), metavar="X",
        help="relative standard error of the light absorbed by leaves in an "
        "evaluation (default: that of the campaign)",
    )  # fmt: skip
    add(
        "--threads", type=number_within(int, 1, 4096), metavar="N",
        help="number of threads (default: one per core)",
    )  # fmt: skip
    return parser


if __name__ == "__main__":
    sys.exit(main())
