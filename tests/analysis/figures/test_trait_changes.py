# SPDX-License-Identifier: Apache-2.0
"""Changes of traits from the baseline are stated with their direction."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from made_layout import seal
from real_program import run_crop

from ideotype.figures.shape import draw_plant_traits
from ideotype.figures.style import get_answer
from ideotype.figures.trait_changes import measure_change
from ideotype.history import open_study
from ideotype.history.case import Case

FREE = ["height", "width_profile", "insertion_angle_profile", "leaf_plane"]


@pytest.fixture(scope="module")
def history(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return run_crop(tmp_path_factory.mktemp("changes"), "maize", FREE)


def with_best(history: Path, folder: Path, trait: str, change: object) -> Path:
    """Copies a history and makes its finalists differ from the baseline in
    only one trait."""
    copy = folder / history.name
    copy.write_bytes(history.read_bytes())
    with h5py.File(copy, "r+") as file:
        genome = file["final/genome"][:]
        traits = [name.decode() for name in file["genes/trait"][:]]
        columns = [i for i, name in enumerate(traits) if name == trait]
        genome[1:] = genome[0]
        genome[1:, columns] += np.asarray(change, dtype=float)
        file["final/genome"][...] = genome
        seal(file)
    return copy


def format_change(case: Case, trait: str) -> str:
    return str(measure_change(case, trait))


@pytest.mark.parametrize(
    ("trait", "change", "text"),
    [
        ("height", -0.29, "height (29 % shorter)"),
        ("height", 0.085, "height (8 % taller)"),
        ("height", 0.0, "height (unchanged)"),
        ("width_profile", 0.1, "width (10 % wider on average)"),
        ("width_profile", -0.004, "width (0.4 % narrower on average)"),
        (
            "width_profile", [0.1, -0.1, 0.1, -0.1],
            "width (10 % on average, narrower or wider depending on the leaf)",
        ),
        (
            "insertion_angle_profile", -12.0,
            "insertion angle (12° more erect on average)",
        ),
        (
            "insertion_angle_profile", 12.0,
            "insertion angle (12° more horizontal on average)",
        ),
        ("leaf_plane", 30.0, "leaf plane (30° clockwise)"),
    ],
)  # fmt: skip
def test_a_change_has_a_direction(
    history: Path, tmp_path: Path, trait: str, change: object, text: str
) -> None:
    path = with_best(history, tmp_path, trait, change)
    with open_study(path) as study:
        (case,) = study.cases()
        assert format_change(case, trait) == text
        if trait == "height" and change:
            answer = get_answer(draw_plant_traits(case))
            assert answer.startswith(
                f"The best plant differs most from the baseline in {text}"
            )


def test_azimuths_turn_along_the_shorter_arc(finished: Path) -> None:
    with open_study(finished) as study:
        (case,) = study.cases()
        text = format_change(case, "azimuth")
    assert text.startswith("azimuth (turned by ")
    assert text.endswith("° on average)")
