# SPDX-License-Identifier: Apache-2.0
"""Maize below rows of modules that bifacial_radiance describes.

How much light is left to the crop, and what falls on both sides of modules? The
words of another program become settings of a campaign, whose field has to repeat
with the modules. This teaches how to take over a scene."""

import math
from collections.abc import Mapping
from typing import Any

import matplotlib.pyplot as plt

import ideotype

# As bifacial_radiance has them: what makeModule() and makeScene() take. Its tutorial 18
# has these; ModuleObj and SceneObj keep them as module.x, scene.sceneDict and so on.
MODULE = {"x": 1.64, "y": 1.0, "xgap": 0.6096, "numpanels": 1, "ygap": 0.0}
SCENE = {
    "tilt": 18,
    "pitch": 1.8655,
    "clearance_height": 2.4384,
    "azimuth": 180,
    "nMods": 20,
    "nRows": 7,
}
#: Rows of a [[panel]] that track the sun, as set1axis() and makeScene1axis() have them.
TRACKED = {
    "gcr": 0.4,
    "hub_height": 4.0,
    "axis_azimuth": 180,
    "limit_angle": 55,
}
ROW, PLANT = 0.75, 0.16
"""About how far plants shall be apart [m]."""


def panel_of(
    scene: Mapping[str, Any], module: Mapping[str, Any]
) -> dict[str, Any]:
    """The table [[panel]] of a scene; rows and modules are without number here."""
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


def field_of(panel: Mapping[str, Any]) -> dict[str, Any]:
    """Settings of a field whose rows are parallel to those of modules, and with
    which they repeat."""
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
    """Prints the light of a day, and returns the maize's by hour, below modules
    and without them."""
    panel = panel_of(scene, MODULE)
    field = field_of(panel)

    def light(panels: list[dict[str, Any]]) -> Any:
        stand = ideotype.Stand.from_campaign(
            "campaigns/ames_quick.toml", settings={**field, "panel": panels}
        )
        return stand.evaluate(stand.baseline).isel(plant=0)

    below, alone = light([panel]), light([])
    front, back = below.object_light.sel(object="panel").values
    print(f"front {front:.2f}, back {back:.2f},", end=" ")
    print(f"ground {float(below.ground_light):.2f} MJ m-2 day-1 of PAR")
    left = float(below.absorbed_par / alone.absorbed_par)
    print(f"light that is left to maize {left:.2f}")
    return below.absorbed_by_hour, alone.absorbed_by_hour


plt.figure(figsize=(5, 3.2), layout="constrained")
for name, scene in (("fixed", SCENE), ("tracked", TRACKED)):
    below, alone = light_below(scene)
    plt.plot(below.hour, below, label=f"below {name} modules")
    plt.plot(alone.hour, alone, "--", label=f"without {name} modules")
plt.xlabel("clock [h]")
plt.ylabel("absorbed by leaves [W m$^{-2}$]")
plt.legend()
plt.savefig("20_bifacial_radiance.png")
