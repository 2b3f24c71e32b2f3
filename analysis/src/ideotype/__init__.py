# SPDX-License-Identifier: Apache-2.0
"""Exact light in crop canopies, and plants bred for it.

`open`, `open_history` and `open_study` read what the program has written."""

from .analysis import open_history, open_study
from .analysis import open_arrays as open

__all__ = ["open", "open_history", "open_study"]
