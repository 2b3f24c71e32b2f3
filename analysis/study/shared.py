# SPDX-License-Identifier: Apache-2.0
"""Functions that the scripts of this folder share: searches by the program,
plants in the light of a campaign, and gains over the baseline of a stand."""

from __future__ import annotations

import argparse
import os
import signal
import subprocess
import sys
import tomllib
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from datetime import date, time
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import Any

import numpy as np
import pandas as pd
import tomli_w
import xarray
from estimates import Estimate, gain
from numpy.typing import NDArray

import ideotype
from ideotype import Search, Stand
from ideotype.history.indices import Indices, indices_of

CAMPAIGNS = Path(__file__).parents[2] / "campaigns"
MAIZE = CAMPAIGNS / "crops" / "maize.toml"
HYBRID = CAMPAIGNS / "crops" / "maize_hybrid.toml"
HYBRID_1980S = CAMPAIGNS / "plants" / "maize_hybrid_1980s.toml"
PLANT_AREA = 0.3991
"""The leaf area of the plant in this file [m2]."""
#: The [field.variation] of inbred lines, and that measured in fields;
#: docs/campaign_files.md states the sources.
MEASURED_LINES = {
    "length": 0.11,
    "width": 0.12,
    "insertion_angle": 9.0,
    "azimuth": 17.3,
    "height": 0.05,
}
FIELD_PLANTS = {
    "length": 0.05,
    "width": 0.06,
    "insertion_angle": 11.0,
    "curvature": 31.0,
    "azimuth": [21.0, 18.0, 28.0],
    "roll": [17.0, 17.0, 35.0],
    "twist": 86.0,
    "height": 0.04,
    "across_row": 0.7,
    "missing": 0.045,
    "late": 0.04,
    "position": 0.035,
}
#: The [field] and [light] of searches with within-line variation. Several
#: small fields are used, so that the standard errors of rows include
#: differences between fields.
SMALL_FIELD = {"rows": 2, "plants": 2, "variation": FIELD_PLANTS}
SEVERAL_FIELDS = {"fields": 4}
Numbers = NDArray[np.float64]
Settings = Sequence[str]
"""Settings as --set takes them: "search.optimizer=ga"."""

TITLES = {
    "absorbed_par": "absorbed PAR, clear day",
    "net_assimilation": "net assimilation, clear day",
    "carbon_balance": "carbon balance, season",
    "grain_yield": "grain, growing season",
}
"""The titles of objectives, with the light under which each is evaluated."""

#: The light of tests: evaluations take milliseconds, with errors of several
#: per cent.
ROUGH: Mapping[str, Any] = {
    "light": {"paths": 64, "randomisations": 4},
    "final": {"candidates": 1, "paths": 256, "randomisations": 4},
}

#: A campaign of the traits that a breeder can select in hybrids, with rows of
#: 30 inches and 6 inches between plants; light and an objective are missing.
BREEDABLE: Mapping[str, Any] = {
    "spacing": [{"name": "30x6", "row": 0.762, "plant": 0.1524}],
    "field": SMALL_FIELD,
    "light": SEVERAL_FIELDS,
    "plant": {"baseline": str(MAIZE), "bounds": "breedable"},
    "final": {"candidates": 3, "paths": 4096, "randomisations": 128},
}

ANYWHERE: Mapping[str, Any] = {
    "name": "plant",
    "site": [{"name": "any", "latitude": 42, "longitude": 0, "utc_offset": 0}],
    "day": [
        {
            "date": date(2025, 8, 7),
            "start": time(12),
            "end": time(13),
            "step_minutes": 60,
        }
    ],
    "spacing": [{"row": 0.76, "plant": 0.15}],
}
"""A campaign for results that do not depend on light; it lacks a plant."""


def guard(main: Callable[[], None]) -> None:
    """Runs a script and ends it with a message in case of an error."""
    try:
        main()
    except subprocess.CalledProcessError as error:
        raise SystemExit(error.stderr.strip() or str(error)) from None
    except (ideotype.Error, OSError) as error:
        raise SystemExit(str(error)) from None


def folder_at(path: str) -> Path:
    """Returns a folder, and creates it if necessary."""
    folder = Path(path).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def parser_of(
    description: str | None, epilog: str | None = None
) -> argparse.ArgumentParser:
    """Returns a parser with the first line of a script's docstring as its
    description."""
    first = (description or "").partition("\n")[0]
    return argparse.ArgumentParser(description=first, epilog=epilog)


def parser_of_searches(
    description: str | None,
    *,
    has_figure: bool = False,
    has_growth: bool = False,
    **counts: int,
) -> argparse.ArgumentParser:
    """Returns the parser of a script that runs searches in a folder. `counts`
    are the names of integer options with their defaults. If `has_growth`, an
    option makes plants grow; otherwise they stand as at silking."""
    parser = parser_of(
        description,
        "Finished searches in the folder are not repeated, and interrupted "
        "ones resume. IDEOTYPE_EXECUTABLE names the program; without it, the "
        "one on PATH is used.",
    )
    parser.add_argument("folder", type=folder_at)
    for name, count in counts.items():
        parser.add_argument(
            f"--{name.replace('_', '-')}", type=int, default=count
        )
    if has_figure:
        parser.add_argument("--figure", type=Path)
    if has_growth:
        parser.add_argument(
            "--growing",
            action="store_true",
            help="let the hybrid grow and age from emergence to maturity",
        )
    parser.add_argument(
        "--rough", action="store_true", help="trace few paths, for tests"
    )
    return parser


def run_parts(
    parser: argparse.ArgumentParser,
    parts: Mapping[str, Callable[[argparse.Namespace], None]],
) -> None:
    """Runs all parts of a script, or only the part that --only names."""
    parser.add_argument("--only", choices=parts)
    options = parser.parse_args()
    for name in [options.only] if options.only else parts:
        before = perf_counter()
        parts[name](options)
        print(flush=True)
        say(f"{name}: {(perf_counter() - before) / 60:.1f} min")


def say(text: str) -> None:
    """Prints a message about progress, separately from the tables."""
    print(text, file=sys.stderr, flush=True)


def campaign_of(campaign: str | Path, **tables: Any) -> dict[str, Any]:
    """Returns the tables of a campaign file, or of a campaign of this project
    by name. `tables` replace some of them. Paths in the result are valid in
    any folder."""
    path = (
        campaign
        if isinstance(campaign, Path)
        else CAMPAIGNS / f"{campaign}.toml"
    )
    found = tomllib.loads(path.read_text())
    parts = [found["plant"], *found.get("component", [])]
    for part in (*parts, *found.get("climate", [])):
        for key in {"baseline", "crop", "file", "mesh"} & part.keys():
            part[key] = str((path.parent / part[key]).resolve())
    return found | tables


def run_program(
    words: Sequence[str], stderr: int | None = None
) -> subprocess.CompletedProcess[str]:
    """Runs a program and returns its output. SIGTERM is passed to the program,
    which ends in order before this script does."""
    with subprocess.Popen(
        words, stdout=subprocess.PIPE, stderr=stderr, text=True
    ) as program:
        before = signal.signal(
            signal.SIGTERM, lambda *_: program.send_signal(signal.SIGTERM)
        )
        out, errors = program.communicate()
        signal.signal(signal.SIGTERM, before)
    return subprocess.CompletedProcess(words, program.returncode, out, errors)


def breed(
    campaign: Path,
    name: str,
    settings: Settings,
    out: Path,
    verb: str = "run",
) -> list[Path]:
    """Runs a campaign and returns the histories of all cases and seeds, in a
    folder with the name of the campaign. Finished histories are kept,
    interrupted ones are resumed. `verb` may be "sensitivity".

    IDEOTYPE_EXECUTABLE names the program; the default is `ideotype` on
    PATH."""
    program = os.environ.get("IDEOTYPE_EXECUTABLE", "ideotype")
    words = [program, verb, str(campaign), "--resume"]
    words += ["--out", str(out)]
    for key in (f"name={name}", *settings):
        words += ["--set", key]
    run_program(words, stderr=subprocess.PIPE).check_returncode()
    return sorted((out / name).glob("*.h5"))


def search_by_package(
    stand: Stand,
    seed: int,
    checkpoints: Sequence[int],
    optimizer: str = "auto",
) -> tuple[list[Any], list[list[float]]]:
    """Searches with the Python package by one thread.

    Returns the number of evaluations, the processor time [s] and the plant
    that the search would return at each checkpoint, and the values of all
    generations, row by row."""
    free = np.asarray(stand.free)
    genes = stand.genes[free]
    search = Search(
        genes.lower,
        genes.upper,
        start=stand.baseline[free],
        optimizer=optimizer,
        seed=seed,
        circular=genes.is_circular,
        traits=list(genes.trait),
    )
    points: list[Any] = []
    generations: list[list[float]] = []
    begin, count = process_time(), 0
    while len(points) < len(checkpoints):
        asked = np.asarray(search.ask())
        found = stand.evaluate(
            asked, [], generation=len(generations), seed=seed, threads=1
        )
        values = objectives(found)
        generations.append(values.mean(axis=1).tolist())
        search.tell(generations[-1])
        count += len(asked)
        while len(points) < len(checkpoints) and (
            count >= checkpoints[len(points)]
        ):
            plant = stand.baseline.copy()
            plant[free] = np.asarray(search.best(1))[0]
            spent = process_time() - begin
            points.append([checkpoints[len(points)], spent, plant.tolist()])
    return points, generations


def breed_tables(
    tables: Mapping[str, Any], folder: Path, verb: str = "run"
) -> list[Path]:
    """Writes a campaign to a file of this folder, runs it and returns its
    histories."""
    path = folder / f"{tables['name']}.toml"
    path.write_text(tomli_w.dumps(tables), encoding="utf-8")
    return breed(path, tables["name"], [], folder, verb)


def sensitivity(tables: Mapping[str, Any], folder: Path) -> dict[str, Indices]:
    """Runs a sensitivity study, and returns the indices of all quantities."""
    (history,) = breed_tables(tables, folder, "sensitivity")
    with ideotype.open_history(history) as opened:
        return indices_of(opened)


def best(history: Path) -> Numbers:
    """Returns the genome of the best plant of a history."""
    with ideotype.open_history(history) as opened:
        found = opened.best()
    if found is None:
        raise ideotype.Error(f"{history}: no plant is evaluated yet")
    if found.row.violation[0] > 0:
        raise ideotype.Error(
            f"{history}: no plant meets the constraints; widen bounds or ranges"
        )
    return np.asarray(found.row.genome[0], float)


def breedable_but(plant: Path, **ranges: Sequence[float]) -> dict[str, Any]:
    """Returns [plant] and [[traits]] of a campaign in which all traits that a
    breeder can select are free; `ranges` replace some of their ranges."""
    rules = tomllib.loads(plant.read_text(encoding="utf-8"))["bounds"]
    bounds = {
        rule["trait"]: rule["range"]
        for rule in rules
        if rule["name"] == "breedable"
    }
    return {
        "plant": {"baseline": str(plant), "bounds": {**bounds, **ranges}},
        "traits": [{"name": "free", "free": list(bounds)}],
    }


def front_of(history: Path) -> Numbers:
    """Returns the genomes of the Pareto front of a history [plants, genes]."""
    with ideotype.open_history(history) as opened:
        front = opened.front()
    if front is None:
        raise ideotype.Error(f"{history}: no plant is evaluated yet")
    return np.asarray(front.members.genome, float)


def words_of(trait: str) -> str:
    """Returns the words of a trait: those of a profile are the trait's."""
    return trait.removesuffix("_profile").replace("_", " ")


def best_plants(tables: Mapping[str, Any], folder: Path) -> list[Numbers]:
    """Returns the genome of the best plant of each seed of a campaign."""
    return [best(path) for path in breed_tables(tables, folder)]


def stand_of(plant: Path, campaign: Path, settings: Settings = ()) -> Stand:
    """Returns the first case of a campaign with the given plant as its
    baseline: the plant of a crop file, or the best plant of a history."""
    with TemporaryDirectory() as folder:
        if plant.suffix == ".h5":
            bred = Stand.from_history(plant, same_isa=False)
            crop = Path(folder) / f"{plant.stem}.toml"
            crop.write_text(bred.crop_file(best(plant)))
        else:
            crop = plant.resolve()
        return Stand.from_campaign(
            campaign, settings=[*settings, f"plant.baseline={crop}"]
        )


def finals(
    stand: Stand, genomes: Numbers, quantities: Sequence[str] = ()
) -> xarray.Dataset:
    """Evaluates plants like finalists, all in the same fields and with common
    random numbers. Raises Error if an evaluation fails."""
    found = stand.evaluate(genomes, list(quantities), final=True)
    for message in found.message.values:
        if message:
            raise ideotype.Error(f"{stand.name}: {message}")
    return found


def objectives(found: xarray.Dataset) -> Numbers:
    """Returns the first objective of evaluated plants [plants,
    randomisations]."""
    return np.asarray(found.objective_by_randomisation[:, 0])


def light(stand: Stand, genomes: Numbers) -> Numbers:
    """Returns the objective of plants as finals() evaluates them [plants,
    randomisations]."""
    return objectives(finals(stand, genomes))


def light_of_baselines(stands: Iterable[Stand]) -> Numbers:
    """Returns the objective of the baseline of each stand, as light() does."""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return np.concatenate(
            list(pool.map(lambda stand: light(stand, stand.baseline), stands))
        )


def leaves(stand: Stand, genome: Numbers) -> pd.DataFrame:
    """Returns one row for each leaf, lowest first, with its traits as
    columns."""
    genes = stand.genes.assign(value=genome).query("leaf > 0")
    return genes.pivot(index="leaf", columns="trait", values="value")


def with_trait(
    stand: Stand, genome: Numbers, trait: str, values: Sequence[float]
) -> Numbers:
    """Returns a plant with the given values of a trait at its leaves."""
    changed = genome.copy()
    changed[(stand.genes.trait == trait).to_numpy()] = values
    return changed


def gain_in(stand: Stand, before: Numbers, after: Numbers) -> Estimate:
    """Returns the gain of one plant over another in the same fields [%]."""
    return gain(*light(stand, np.array([before, after])).tolist())


def gains_over_baseline(
    stand: Stand, plants: Sequence[Numbers]
) -> list[Estimate]:
    """Returns the gain of each plant over the baseline of its stand [%]."""
    baseline, *others = light(
        stand, np.array([stand.baseline, *plants])
    ).tolist()
    return [gain(baseline, each) for each in others]
