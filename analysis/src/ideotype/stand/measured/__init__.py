# SPDX-License-Identifier: Apache-2.0
"""Plants that were measured as points, lines or surfaces."""
