# SPDX-License-Identifier: Apache-2.0
"""The program's optimizers find the optima of Python functions."""

import numpy as np
import pytest

import ideotype

OPTIMIZERS = ["auto", "ga", "cma_es", "random", "sobol"]


def searched(generations: int, **options):
    search = ideotype.Search(
        [-5] * 6, [5] * 6, start=[3] * 6, maximise=[False], **options
    )
    for _ in range(generations):
        search.tell([np.sum(x**2) for x in search.ask()])
    return search


@pytest.mark.parametrize("optimizer", OPTIMIZERS)
def test_points_are_within_bounds_and_reproducible(optimizer: str) -> None:
    one, other = (
        searched(5, optimizer=optimizer, population=12) for _ in range(2)
    )
    assert np.abs(one.ask()).max() <= 5
    np.testing.assert_array_equal(one.ask(), other.ask())
    np.testing.assert_array_equal(one.best(2), other.best(2))


def test_auto_finds_a_minimum() -> None:
    assert np.abs(searched(200).best()).max() < 1e-6


def test_several_objectives_give_a_front() -> None:
    search = ideotype.Search(
        [0] * 3, [1] * 3, maximise=[False, False], optimizer="nsga2"
    )
    for _ in range(30):
        x = search.ask()
        rest = 1 + x[:, 1:].sum(axis=1)
        search.tell(np.column_stack([x[:, 0], rest * (1 - x[:, 0] / rest)]))
    assert np.ptp(search.best(20)[:, 0]) > 0.5


def test_failing_points_are_avoided() -> None:
    search = ideotype.Search([-5] * 3, [5] * 3, start=[1] * 3)
    for _ in range(100):
        x = search.ask()
        search.tell(np.where(x[:, 0] > 2, np.nan, x[:, 0]))
    assert 1.9 < search.best()[0, 0] <= 2.1


@pytest.mark.parametrize(
    "options, message",
    [
        ({"upper": [1, -6]}, "each lower bound"),
        ({"upper": [1]}, "lists of the same length"),
        ({"maximise": []}, "one truth value is needed"),
        ({"maximise": True}, "one truth value is needed"),
        (
            {"population": 0},
            "population is 0; use a whole number from 2 to 100000",
        ),
        ({"seed": 1.5}, "seed is 1.5; use a whole number"),
        ({"start": [0]}, "2 numbers are needed"),
        ({"traits": ["a"]}, "2 names are needed"),
        ({"optimizer": "best"}, 'no optimizer "best"; use one of auto'),
    ],
)
def test_the_error_names_an_invalid_argument(options, message: str) -> None:
    with pytest.raises(ideotype.Error, match=message):
        ideotype.Search(**{"lower": [-5, -5], "upper": [5, 5], **options})


def test_the_number_of_values_must_be_that_of_points() -> None:
    search = searched(1)
    with pytest.raises(ideotype.Error, match="asked for, but 1 are given"):
        search.tell([1])


def test_the_repr_of_a_search_shows_its_settings() -> None:
    search = ideotype.Search(
        [0, 0], [1, 2], maximise=[False, False], optimizer="nsga2", seed=5
    )
    assert repr(search) == (
        "<Search: nsga2, 2 genes, minimises 2 objectives, seed 5>"
    )
