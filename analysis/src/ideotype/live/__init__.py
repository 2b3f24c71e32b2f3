# SPDX-License-Identifier: Apache-2.0
"""Live pages: `ideotype play` and `ideotype watch`."""
