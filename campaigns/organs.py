#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What does each organ do to the light, to differences between plants, to breeding?

organs.py [--full] [--traits SET...] [--seeds N] FOLDER

Breeds ames_quick.toml (with --full also ames.toml) with plants that have more and
more organs, all traits and azimuths alone, in FOLDER, and prints a table: where the
light of the baseline goes, the gain of the same three plants over the baseline with
these organs, and the gains of what is bred with them. Histories that are complete
are not run again. IDEOTYPE_EXECUTABLE names the program, else it is that on PATH.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import re
import subprocess
import sys
from pathlib import Path
from statistics import fmean, stdev

PROGRAM = os.environ.get("IDEOTYPE_EXECUTABLE", "ideotype")
HERE = Path(__file__).parent
TASSEL = ["peduncle", "tassel_spike", "tassel_branches"]

#: Name, crop file and organs besides leaves.
PLANTS = {
    "version 0.1: pole of 27 mm, 2.0 m": ("plants/b73_v01.toml", ["stalk"]),
    "tapered stalk": ("crops/maize.toml", ["stalk"]),
    "and sheaths": ("crops/maize.toml", ["stalk", "sheath"]),
    "and peduncle": ("crops/maize.toml", ["stalk", "sheath", "peduncle"]),
    "and tassel": ("crops/maize.toml", ["stalk", "sheath", *TASSEL]),
    "and ear": ("crops/maize.toml", ["stalk", "sheath", *TASSEL, "ear"]),
}
TRAITS = ("all", "azimuth")
Estimate = tuple[float, float]


def ideotype(*words: object) -> str:
    done = subprocess.run(
        [PROGRAM, *map(str, words)], check=True, capture_output=True, text=True
    )
    return done.stdout


def write_campaign(
    folder: Path, source: str, plant: str, traits: str, seeds: int
) -> Path:
    """A campaign of the project with another plant."""
    crop, organs = PLANTS[plant]
    text = (HERE / source).read_text()
    name = re.sub(r"[^a-z0-9]+", "_", f"{Path(source).stem} {plant} {traits}")[
        :60
    ]
    text = re.sub(
        r'^name = "ames.*"', f'name = "{name}"', text, count=1, flags=re.M
    )
    text = re.sub(r"^replicates = .*\n", "", text, flags=re.M)
    text = text.replace("seed = 1", f"seed = 1\nreplicates = {seeds}", 1)
    text = text.replace(
        'baseline = "crops/maize.toml"',
        f'baseline = "{HERE.resolve() / crop}"\norgans = {json.dumps(organs)}',
    )
    if traits == "azimuth":
        text += '\n[[traits]]\nname = "azimuth"\nfree = ["azimuth"]\n'
    path = folder / f"{name}.toml"
    path.write_text(text)
    return path


def bred(folder: Path, campaign: Path) -> list[Path]:
    """The histories of a campaign, which is run if they are not complete."""
    ideotype("run", campaign, "--resume", "--ranks", "auto", "--out", folder)
    return sorted((folder / campaign.stem).glob("*.h5"))


def difference(found: dict, plant: int) -> Estimate:
    """By what part a plant absorbs more than the first [%], errors paired."""
    base, own = (found["by_randomisation"][i][0] for i in (0, plant))
    gains = [
        100 * (b / fmean(base) - a / fmean(base)) for a, b in zip(base, own)
    ]
    return fmean(gains), stdev(gains) / math.sqrt(len(gains))


def mean_over_seeds(values: list[Estimate]) -> Estimate:
    means = [mean for mean, _ in values]
    error = math.hypot(*(error for _, error in values)) / len(values)
    if len(values) > 1:
        error = max(error, stdev(means) / math.sqrt(len(means)))
    return fmean(means), error


def text_of(value: Estimate) -> str:
    return f"{value[0]:.2f} ± {value[1]:.2f}"


def gain(campaign: Path, histories: list[Path], folder: Path) -> str:
    """Of the best plants over the baseline, under the campaign's own light [%]."""
    base = folder / f"{campaign.stem}_baseline.toml"
    plants = []
    for i, history in enumerate(histories):
        plants.append(folder / f"{campaign.stem}_{i}.toml")
        plants[-1].unlink(missing_ok=True)
        ideotype("export", history, "--best", "--to", plants[-1])
    base.unlink(missing_ok=True)
    ideotype(
        *("export", histories[0], "--generation", 0, "--slot", 0, "--to", base)
    )
    found = json.loads(
        ideotype("evaluate", base, *plants, "--under", campaign, "--json")
    )
    return text_of(
        mean_over_seeds([difference(found, i + 1) for i in range(len(plants))])
    )


def with_organs(text: str, organs: list[str]) -> str:
    """A crop file whose plant has these organs."""
    text = re.sub(
        r"(\[sheath\]\npresent = )\w+",
        lambda m: m[1] + str("sheath" in organs).lower(),
        text,
    )
    return re.sub(
        r'(\[\[organ\]\]\nname = "(\w+)"\npresent = )\w+',
        lambda m: m[1] + str(m[2] in organs).lower(),
        text,
    )


def same_plants(
    folder: Path, plants: list[Path], organs: list[str], under: Path
) -> str:
    """The gain of given plants over the first, with these organs [%]."""
    changed = []
    for plant in plants:
        changed.append(folder / f"same_{plant.name}")
        changed[-1].write_text(with_organs(plant.read_text(), organs))
    found = json.loads(
        ideotype("evaluate", *changed, "--under", under, "--json")
    )
    return ", ".join(
        text_of(difference(found, i)) for i in range(1, len(plants))
    )


def parts(campaign: Path) -> list[str]:
    """Where the light of the baseline goes [% of incident]."""
    found = json.loads(ideotype("evaluate", campaign, "--json"))
    organs = {name: x["mean"] for name, x in found["groups"].items()}

    def of(test: str) -> float:
        return sum(v for k, v in organs.items() if re.fullmatch(test, k))

    shares = [found["leaf"]["mean"], of("stalk"), of("sheath")]
    shares += [of("stalk_(peduncle|tassel).*"), of("sheath_ear")]
    shares += [found["soil"]["mean"], found["reflected"]["mean"]]
    return [f"{100 * share:.2f}" for share in shares]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument(
        "--full", action="store_true", help="breed ames.toml too"
    )
    parser.add_argument(
        "--traits", nargs="+", choices=TRAITS, default=TRAITS, metavar="SET"
    )
    parser.add_argument("--seeds", type=int, default=3, metavar="N")
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    options = parser.parse_args()
    folder = options.folder
    folder.mkdir(parents=True, exist_ok=True)
    sources = ["ames_quick.toml", *(["ames.toml"] if options.full else [])]
    head = [
        "plant",
        "leaves",
        "stalk",
        "sheath",
        "tassel",
        "ear",
        "soil",
        "reflected",
    ]
    head += ["same plants"]
    head += [f"{Path(s).stem}, {t}" for s in sources for t in options.traits]
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head), flush=True)

    reference = "and sheaths"
    campaign = write_campaign(
        folder, "ames_quick.toml", reference, "all", options.seeds
    )
    plants = [folder / "first.toml"]
    histories = bred(folder, campaign)
    plants[0].unlink(missing_ok=True)
    ideotype(
        *(
            "export",
            histories[0],
            "--generation",
            0,
            "--slot",
            0,
            "--to",
            plants[0],
        )
    )
    for i, history in enumerate(histories):
        plants.append(folder / f"bred_{i}.toml")
        plants[-1].unlink(missing_ok=True)
        ideotype("export", history, "--best", "--to", plants[-1])
    exact = folder / "exact.toml"
    exact.write_text(
        re.sub(
            r"(?s)(\[final\].*?paths = )\d+",
            r"\g<1>131072",
            campaign.read_text(),
        )
    )
    for name, (crop, organs) in PLANTS.items():
        cells = parts(
            write_campaign(folder, "ames_quick.toml", name, "all", 1)
        )
        same = crop != "crops/maize.toml"
        cells.append(
            "" if same else same_plants(folder, plants, organs, exact)
        )
        for source in sources:
            for traits in options.traits:
                own = write_campaign(
                    folder, source, name, traits, options.seeds
                )
                cells.append(gain(own, bred(folder, own), folder))
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(error.stderr.strip())
