# SPDX-License-Identifier: Apache-2.0
"""Live pages: `ideotype play` and `ideotype watch`. The commands import their
modules; the package has no public names."""

__all__: list[str] = []
