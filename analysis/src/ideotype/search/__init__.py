# SPDX-License-Identifier: Apache-2.0
"""Optimizers for any function, and stands for optimizers of others."""

from .search import Search

__all__ = ["Search"]
