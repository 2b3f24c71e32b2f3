# SPDX-License-Identifier: Apache-2.0
"""Representative years of a long record of weather."""

from .features import Features, read_features
from .medoids import Representatives, choose_representatives

__all__ = [
    "Features",
    "Representatives",
    "choose_representatives",
    "read_features",
]
