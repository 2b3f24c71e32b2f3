# SPDX-License-Identifier: Apache-2.0
"""The optimizers of the program for any function, and stands as problems for
other optimizers."""

from .search import Search

__all__ = ["Search"]
