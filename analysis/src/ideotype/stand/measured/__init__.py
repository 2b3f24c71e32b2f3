# SPDX-License-Identifier: Apache-2.0
"""Plants measured as points, lines or surfaces."""
