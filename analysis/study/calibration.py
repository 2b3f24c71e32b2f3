#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shows that calibration returns the truth, and asks what it changes in fields.

calibration.py FOLDER [--measured FOLDER] [--only PART] [--sets N] [--rough]

* coverage: data sets made by the program from known parameters, of light,
  leaves and assimilation on a clear day; the coverage of 90 % intervals of six
  parameters, the posterior without data, and pairs that only act together.
* fields: six parameters calibrated with Gainesville 1982 (leaf area, shoots and
  grain by date), and predictions of Ames 1999 and Bondville 1999. --measured is a
  folder with the tables bondville_1999_maize_lai.csv and
  bondville_1999_0501_0930.csv; the project does not contain them.
* bred: a plant bred over 20 draws of the estimates of a crop against one bred at
  the mode, on the mean, worst and best draw.
* validation: facts of `ideotype validate` about growing fields at the mean of
  that posterior.
* twelve: the time of a calibration of 12 parameters.
* shared: the time that draws of photosynthesis save by sharing their light.

Nothing else is fitted."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import time as Hour
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from estimates import print_table
from scipy.special import stdtrit
from shared import (
    CAMPAIGNS,
    best,
    breed,
    guard,
    parser_of_searches,
    run_parts,
    say,
)

from ideotype import Stand, open_history
from ideotype.calibration import (
    Calibration,
    Emulator,
    Evaluations,
    Model,
    Observations,
    Parameter,
    Posterior,
    calibrate,
    format_draws,
    make_observations,
    pairs,
    predict,
    sample,
    values_at,
)
from ideotype.calibration.calibration import design_points, scale_values
from ideotype.calibration.parameters import settings_at
from ideotype.common.settings import format_settings
from ideotype.validation import (
    Measurement,
    compare,
    read_facts,
    shipped_facts,
)

FACTS = Path(str(files("ideotype.validation") / "facts"))
FIELD, GAINESVILLE, AMES = (
    FACTS / f"{name}.toml" for name in ("field", "gainesville", "ames")
)
SMALL: Mapping[str, Any] = {
    "light.tolerance": 0.02,
    "field.rows": 2,
    "field.plants": 2,
}

#: Six parameters of a clear day: priors are those of the crop file (rate_2000,
#: rd) or E, a part of the baseline's.
CLEAR_DAY = [
    Parameter("leaf.all.length", 0.8, 1.2, is_factor=True),
    Parameter("leaf.all.width", 0.8, 1.2, is_factor=True),
    Parameter("leaf.all.insertion_angle", 0.6, 1.4, is_factor=True),
    Parameter("leaf.all.curvature", 0.6, 1.4, is_factor=True),
    Parameter("photosynthesis.rate_2000", 40, 64),
    Parameter("photosynthesis.theta", 0.5, 0.9),
]

#: Six parameters of a season: the area of the largest leaf (0.06 to 0.09 m2),
#: the thermal time between tips (38 to 50 deg C d), the capacity by Collatz (30
#: to 48 umol m-2 s-1), the life of upper leaves, and the estimates of the crop
#: file for roots and kernels. Ranges without a source there are E.
SEASON = [
    Parameter("crop.growth.largest_area", 0.060, 0.090),
    Parameter("crop.growth.interval", 38, 50),
    Parameter("crop.growth.upper_death", 350, 650),
    Parameter("photosynthesis.vmax", 30, 48),
    Parameter("crop.growth.root_share", 0.10, 0.20),
    Parameter("crop.grain.kernels", 385, 600),
]


def clear_day_rows() -> list[Measurement]:
    """Returns the measurements of a clear day, without values: light at four
    times, leaves, and assimilation."""
    rows = []
    for begin, end in ((8, 9), (12, 13), (16, 17)):
        hours = (Hour(begin), Hour(end))
        rows += [
            Measurement("intercepted", "%", math.nan, math.nan, 2, hours=hours),
            Measurement("net_assimilation", "umol m-2 s-1", math.nan, math.nan, 2,
                        hours=hours),
        ]  # fmt: skip
    noon = (Hour(12), Hour(13))
    rows += [
        Measurement("light", "%", math.nan, math.nan, 3, hours=noon, height=x)
        for x in (0.8, 1.4)
    ]
    rows.append(Measurement("lai", "1", math.nan, math.nan, 0.2))
    rows += [
        Measurement("inclination", "deg", math.nan, math.nan, 3, leaves=part)
        for part in ("lower", "middle", "upper")
    ]
    return rows


def with_values(observations: Observations, values: Any) -> Observations:
    """Returns rows with measured values."""
    rows = [
        replace(row, low=float(x), high=float(x))
        for row, x in zip(observations.rows, values)
    ]
    return replace(observations, rows=rows, is_fitted=np.ones(len(rows), bool))


def show_coverage(folder: Path, sets: int, design: int) -> None:
    """Prints the coverage of intervals over data sets."""
    began, cpu = time.perf_counter(), time.process_time()
    observations = make_observations(clear_day_rows(), FIELD, keys=SMALL)
    stored = Evaluations(folder / "coverage.csv", "# coverage")
    model = Model(observations, CLEAR_DAY, stored)
    points = design_points(CLEAR_DAY, design, 1)
    emulator = Emulator.make(
        scale_values(CLEAR_DAY, points), model.evaluate(points, about="design")
    )
    own = model.own_errors(values_at(CLEAR_DAY, np.zeros(len(CLEAR_DAY))))
    random = np.random.default_rng(2)
    inside = np.zeros((sets, len(CLEAR_DAY)), bool)
    shrinkages, slow = [], 0
    for number in range(sets):
        z = random.normal(size=(1, len(CLEAR_DAY)))
        truth = values_at(CLEAR_DAY, z)
        exact = model.evaluate(truth, seed=100 + number)[0]
        # The discrepancy of each quantity is drawn from its prior.
        scale = dict[str, float]()
        for row, value in zip(observations.rows, exact):
            scale.setdefault(
                row.quantity, 0.1 * abs(value) * abs(random.normal())
            )
        noise = np.array(
            [math.hypot(r.error, scale[r.quantity]) for r in observations.rows]
        )
        data = with_values(
            observations, exact + noise * random.normal(size=len(exact))
        )
        posterior = Posterior(
            CLEAR_DAY, data, lambda x: emulator(scale_values(CLEAR_DAY, x)),
            own**2 + emulator.error**2,
        )  # fmt: skip
        samples = sample(
            posterior,
            posterior.size,
            number,
            ensembles=2,
            block=600,
            most=1800,
        )
        slow += not samples.r_hat.max() < 1.05
        low, high = np.quantile(
            samples.z[:, : len(CLEAR_DAY)], [0.05, 0.95], axis=0
        )
        inside[number] = (low <= z[0]) & (z[0] <= high)
        shrinkages.append(1 - samples.z[:, : len(CLEAR_DAY)].var(axis=0))
    rows = [
        [p.key, f"{100 * x:.0f}", f"{s:.2f}"]
        for p, x, s in zip(
            CLEAR_DAY, inside.mean(axis=0), np.mean(shrinkages, axis=0)
        )
    ]
    rows.append(["all", f"{100 * inside.mean():.1f}", ""])
    print_table(
        [
            "parameter",
            f"inside 90 % intervals [% of {sets} sets]",
            "shrinkage",
        ],
        rows,
    )
    print(
        f"{slow} of {sets} sets with an R-hat above 1.05; emulator of {design} "
        f"evaluations; {time.process_time() - cpu:.0f} s of processor time, "
        f"{time.perf_counter() - began:.0f} s"
    )


def show_limits(folder: Path) -> None:
    """Prints the posterior without data, and the pairs of leaf area and light
    alone."""
    rows = clear_day_rows()
    observations = make_observations(rows, FIELD, keys=SMALL)
    empty = calibrate(observations, CLEAR_DAY, design=60)
    table = empty.summary()
    print_table(
        ["parameter", "prior", "low", "high", "shrinkage"],
        [
            [x.parameter, x.prior, f"{x.low:.3g}", f"{x.high:.3g}",
             f"{x.shrinkage:.3f}"]
            for x in table.itertuples()
        ],
    )  # fmt: skip
    # A field of equal plants has no error of ours in leaf area.
    chosen = [x for x in rows if x.quantity in ("intercepted", "lai")]
    even = {**SMALL, "field.variation": {}}
    few = make_observations(
        [replace(x, error=x.error / 2) for x in chosen], FIELD, keys=even
    )
    exact = Model(few, CLEAR_DAY, Evaluations(None)).evaluate(
        values_at(CLEAR_DAY, np.zeros((1, len(CLEAR_DAY)))), seed=100
    )[0]
    found = calibrate(
        with_values(few, exact), CLEAR_DAY, design=60,
        has_discrepancy=False,
    )  # fmt: skip
    print_table(
        ["act together", "", "correlation", "deviation", "if the second is known"],
        [
            [x.first, x.second, f"{x.correlation:.2f}", f"{x.deviation:.2f}",
             f"{x.deviation_if_known:.2f}"]
            for x in pairs(found).itertuples()
        ],
    )  # fmt: skip


def read_rows(
    *tables: tuple[str, Sequence[tuple[str, float, str]]],
) -> list[Measurement]:
    """Returns rows (date, value) of quantities; see `GRAIN`."""
    from datetime import date

    return [
        Measurement(
            name, unit, value, value, math.nan, date.fromisoformat(day)
        )
        for name, rows in tables
        for day, value, unit in rows
    ]


#: Grain by date, irrigated with much nitrogen: DSSAT/dssat-csm-data ac780c7,
#: Maize/UFGA8201.MZT and IUAF9901.MZT, treatments 4.
GRAIN = {
    "gainesville": [("1982-07-08", 11881.0, "kg ha-1")],
    "ames": [("1999-10-25", 10350.0, "kg ha-1")],
}


def field_rows() -> dict[str, list[Measurement]]:
    """Returns the measurements of Gainesville and Ames."""
    from ideotype.validation import read_table

    return {
        "gainesville": [
            *read_table(FACTS / "gainesville.csv"),
            *read_table(FACTS / "gainesville_shoots.csv"),
            *read_rows(("grain", GRAIN["gainesville"])),
        ],
        "ames": [
            *read_table(FACTS / "ames_shoots.csv"),
            *read_rows(
                ("grain", GRAIN["ames"]), ("lai", [("1999-08-13", 4.0, "1")])
            ),
        ],
    }


def bondville(folder: Path, measured: Path) -> Observations:
    """Returns leaf area by date at Bondville 1999, with the campaign of
    campaigns/growing_season.toml in its weather."""
    campaign = (CAMPAIGNS / "growing_season.toml").read_text(encoding="utf-8")
    head, _, rest = campaign.partition("[[climate]]")
    tail = rest[rest.index("[[spacing]]") :]
    weather = (measured / "bondville_1999_0501_0930.csv").resolve()
    text = (
        head
        + f"""[[climate]]
name = "1999"
file = "{weather}"
from = 1999-05-01
to = 1999-09-30
emergence = 1999-05-20
time = ["time"]
stamp = "middle"
global = ["ppfd_umol", "umol/m2/s"]
temperature = ["temp_c", "C"]
humidity = ["rh", "1"]

"""
        + tail.replace(
            'baseline = "crops/', f'baseline = "{CAMPAIGNS}/crops/'
        ).replace('over = ["climate"]', "")
    )
    path = folder / "bondville_1999.toml"
    path.write_text(text, encoding="utf-8")
    table = pd.read_csv(measured / "bondville_1999_maize_lai.csv", comment="#")
    rows = read_rows(
        ("lai", [(x.date, x.lai, "m2 m-2") for x in table.itertuples()])
    )
    return make_observations(rows, path, keys=SMALL)


def calibrate_fields(
    folder: Path, parameters: Sequence[Parameter], design: int | None
) -> Calibration:
    """Calibrates parameters with Gainesville 1982."""
    rows = make_observations(
        field_rows()["gainesville"], GAINESVILLE, keys=SMALL
    )
    return calibrate(
        rows, parameters, design=design,
        evaluations=folder / f"gainesville_{len(parameters)}.csv",
    )  # fmt: skip


def show_errors(name: str, table: pd.DataFrame) -> list[list[str]]:
    return [
        [name, x.quantity, str(x.rows), f"{x.before:.3g}", f"{x.after:.3g}", x.unit,
         f"{x.inside:.2f}"]
        for x in table.itertuples()
    ]  # fmt: skip


def show_fields(
    folder: Path, measured: Path | None, design: int | None
) -> None:
    """Prints errors before and after calibration."""
    result = calibrate_fields(folder, SEASON, design)
    print(
        result.summary().to_string(index=False, float_format="{:.3g}".format)
    )
    stored = result.model.evaluations
    print(
        f"{len(stored)} evaluations, {stored.seconds:.0f} s; emulator error "
        f"{result.checks[-1].relative:.2f} of the known error at most; R-hat "
        f"{result.samples.r_hat.max():.3f}"
    )
    lines = show_errors("Gainesville 1982 (fitted)", predict(result).errors())
    ames = make_observations(field_rows()["ames"], AMES, keys=SMALL)
    lines += show_errors("Ames 1999", predict(result, ames, 12).errors())
    if measured:
        there = bondville(folder, measured)
        lines += show_errors(
            "Bondville 1999", predict(result, there, 8).errors()
        )
    print_table(
        ["field", "quantity", "rows", "error before", "after", "unit",
         "inside 90 % intervals"], lines,
    )  # fmt: skip
    for pair in pairs(result).itertuples():
        print(
            f"act together: {pair.first}, {pair.second}: {pair.correlation:.2f}"
        )


def write_robust(
    path: Path, parameters: Sequence[Parameter], values: np.ndarray
) -> Path:
    """Writes the field of a clear day with draws of parameters."""
    text, _ = format_draws(parameters, values)
    campaign = FIELD.read_text(encoding="utf-8").replace(
        '"crops/', f'"{FACTS}/crops/'
    )
    path.write_text(f"{campaign}\n{text}", encoding="utf-8")
    return path


def show_bred(folder: Path, evaluations: int, draws: int, seeds: int) -> None:
    """Prints plants of searches over draws of the estimates against plants of
    searches at their middle."""
    parameters = [*CLEAR_DAY[4:], Parameter("photosynthesis.rd", 1, 3)]
    z = np.random.default_rng(3).normal(size=(2 * draws, len(parameters)))
    used, new = np.split(values_at(parameters, z), 2)
    keys = {
        **SMALL, "plant.bounds": "breedable", "objective.over": ["draw"],
        "objective.maximise": "net_assimilation",
    }  # fmt: skip
    middle = values_at(parameters, np.zeros((1, len(parameters))))
    ways = {"middle": (middle, "mean"), "mean": (used, "mean"),
            "worst": (used, "worst")}  # fmt: skip
    plants = {}
    for name, (points, rule) in ways.items():
        path = write_robust(folder / f"{name}.toml", parameters, points)
        settings = {
            **keys, "objective.scenarios": rule, "replicates": seeds,
            "stop.evaluations": evaluations,
        }  # fmt: skip
        histories = breed(
            path, f"bred_{name}", format_settings(settings), folder
        )
        plants[name] = [best(history) for history in histories]
        seconds = np.mean([seconds_of(history) for history in histories])
        say(f"{name}: {seconds:.0f} CPU-s for each search")
    for title, points in (("the same draws", used), ("other draws", new)):
        stand = Stand.from_campaign(
            write_robust(folder / "judged.toml", parameters, points),
            settings=keys,
        )
        genomes = [stand.baseline, *np.concatenate([*plants.values()])]
        column = "net_assimilation_by_scenario"
        values = stand.evaluate(genomes, [column], final=True)[column].values
        gains = 100 * (values[1:] / values[0] - 1)
        of_draws = {
            "mean gain [%]": gains.mean(1),
            "worst": gains.min(1),
            "best": gains.max(1),
            "draws better than the baseline": (gains > 0).mean(1),
            "regret": (gains.max(0) - gains).mean(1),
        }
        print(f"On {title} ({seeds} searches each):\n")
        print_table(
            ["bred over", *of_draws],
            [
                [
                    name,
                    *(
                        plus_minus_of(x.reshape(len(ways), seeds)[i])
                        for x in of_draws.values()
                    ),
                ]
                for i, name in enumerate(ways)
            ],
        )
        by_way = of_draws["mean gain [%]"].reshape(len(ways), seeds)
        print(
            "\nmean over draws less middle, paired by the seed: "
            f"{plus_minus_of(by_way[1] - by_way[0])}\n"
        )


def plus_minus_of(values: np.ndarray) -> str:
    """Returns a mean over searches with half of its 95 % interval."""
    count = len(values)
    half = values.std(ddof=1) * stdtrit(count - 1, 0.975) / count**0.5
    return f"{values.mean():.2f} ± {half:.2f}"


def seconds_of(history: Path) -> float:
    """Returns the time of all evaluations of a history [s]."""
    with open_history(history) as opened:
        return float(opened.evaluations().done.seconds.sum())


def show_twelve(folder: Path) -> None:
    """Prints the time of a calibration of 12 parameters with a clear day."""
    more = [
        Parameter("photosynthesis.rd", 1, 3),
        Parameter("optics.leaf_reflectance", 0.04, 0.10),
        Parameter("optics.leaf_transmittance", 0.02, 0.08),
        Parameter("leaf.upper.insertion_angle", 0.8, 1.2, is_factor=True),
        Parameter("crop.sheath.length", 0.13, 0.20),
        Parameter("optics.soil_albedo", 0.05, 0.2),
    ]
    parameters = CLEAR_DAY + more
    rows = make_observations(clear_day_rows(), FIELD, keys=SMALL)
    truth = values_at(parameters, np.zeros((1, len(parameters))))
    exact = Model(rows, parameters, Evaluations(None)).evaluate(
        truth, seed=100
    )
    cpu, began = time.process_time(), time.perf_counter()
    result = calibrate(
        with_values(rows, exact[0]), parameters,
        evaluations=folder / "twelve.csv",
    )  # fmt: skip
    stored = result.model.evaluations
    print(
        f"12 parameters: {len(stored)} evaluations in {stored.seconds:.0f} s, all "
        f"in {time.process_time() - cpu:.0f} s of processor time, "
        f"{time.perf_counter() - began:.0f} s; R-hat "
        f"{result.samples.r_hat.max():.3f}, emulator error "
        f"{result.checks[-1].relative:.2f}"
    )


def show_shared(folder: Path, draws: int = 20) -> None:
    """Prints the processor time of an evaluation, and of one over draws of
    photosynthesis, which share their light."""
    parameters = [*CLEAR_DAY[4:], Parameter("photosynthesis.rd", 1, 3)]
    z = np.random.default_rng(3).normal(size=(draws, len(parameters)))
    robust = write_robust(
        folder / "robust.toml", parameters, values_at(parameters, z)
    )
    keys = {**SMALL, "objective.maximise": "net_assimilation"}
    alone = Stand.from_campaign(FIELD, settings=keys)
    together = Stand.from_campaign(
        robust, settings={**keys, "objective.over": ["draw"]}
    )
    times = []
    for stand, count in ((alone, 100), (together, 20)):
        stand.evaluate_one(stand.start)
        cpu = time.process_time()
        for generation in range(count):
            stand.evaluate_one(stand.start, generation=generation)
        times.append((time.process_time() - cpu) / count)
    one, all_draws = times
    print(
        f"one evaluation {1000 * one:.1f} ms, {draws} draws of photosynthesis "
        f"that share their light {1000 * all_draws:.1f} ms: "
        f"{draws * one / all_draws:.1f} times less than {draws} evaluations"
    )


def show_validation(folder: Path) -> None:
    """Prints facts of growing fields at the mean of the posterior of
    Gainesville, and as files state the parameters."""
    result = calibrate_fields(folder, SEASON, None)
    keys = settings_at(SEASON, result.values.mean(axis=0))
    facts = read_facts(shipped_facts()).named(
        ["gainesville_lai", "gainesville_shoots", "ames_shoots"]
    )
    lines = []
    for fact in facts:
        before, after = compare(fact, 2), compare(fact, 2, keys)
        held_out = "held out" if fact.name == "ames_shoots" else "fitted"
        lines.append(
            [
                fact.name,
                held_out,
                *(
                    f"{x.verdict}: {sum(p.agrees for p in x.points)} of "
                    f"{len(x.points)}"
                    for x in (before, after)
                ),
            ]
        )
    print_table(["fact", "", "before: points that agree", "after"], lines)


def main() -> None:
    parser = parser_of_searches(__doc__, sets=100)
    parser.add_argument("--measured", type=Path)
    run_parts(
        parser,
        {
            "coverage": lambda x: show_coverage(
                x.folder, 2 if x.rough else x.sets, 20 if x.rough else 150
            ),
            "limits": lambda x: show_limits(x.folder),
            "fields": lambda x: show_fields(
                x.folder, x.measured, 20 if x.rough else None
            ),
            "bred": lambda x: show_bred(
                x.folder,
                64 if x.rough else 640,
                3 if x.rough else 20,
                2 if x.rough else 8,
            ),
            "twelve": lambda x: show_twelve(x.folder),
            "shared": lambda x: show_shared(x.folder),
            "validation": lambda x: show_validation(x.folder),
        },
    )


if __name__ == "__main__":
    guard(main)
