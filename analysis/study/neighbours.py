#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures gains of maize in strips with soybean, and of invaders of a stand.

neighbours.py FOLDER [--only PART] [--evaluations N] [--seeds N] [--figure FILE]
              [--rough]

Part strips optimises crops/maize.toml in the strips of strip.toml for the land
equivalent ratio, and for the net assimilation of maize alone. The ratio is the
sum over both crops of the net assimilation in the strip relative to that of
the sole crop (maize in rows 0.60 m apart with 0.15 m between plants, soybean
0.30 by 0.10 m). The script prints the ratios with their parts; crops of a strip
share its light, so the error of the sum does not follow from the errors of the
parts. The figure has absorbed light and assimilation by row of the strip of
baselines.

Part invaders optimises maize in its own stand at 30 x 6 inches, and as one
plant of 25 among plants of the baseline (invader.toml) and among plants that
are best for the stand. It prints the gain of invaders over their neighbours,
and of a stand of invaders. ± is half of a 95 % interval over randomisations, or
over seeds where that is larger.
"""

from __future__ import annotations

import math
from argparse import Namespace as Options
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from estimates import (
    Estimate,
    estimate,
    gain,
    half_interval,
    interval_of,
    mean_over_seeds,
    plus_minus,
    print_table,
    ratio,
)
from shared import (
    CAMPAIGNS,
    ROUGH,
    Numbers,
    best_plants,
    campaign_of,
    gains_over_baseline,
    guard,
    light,
    parser_of_searches,
    run_parts,
)  # fmt: skip

from ideotype import Stand
from ideotype.common.labels import unit_label
from ideotype.figures.style import BEST, MEAN, RC, new_figure

Tables = Mapping[str, Any]
#: Distances between rows and between plants of sole crops [m].
ALONE = {"maize": (0.6, 0.15), "soybean": (0.3, 0.1)}


def values(stand: Stand, genome: Numbers, name: str) -> list[Estimate]:
    """Returns a quantity of the plant, or of each component if there are
    several."""
    found = stand.evaluate(genome, [name], final=True)
    if found.message.values[0]:
        raise SystemExit(f"{stand.name}: {found.message.values[0]}")
    means = np.atleast_1d(found[name].values[0])
    errors = np.atleast_1d(found[f"{name}_standard_error"].values[0])
    return list(zip(means.tolist(), errors.tolist(), strict=True))


def net_alone(crop: str, common: Tables) -> Estimate:
    """Returns the net assimilation of a sole crop [mol m-2 day-1]."""
    row, plant = ALONE[crop]
    tables = campaign_of("cultivars", **common, name=crop)
    del tables["component"]
    tables["plant"] = {"baseline": str(CAMPAIGNS / "crops" / f"{crop}.toml")}
    tables["spacing"] = [{"row": row, "plant": plant, "row_direction": 0}]
    tables["field"] = {"rows": 4, "plants": 4}
    if crop == "soybean":
        tables["field"]["jitter"] = 180
    stand = Stand(tables)
    return values(stand, stand.baseline, "net_assimilation")[0]


def draw_rows(stand: Stand, genome: Numbers, path: Path) -> None:
    """Draws light, net assimilation and leaf area of each row of a strip, per
    area of the ground closest to the row. The width of a bar is that of this
    ground."""
    found = stand.evaluate(genome, final=True).isel(plant=0)
    panels = {
        "absorbed_light_by_row": "PAR that leaves absorb",
        "net_assimilation_by_row": "net assimilation",
        "lai_by_row": "leaf area index",
    }
    crops = [str(name).rpartition("_")[0] for name in found.field_row.values]
    color = dict(zip(dict.fromkeys(crops), (BEST, MEAN), strict=True))
    with matplotlib.rc_context(RC):
        figure = new_figure(7.2, 2.6)
        each = figure.subplots(1, 3)
        for axes, (name, title) in zip(each, panels.items(), strict=True):
            error = found.get(f"{name}_standard_error")
            axes.bar(
                100 * found.row_position,
                found[name],
                96 * found.row_width,
                color=[color[crop] for crop in crops],
                yerr=None
                if error is None
                else [half_interval(x) for x in error.values],
            )
            axes.set_title(title)
            axes.set_xlabel("across the strip [cm]")
            axes.set_ylabel(f"[{unit_label(found[name].units)}]")
        for crop, one in color.items():
            each[1].bar(0, 0, color=one, label=crop)
        each[1].legend(loc="upper right")
        figure.savefig(path, dpi=200)


def common_of(options: Options) -> dict[str, Any]:
    """Returns the tables that all campaigns share."""
    return {
        "replicates": options.seeds,
        "stop": {"evaluations": options.evaluations},
        "final": {"candidates": 3, "randomisations": 32},
        **(ROUGH if options.rough else {}),
    }


def strips(options: Options) -> None:
    """Prints the land equivalent ratio of the strip before and after
    optimisation."""
    common = common_of(options)
    if options.figure:
        plain = Stand(campaign_of("strip", **common, name="strip"))
        draw_rows(plain, plain.baseline, options.figure)
    alone = [net_alone(crop, common) for crop in ALONE]
    bred_for: dict[str, dict[str, list[float]]] = {
        "both crops by land": {"sole": [net for net, _ in alone]},
        "maize alone": {"weights": [1, 0]},
    }
    plants = {}
    stands = []
    for i, (name, counts) in enumerate(bred_for.items()):
        tables = campaign_of("strip", **common, name=f"strip{i}")
        tables["objective"] |= counts
        stands.append(Stand(tables))
        plants[name] = best_plants(tables, options.folder)
    stand = stands[0]
    plants = {"the baseline": [stand.baseline], **plants}

    def ratios(genome: Numbers) -> list[Estimate]:
        found = values(stand, genome, "net_assimilation_by_component")
        each = [ratio(*pair) for pair in zip(found, alone, strict=True)]
        mean, error = estimate(light(stand, genome)[0].tolist())
        of_alone = [
            part * own / net
            for (part, _), (net, own) in zip(each, alone, strict=True)
        ]
        return [(mean, math.hypot(error, *of_alone)), *each]

    rows = []
    for name, genomes in plants.items():
        by_seed = [ratios(genome) for genome in genomes]
        means = [mean_over_seeds(x) for x in zip(*by_seed, strict=True)]
        gains = gains_over_baseline(stand, genomes)
        more = "" if name == "the baseline" else interval_of(gains)
        rows.append([name, *(plus_minus(x, 3) for x in means), more])
    titles = ["maize bred for", "land equivalent ratio", "maize", "soybean"]
    print_table([*titles, "ratio over the baseline's"], rows)


def invaders(options: Options) -> None:
    """Prints the gain of a single invader over its neighbours, and the gain of
    a stand of invaders over the original stand."""
    common, folder = common_of(options), options.folder
    of_stand = campaign_of("invader", **common, name="stand")
    del of_stand["component"]
    of_stand["objective"] = {"maximise": "net_assimilation"}
    stand = Stand(of_stand)
    best_of_stand = best_plants(of_stand, folder)[0]
    residents = {
        "the baseline": stand.baseline,
        "the stand's best": best_of_stand,
    }
    rows = []
    for i, (name, resident) in enumerate(residents.items()):
        crop = folder / f"resident{i}.toml"
        crop.write_text(stand.crop_file(resident))
        tables = campaign_of("invader", **common, name=f"invader{i}")
        tables["plant"] = {"baseline": str(crop)}
        tables["component"][0]["crop"] = str(crop)
        test = Stand(tables)
        found = best_plants(tables, folder)
        gains = [values(test, each, "invasion")[0] for each in found]
        before, *nets = light(stand, np.array([resident, *found])).tolist()
        rows.append(
            [
                name,
                interval_of([(100 * mean, 100 * e) for mean, e in gains]),
                interval_of([gain(before, net) for net in nets]),
            ]
        )
    titles = ["neighbours", "one bred plant over them"]
    titles += ["a stand of such plants over that of its neighbours"]
    print_table(titles, rows)


def main() -> None:
    parser = parser_of_searches(
        __doc__, has_figure=True, evaluations=960, seeds=1
    )
    run_parts(parser, {"strips": strips, "invaders": invaders})


if __name__ == "__main__":
    guard(main)
