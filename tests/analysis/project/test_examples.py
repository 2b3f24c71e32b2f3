# SPDX-License-Identifier: Apache-2.0
"""The examples of analysis/examples run as users start them."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path
from types import ModuleType

import pandas as pd
import pytest
from PIL import Image
from real_program import executable

TOP = Path(__file__).parents[3]
EXAMPLES = TOP / "analysis" / "examples"
GALLERY = TOP / "docs" / "figures" / "gallery"


def module(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec and spec.loader
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    return made


draw = module(EXAMPLES / "draw.py")

# A number that each example prints, and its bounds.
TOLD = {
    "01_sheet.py": (r"theory (\d\.\d+)", 0, 0.004),
    "03_leaf_temperature.py": (r"by (\d\.\d) to", 2.5, 4),
    "04_one_plant.py": (r"leaf (\d+) absorbs", 6, 10),
    "06_density.py": (r"light at (\d+\.\d)", 6, 14),
    "08_row_direction.py": (r"absorb (\d+\.\d+) MJ", 9.5, 11),
    "09_campaign.sh": (r"= (\d+\.\d+) ±", 10, 25),
    "10_pycma.py": (r"gain (\d+\.\d) %", 18, 30),
    "11_optuna.py": (r"gain (\d+\.\d) %", 2, 30),
    "12_main_study.ipynb": (r"gain (\d+\.\d) ± 0\.[0-4] %", 20, 30),
    "14_strips.py": (r"assimilates (\d\.\d+) times", 0.4, 0.9),
    "15_growing.py": (r"index (\d\.\d)", 2, 6),
    "16_sensitivity.sh": (r"; (\d+) samples", 64, 64),
    "17_libensemble.py": (r"160 plants, gain (\d+\.\d) %", 12, 30),
    "19_trackers.py": (r"(?m)^land equivalent ratio (\d+\.\d+)$", 0.9, 1.2),
    "20_bifacial_radiance.py": (r"maize absorbs (\d+\.\d+) of", 0.5, 0.8),
}
TABLES = {"02_any_mesh.sh": 7, "05_day.sh": 27, "09_campaign.sh": 12}
"""The numbers of rows of the tables that examples write."""
IN_CPP = {"07_mesh.cpp", "13_responses.cpp", "18_field.cpp"}
"""These are built with the installed library, by Install.package."""


@pytest.mark.parametrize("name", sorted(TOLD.keys() | TABLES.keys()))
def test_the_result_of_an_example_is_within_its_range(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if name.endswith(".sh"):
        monkeypatch.setenv("IDEOTYPE_EXECUTABLE", str(executable()))
    said = draw.run(EXAMPLES / name, tmp_path)
    if name in TOLD:
        pattern, least, upper = TOLD[name]
        found = re.search(pattern, said)
        assert found, said
        assert least <= float(found[1]) <= upper
    stem = tmp_path / name.partition(".")[0]
    if name in TABLES:
        table = pd.read_csv(stem.with_suffix(".csv"))
        assert len(table) == TABLES[name]
        assert (table.iloc[:, 1:] > 0).all(axis=None)
    elif not name.endswith(".sh"):
        assert stem.with_suffix(".png").stat().st_size > 3000


def test_every_example_is_tested_and_drawn() -> None:
    names = {path.name for path in draw.examples()}
    assert names == TOLD.keys() | TABLES.keys() | IN_CPP
    assert len(names) == 20
    pictures = {path.stem for path in GALLERY.iterdir()}
    assert pictures == {path.stem for path in draw.examples()}
    for path in GALLERY.iterdir():
        assert path.stat().st_size < 60_000
        assert len(Image.open(path).convert("RGB").getcolors()) > 2


def test_the_gallery_has_a_page_for_each_example(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pages = module(TOP / "docs" / "gallery_pages.py")
    pages.write_gallery(tmp_path)
    index = (tmp_path / "index.md").read_text()
    for example in draw.examples():
        page = (tmp_path / f"{example.stem}.md").read_text()
        title, rest = pages.parts(example)
        assert f". {title}\n" in page and rest in page
        assert 5 < len(title) < 110 and len(rest) > 80
        assert f"({example.stem}.md)" in index


def test_a_failing_example_is_reported(tmp_path: Path) -> None:
    wrong = tmp_path / "99_wrong.py"
    wrong.write_text("raise SystemExit('no light')\n")
    with pytest.raises(RuntimeError, match="no light"):
        draw.run(wrong, tmp_path)
