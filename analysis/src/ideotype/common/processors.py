# SPDX-License-Identifier: Apache-2.0
"""The processors available to this process."""

from __future__ import annotations

import os


def processors() -> int:
    """Returns the number of processors that this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # Some systems lack this call.
        return os.cpu_count() or 1
