# SPDX-License-Identifier: Apache-2.0
"""Makes histories of several objectives."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from made_campaign import resolved
from made_history import MadeHistory
from made_layout import seal
from made_numbers import LAI

LIGHT, AREA = ("absorbed_par", "maximise"), ("lai", "minimise")
LEAVES = ("absorbed_par_per_leaf_area", "maximise")
LAIS = [LAI, 3.0, 3.5, 3.2]
"""Leaf area indices of the finalists: the last finalist is dominated by a
finalist with more light on less leaf area."""
KEPT = [True, True, False]
SCENARIOS = ["dense stand", "wide rows"]


def make(
    path: Path,
    objectives: Sequence[tuple[str, str]] = (LIGHT, AREA),
    **options: Any,
) -> Path:
    """Makes a finished history; the leaf area indices of its finalists are
    LAIS."""
    made = MadeHistory(
        path, objectives=objectives, resolved=resolved(), **options
    )
    made.evolve(5)
    made.finish()
    made.close()
    with h5py.File(path, "r+") as file:
        file["final/lai"][:] = LAIS
        if AREA in objectives:
            k = objectives.index(AREA)
            file["final/objectives"][:, k] = LAIS
            draws = file["final/objectives_by_randomisation"]
            draws[:, k] = np.repeat(LAIS, draws.shape[2]).reshape(4, -1)
        seal(file)
    return path
