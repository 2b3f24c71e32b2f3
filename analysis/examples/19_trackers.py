# SPDX-License-Identifier: Apache-2.0
"""Crop and electricity from the same land, with pvlib.

Modules track the sun over maize; pvlib describes their rows and computes their
power. The land equivalent ratio adds two relative yields: that of the crop over
the crop alone, and that of electricity over modules alone. This example uses
panels of a campaign."""

from dataclasses import replace
from typing import Any

import matplotlib.pyplot as plt
import pandas as pd
from pvlib import pvsystem, temperature

import ideotype

WIDTH, HEIGHT, ROW = 2.4, 4.0, 0.75
"""Width of modules, height of their middle, and row distance of plants [m]."""
EFFICIENCY, BIFACIALITY, LOSS_PER_DEGREE = 0.21, 0.75, -0.0035
AIR = 25.0  # The temperature of the air [deg C].
MOUNT = pvsystem.SingleAxisTrackerMount(
    axis_tilt=0, axis_azimuth=0, max_angle=55, gcr=WIDTH / 6
)


def panel_table(mount: pvsystem.SingleAxisTrackerMount) -> dict[str, Any]:
    """Returns the table [[panel]] of pvlib's mount."""
    return {
        "pitch": WIDTH / mount.gcr,
        "width": WIDTH,
        "height": HEIGHT,
        "azimuth": (mount.axis_azimuth + 90) % 360,
        "tracks": True,
        "max_angle": mount.max_angle,
        "backtracks": mount.backtrack,
    }


def make_stand(rows: int, **settings: Any) -> ideotype.Stand:
    return ideotype.Stand.from_campaign(
        "campaigns/agrivoltaic.toml", settings={"field.rows": rows, **settings}
    )


def daily_yields(stand: ideotype.Stand) -> tuple[float, float]:
    """Returns assimilated CO2 [mol] and electricity [kWh] per day and m2 of
    ground."""
    result = stand.evaluate(stand.baseline, tolerance=0.005).isel(plant=0)
    light = result.object_light_by_hour.sel(object="panel").sum("band")
    front, back = (light.sel(object_side=side) for side in ("front", "back"))
    used = (front + BIFACIALITY * back).values
    cells = temperature.faiman(used, AIR)
    power = pvsystem.pvwatts_dc(used, cells, EFFICIENCY, LOSS_PER_DEGREE)
    both = float((front + back).sum()) * 3600e-6
    # The area of modules per area of ground.
    area = float(result.panel_light) / both
    return float(result.net_assimilation), area * power.sum()


alone = make_stand(8, panel=[]).evaluate(
    make_stand(8).baseline, tolerance=0.005
)
crop_alone = alone.net_assimilation.item()
table = []
for rows in (4, 5, 6, 8, 10, 12):
    panel = [panel_table(replace(MOUNT, gcr=WIDTH / (rows * ROW)))]
    crop, power = daily_yields(make_stand(rows, panel=panel))
    # The plants are so far apart that the modules stand over soil.
    sparse = {"spacing.plant": 10, "field.plants": 1}
    table.append(
        {
            "pitch [m]": rows * ROW,
            "crop [mol m-2]": crop,
            "electricity [kWh m-2]": power,
            "over soil": daily_yields(make_stand(rows, panel=panel, **sparse))[
                1
            ],
        }
    )
yields = pd.DataFrame(table).set_index("pitch [m]")
yields["crop"] = yields["crop [mol m-2]"] / crop_alone
yields["power"] = yields["electricity [kWh m-2]"] / yields["over soil"].max()
yields["land equivalent ratio"] = yields["crop"] + yields["power"]
print(yields.round(3).to_string())
print(f"land equivalent ratio {yields['land equivalent ratio'].max():.2f}")

yields[["crop", "power", "land equivalent ratio"]].plot(
    style="o-", figsize=(5, 3.2)
)
plt.ylabel("yield relative to sole use")
plt.savefig("19_trackers.png", bbox_inches="tight")
