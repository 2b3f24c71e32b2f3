# SPDX-License-Identifier: Apache-2.0
"""Genes are called by their names."""

from __future__ import annotations

import numpy as np
import pytest

from ideotype.history.genes import Genes

TRAITS = ["fold", "droop", "fold", "droop", "height", *["size_profile"] * 3]


@pytest.fixture
def genes() -> Genes:
    """Returns two leaves with two traits each, a plant's trait, and a
    profile."""
    count = len(TRAITS)
    return Genes(
        tuple(f"gene{i}" for i in range(count)),
        tuple(TRAITS),
        np.array([1, 1, 2, 2, 0, 0, 0, 0]),
        ("deg", "deg", "deg", "deg", "1", "1", "1", "1"),
        np.zeros(count),
        np.ones(count),
        np.zeros(count, bool),
        np.array([False, True, False, True, True, True, True, True]),
    )


def test_traits_are_of_leaves_of_plants_or_profiles(genes: Genes) -> None:
    assert [genes.kind(t) for t in ("fold", "height", "size_profile")] == [
        *("leaf", "plant", "profile"),
    ]
    # A gene that is not free is not bred.
    assert genes.bred("leaf") == ["droop"]
    assert genes.bred("plant") == ["height"]
    assert genes.bred("profile") == ["size_profile"]


def test_genes_are_called_by_leaf_or_point(genes: Genes) -> None:
    assert [genes.number(i) for i in range(8)] == [1, 1, 2, 2, 0, 1, 2, 3]


def test_axes_have_the_unit_of_a_trait(genes: Genes) -> None:
    assert genes.label("droop") == "droop [°]"
    assert genes.label("size_profile") == "size profile [1]"
