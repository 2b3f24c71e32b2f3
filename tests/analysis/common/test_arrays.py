# SPDX-License-Identifier: Apache-2.0
"""Arrays with hidden values, or values that would be lost, are refused by all
functions."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from real_program import CAMPAIGNS

import ideotype
from ideotype.history.front import non_dominated

SPOILED: dict[str, tuple[Callable[[np.ndarray], Any], str]] = {
    "masked": (
        lambda x: np.ma.masked_array(x, np.arange(x.size) == 1),
        "masked array, and masked values would count; give",
    ),
    "mask without effect": (np.ma.masked_array, "masked array"),
    "list of masked": (
        lambda x: [np.ma.masked_array(x, x > x.min())],
        "masked array",
    ),
    "complex": (lambda x: x + 1j, "has complex numbers; give real ones"),
    "one complex": (lambda x: [*x.tolist()[:-1], 2j], "complex numbers"),
    "dates": (
        lambda x: np.datetime64("2025-08-07") + np.arange(x.size),
        "is no array of numbers: it has dates or times",
    ),
    "times": (
        lambda x: np.arange(x.size).astype("timedelta64[h]"),
        "is no array of numbers: it has dates or times",
    ),
    "words": (lambda x: ["wide"] * x.size, "is no array of numbers"),
    "ragged": (lambda x: [x.tolist(), [1.0]], "is no array of numbers"),
}


@pytest.fixture(scope="module")
def stand() -> ideotype.Stand:
    return ideotype.Stand.from_campaign(CAMPAIGNS / "ames_quick.toml")


@pytest.fixture(params=SPOILED)
def spoiled(request: pytest.FixtureRequest) -> tuple[Any, str]:
    return SPOILED[request.param]


def test_invalid_genomes_are_errors(
    stand: ideotype.Stand, spoiled: tuple[Any, str]
) -> None:
    spoil, words = spoiled
    for take in (stand.evaluate, stand.mesh, stand.crop_file):
        with pytest.raises(ideotype.Error, match=f"^genomes .*{words}"):
            take(spoil(stand.baseline))


def test_an_invalid_genome_of_a_history_is_an_error(
    finished: Path, spoiled: tuple[Any, str]
) -> None:
    spoil, words = spoiled
    with pytest.raises(ideotype.Error, match=f"^genome .*{words}"):
        ideotype.Stand.from_history(finished, spoil(np.ones(4)))


def test_invalid_vertices_are_errors(spoiled: tuple[Any, str]) -> None:
    spoil, words = spoiled
    with pytest.raises(ideotype.Error, match=words):
        ideotype.mesh(spoil(np.eye(3).ravel()), [[0, 1, 2]])


@pytest.mark.parametrize(
    ("faces", "words"),
    [
        (np.ma.masked_array([[0, 1, 2, 3]], [[0, 0, 0, 1]]), "masked array"),
        ([np.ma.masked_array([0, 1, 2], [0, 0, 1])], "masked array"),
        (np.array([[0, 1, 2]]) + 0j, "complex numbers"),
        ([["a", "b", "c"]], "is no array of numbers"),
    ],
)
def test_invalid_faces_are_errors(faces: Any, words: str) -> None:
    with pytest.raises(ideotype.Error, match=f"^faces .*{words}"):
        ideotype.mesh(np.eye(4)[:, :3], faces)


def test_invalid_objectives_of_a_front_are_errors(
    spoiled: tuple[Any, str],
) -> None:
    spoil, words = spoiled
    values = spoil(np.array([1.0, 2.0, 3.0]))
    for take in (
        lambda: non_dominated(values, [1]),
        lambda: non_dominated(np.eye(3), values),
        lambda: non_dominated(np.eye(3), [1, 1, 1], values),
    ):
        with pytest.raises(ideotype.Error, match=words):
            take()


def test_a_masked_setting_is_an_error(stand: ideotype.Stand) -> None:
    hidden = np.ma.masked_array([0.01, 0.02], [False, True])
    with pytest.raises(
        ideotype.Error, match="a setting is or contains a masked"
    ):
        ideotype.Stand.from_campaign(
            CAMPAIGNS / "ames_quick.toml", settings={"light.bands": hidden}
        )


def test_numbers_of_other_types_are_accepted(stand: ideotype.Stand) -> None:
    plant = stand.baseline
    for same in (
        plant.tolist(),
        tuple(plant),
        plant[None],
        plant.astype(object),
    ):
        assert stand.crop_file(same) == stand.crop_file(plant)
