# SPDX-License-Identifier: Apache-2.0
"""CMA-ES with integers and choices takes about as many evaluations as CatCMA
with margin of the package cmaes."""

from __future__ import annotations

import numpy as np
import pytest
from discrete_functions import (
    FUNCTIONS,
    Function,
    evaluations,
    published_evaluations,
)

import ideotype

SEEDS = range(1, 8)


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda f: f.name)
def test_evaluations_are_about_those_of_the_package(
    function: Function,
) -> None:
    ours, theirs = (
        np.median([count(seed) for seed in SEEDS])
        for count in (
            lambda seed: evaluations(function, "cma_es", seed),
            lambda seed: published_evaluations(function, seed),
        )
    )
    assert ours < 1.5 * theirs


@pytest.mark.parametrize("optimizer", ["auto", "ga", "random", "sobol"])
def test_every_value_is_proposed_and_none_in_between(optimizer: str) -> None:
    search = ideotype.Search(
        [0, -1, 0],
        [1, 2, 3],
        optimizer=optimizer,
        population=16,
        kinds=["real", "integer", "choice"],
    )
    seen = []
    for _ in range(20):
        points = search.ask()
        seen.append(points)
        search.tell(points[:, 0])
    _, integers, choices = np.concatenate(seen).T
    assert set(integers) == {-1, 0, 1, 2}
    assert set(choices) == {0, 1, 2, 3}


@pytest.mark.parametrize(
    "options, message",
    [
        ({"kinds": ["integer"]}, "kinds: 2 names are needed"),
        ({"kinds": ["real", "text"]}, 'no kind of genes "text"; use one of'),
        ({"kinds": ["real", "integer"], "upper": [1, 1.5]}, "whole numbers"),
        (
            {"kinds": ["real", "choice"], "circular": [False, True]},
            "not circular",
        ),
        (
            {"kinds": ["real", "choice"], "start": [0, 0.5]},
            "start: integers and choices are whole numbers",
        ),
    ],
)
def test_the_error_names_an_invalid_kind(options, message: str) -> None:
    with pytest.raises(ideotype.Error, match=message):
        ideotype.Search(**{"lower": [0, 0], "upper": [1, 2], **options})
