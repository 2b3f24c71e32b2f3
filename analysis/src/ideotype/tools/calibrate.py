# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype calibrate`: estimates parameters from measurements."""

from __future__ import annotations

import argparse
import sys
import tomllib
from collections.abc import Callable, Sequence
from pathlib import Path

import pandas as pd

from ..common.output import REFUSED, OutputRefused, save_figure, write_file
from ..common.settings import number_within
from ..errors import Error, printable_lines
from ..stand.stand import Stand
from .validate import read_keys

EVALUATIONS = "evaluations.csv"


def main(arguments: Sequence[str] | None = None) -> int:
    """Calibrates parameters and returns the exit code: 0, 1 if a file cannot be
    written or the sampler has not converged, 2 for a wrong command line, 3 for
    invalid data, 4 for a folder with other files."""
    parser = argparse.ArgumentParser(
        prog="ideotype calibrate",
        description="Estimates parameters of the crop and the campaign of a "
        "field from measurements, as a posterior distribution. A command that "
        "was interrupted continues in its folder. docs/calibration.md describes "
        "tables, priors and output.",
    )
    add = parser.add_argument
    add("campaign", type=Path, metavar="CAMPAIGN")
    add("--data", type=Path, required=True, metavar="TABLE.csv",
        help="measurements of the field")  # fmt: skip
    add("--priors", type=Path, metavar="FILE.toml",
        help="priors of parameters (default: the estimates of the crop file "
        "that state a range)")  # fmt: skip
    add("-o", "--out", type=Path, required=True, metavar="FOLDER")
    add("--hold-out", type=number_within(float, 0, 0.9), default=0.0,
        metavar="FRACTION", help="rows of each quantity that are predicted and "
        "not fitted")  # fmt: skip
    add("--predict", nargs=2, action="append", default=[], type=Path,
        metavar=("CAMPAIGN", "TABLE"), help="measurements of another field to "
        "predict")  # fmt: skip
    add("--set", action="append", default=[], metavar="KEY=VALUE",
        help="replace a key of the campaign")  # fmt: skip
    add("--draws", type=number_within(int, 2, 10_000), default=20, metavar="N",
        help="crop files to write (default: 20)")  # fmt: skip
    add("--decision", type=Path, metavar="PLANT",
        help="rank measurements by their value for the gain of a plant (a "
        "history or crop file) over the baseline")  # fmt: skip
    add("--no-emulator", action="store_true",
        help="evaluate each point of the sampler, tens of thousands, instead "
        "of an emulator")  # fmt: skip
    add("--design", type=number_within(int, 10, 100_000), metavar="N",
        help="evaluations from which the emulator is made first")  # fmt: skip
    add("--steps", type=number_within(int, 100, 10_000_000), metavar="N",
        default=20_000, help="largest number of steps of the sampler, which "
        "ends as it converges (default: 20000)")  # fmt: skip
    add("--seed", type=number_within(int, 0, 2**31), default=1)
    options = parser.parse_args(arguments)
    try:
        return _calibrate(options)
    except OutputRefused as error:
        return _fail(REFUSED, error)
    except Error as error:
        return _fail(3, error)
    except OSError as error:
        return _fail(1, error)


def _calibrate(options: argparse.Namespace) -> int:
    from .. import calibration as c
    from ..calibration.figure import draw_posterior, draw_predictions
    from ..calibration.page import format_page

    folder: Path = options.out
    _require_folder(folder)
    keys = read_keys(options.set)
    observations = c.read_observations(
        options.data, options.campaign, hold_out=options.hold_out,
        seed=options.seed, keys=keys,
    )  # fmt: skip
    others = [
        (table, c.read_observations(table, campaign))
        for campaign, table in options.predict
    ]
    parameters = c.read_priors(options.priors or _crop_file(options.campaign))
    folder.mkdir(parents=True, exist_ok=True)
    result = c.calibrate(
        observations,
        parameters,
        evaluations=folder / EVALUATIONS,
        seed=options.seed,
        emulates=not options.no_emulator,
        design=options.design,
        most_steps=options.steps,
    )
    draws = result.draws(options.draws)
    predictions = c.predict(
        result, draws=400 if result.emulator else options.draws
    )
    predicted = [
        (table.name, c.predict(result, rows, options.draws))
        for table, rows in others
    ]
    stands = c.stands_at(observations, parameters, draws, options.seed)
    decision: list[pd.DataFrame] = []
    if options.decision:
        gains = c.decisions(stands, _gain(options.decision))
        decision = [
            c.next_measurements(result, draws, gains),
            c.explained_by_parameter(result, draws, gains),
        ]
    page = format_page(result, predictions, predicted, decision)
    tables = {
        "posterior.csv": result.table(),
        "parameters.csv": result.summary(),
        "predicted.csv": predictions.table,
        "draws.csv": pd.DataFrame(draws, columns=[p.key for p in parameters]),
    }
    text, left_out = c.format_draws(parameters, draws)
    if text:
        missing = f"# Without {', '.join(left_out)}.\n" if left_out else ""
        write_file(folder / "draws.toml", missing + text, folder)
    for name, table in tables.items():
        write_file(folder / name, table.to_csv(index=False), folder)
    for number, stand in enumerate(stands, 1):
        text = stand.crop_file(stand.baseline)
        write_file(folder / "draws" / f"draw{number:03}.toml", text, folder)
    save_figure(draw_posterior(result), folder / "parameters.png")
    save_figure(draw_predictions(predictions), folder / "predicted.png")
    write_file(folder / "calibration.md", page + "\n", folder)
    print(page)
    return 0 if result.samples.has_converged else 1


def _require_folder(folder: Path) -> None:
    """Raises OutputRefused for a folder with files of another kind."""
    if folder.exists() and not folder.is_dir():
        raise OutputRefused(f"{folder}: this is a file; name another folder")
    is_new = not folder.is_dir() or not any(folder.iterdir())
    if not is_new and not (folder / EVALUATIONS).is_file():
        raise OutputRefused(
            f"{folder}: this folder has other files; name a new one"
        )


def _crop_file(campaign: Path) -> Path:
    """Returns the crop file that a campaign names. Raises Error if the plant
    is in the campaign itself."""
    plant = tomllib.loads(campaign.read_text(encoding="utf-8")).get(
        "plant", {}
    )
    name = plant.get("baseline")
    if not isinstance(name, str):
        raise Error(
            f"{campaign}: plant.baseline names no crop file with estimates; "
            "give the priors with --priors"
        )
    return campaign.parent / name


def _gain(plant: Path) -> Callable[[Stand], float]:
    """Returns a function of a stand: the gain of a plant over the baseline in
    the objective, paired."""

    def gain(stand: Stand) -> float:
        found = stand.compare(
            stand.baseline, str(plant), final=False, threads=1
        )
        paired = found.difference(1, 0, (found.objective.name, 0))
        assert paired is not None
        return paired.mean

    return gain


def _fail(code: int, error: Exception) -> int:
    print(printable_lines(f"ideotype calibrate: {error}"), file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
