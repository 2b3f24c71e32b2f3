# SPDX-License-Identifier: Apache-2.0
"""Maize below rows of modules described by bifacial_radiance.

The example computes the light available to the crop, and the light on both sides
of modules. Keys of bifacial_radiance become settings of a campaign with a field
that repeats with the modules."""

import math
from collections.abc import Mapping
from typing import Any

import matplotlib.pyplot as plt

import ideotype

# The arguments of makeModule() and makeScene() in tutorial 18 of bifacial_radiance.
# ModuleObj and SceneObj store them as module.x, scene.sceneDict and so on.
MODULE = {"x": 1.64, "y": 1.0, "xgap": 0.6096, "numpanels": 1, "ygap": 0.0}
SCENE = {
    "tilt": 18,
    "pitch": 1.8655,
    "clearance_height": 2.4384,
    "azimuth": 180,
    "nMods": 20,
    "nRows": 7,
}
#: Rows of modules that track the sun: arguments of set1axis() and makeScene1axis().
TRACKED = {
    "gcr": 0.4,
    "hub_height": 4.0,
    "axis_azimuth": 180,
    "limit_angle": 55,
}
ROW, PLANT = 0.75, 0.16
"""Approximate distances between rows and between plants in a row [m]."""


def panel_table(
    scene: Mapping[str, Any], module: Mapping[str, Any]
) -> dict[str, Any]:
    """Returns the table [[panel]] of a scene. Numbers of rows and modules are
    ignored, since rows repeat without end."""
    stacked = int(module.get("numpanels", 1))
    width = stacked * module["y"] + (stacked - 1) * module.get("ygap", 0)
    panel = {
        "pitch": scene["pitch"] if "pitch" in scene else width / scene["gcr"],
        "width": width,
        "module_length": module["x"],
        "gap": module.get("xgap", 0.01),
    }
    if "tilt" not in scene:
        axis = scene.get("axis_azimuth", 180)
        return panel | {
            "height": scene["hub_height"],
            "azimuth": (axis - 90) % 360,
            "tracks": True,
            "max_angle": scene.get("limit_angle", 60),
            "backtracks": scene.get("backtrack", True),
        }
    # bifacial_radiance counts the clearance from the lowest edge.
    lift = width / 2 * math.sin(math.radians(scene["tilt"]))
    return panel | {
        "height": scene.get(
            "hub_height", scene.get("clearance_height", 0) + lift
        ),
        "tilt": scene["tilt"],
        "azimuth": scene["azimuth"] % 360,
    }


def field_settings(panel: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the settings of a field with rows parallel to those of modules,
    and with the same period."""
    along = panel["module_length"] + panel["gap"]
    rows, plants = round(panel["pitch"] / ROW), round(along / PLANT)
    return {
        "field.rows": rows,
        "field.plants": plants,
        "spacing.row": panel["pitch"] / rows,
        "spacing.plant": along / plants,
        "spacing.row_direction": (panel["azimuth"] - 90) % 360,
    }


def light_below(scene: Mapping[str, Any]) -> Any:
    """Prints the light of a day, and returns the light that maize absorbs by
    hour, below modules and without them."""
    panel = panel_table(scene, MODULE)
    field = field_settings(panel)

    def light(panels: list[dict[str, Any]]) -> Any:
        stand = ideotype.Stand.from_campaign(
            "campaigns/ames_quick.toml", settings={**field, "panel": panels}
        )
        return stand.evaluate(stand.baseline).isel(plant=0)

    below, alone = light([panel]), light([])
    front, back = below.object_light.sel(object="panel").values
    print(f"front {front:.2f}, back {back:.2f},", end=" ")
    print(f"ground {float(below.ground_light):.2f} MJ m-2 day-1 of PAR")
    remaining = float(below.absorbed_par / alone.absorbed_par)
    print(f"maize absorbs {remaining:.2f} of the light without modules")
    return below.absorbed_by_hour, alone.absorbed_by_hour


plt.figure(figsize=(5, 3.2), layout="constrained")
for name, scene in (("fixed", SCENE), ("tracked", TRACKED)):
    below, alone = light_below(scene)
    plt.plot(below.hour, below, label=f"below {name} modules")
    plt.plot(alone.hour, alone, "--", label=f"without {name} modules")
plt.xlabel("local time [h]")
plt.ylabel("absorbed by leaves [W m$^{-2}$]")
plt.legend()
plt.savefig("20_bifacial_radiance.png")
