# SPDX-License-Identifier: Apache-2.0
"""Views of stands and comparisons for people."""
