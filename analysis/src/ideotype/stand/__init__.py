# SPDX-License-Identifier: Apache-2.0
"""Stands: the plants of a campaign, evaluated in this process."""

from .comparison import Comparison, Quantity
from .crop import Crop
from .energy import leaf_energy_balance
from .evaluated import Evaluated
from .soil import soil_water_balance
from .stand import Stand

__all__ = [
    "Comparison",
    "Crop",
    "Evaluated",
    "Quantity",
    "Stand",
    "leaf_energy_balance",
    "soil_water_balance",
]
