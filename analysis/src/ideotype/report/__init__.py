# SPDX-License-Identifier: Apache-2.0
"""Reports: one HTML page about histories, with figures as files."""

from .report import Written, write_report

__all__ = ["Written", "write_report"]
