# SPDX-License-Identifier: Apache-2.0
"""Draws of parameters as tables of a campaign."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..validation.comparison import CROP, LEAF
from .parameters import Parameter

Numbers = NDArray[np.float64]


def format_draws(
    parameters: Sequence[Parameter], values: Numbers
) -> tuple[str, list[str]]:
    """Returns the tables [[draw]] of a campaign, and the keys of the parameters
    that they leave out: changes of leaves, factors and keys of [[TABLE]], which
    are no numeric keys of a campaign.

    values: draws of the parameters [draws, parameters]."""
    kept = [i for i, p in enumerate(parameters) if campaign_key(p)]
    names = ", ".join(f'"{campaign_key(parameters[i])}"' for i in kept)
    text = "".join(
        f'[[draw]]\nname = "{number}"\nkeys = [{names}]\nvalues = '
        f"[{', '.join(repr(float(x)) for x in row[kept])}]\n\n"
        for number, row in enumerate(values, 1)
    )
    left_out = [p.key for p in parameters if not campaign_key(p)]
    return text if kept else "", left_out


def campaign_key(parameter: Parameter) -> str:
    """Returns the numeric key of a campaign that a parameter sets, or ""."""
    key = parameter.key
    if key.startswith(CROP):
        key = f"plant.baseline.{key.removeprefix(CROP)}"
        is_plain = key.count(".") == 3
    else:
        is_plain = not key.startswith(LEAF)
    return key if is_plain and not parameter.is_factor else ""
