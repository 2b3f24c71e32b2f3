# SPDX-License-Identifier: Apache-2.0
"""The figures of reports and of stands."""

from .cross import Cross, read_cross

__all__ = ["Cross", "read_cross"]
