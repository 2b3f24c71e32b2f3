# SPDX-License-Identifier: Apache-2.0
"""Genes are identified by their names."""

from __future__ import annotations

import numpy as np
import pytest

from ideotype.history.genes import Genes

TRAITS = ["fold", "droop", "fold", "droop", "height", *["size_profile"] * 3]


@pytest.fixture
def genes() -> Genes:
    """Returns the genes of two leaves with two traits each, of a trait of the
    whole plant, and of a profile."""
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


def test_traits_have_a_gene_per_leaf_plant_or_profile_point(
    genes: Genes,
) -> None:
    assert [genes.kind(t) for t in ("fold", "height", "size_profile")] == [
        *("leaf", "plant", "profile"),
    ]
    # Genes that are not free are excluded.
    assert genes.bred("leaf") == ["droop"]
    assert genes.bred("plant") == ["height"]
    assert genes.bred("profile") == ["size_profile"]


def test_gene_numbers_are_leaf_ranks_or_profile_points(genes: Genes) -> None:
    assert [genes.number(i) for i in range(8)] == [1, 1, 2, 2, 0, 1, 2, 3]


def test_axis_labels_have_the_unit_of_the_trait(genes: Genes) -> None:
    assert genes.label("droop") == "droop [°]"
    assert genes.label("size_profile") == "size profile [1]"
