# SPDX-License-Identifier: Apache-2.0
"""Reads the numbers and words of drawn figures."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.container import ErrorbarContainer
from matplotlib.figure import Figure


def bars(axes: Axes, label: str) -> tuple[np.ndarray, np.ndarray]:
    """Returns values and half-lengths of the vertical bars with a label."""
    (container,) = [
        c for c in axes.containers if (c.get_label() or "_").startswith(label)
    ]
    line, _, (segments,) = container.lines
    ends = np.array(segments.get_segments())
    return line.get_ydata(), (ends[:, 1, 1] - ends[:, 0, 1]) / 2


def labels(figure: Figure) -> set[str]:
    """Returns all labels of all legends and axes."""
    texts = {t for a in figure.axes for t in (a.get_xlabel(), a.get_ylabel())}
    legends = [*figure.legends, *(a.get_legend() for a in figure.axes)]
    for legend in filter(None, legends):
        texts |= {text.get_text() for text in legend.get_texts()}
    return texts


def horizontal_bars(axes: Axes, index: int = 0) -> tuple[np.ndarray, ...]:
    """Returns the means by leaf and the half-lengths of a set of error
    bars."""
    found = [c for c in axes.containers if isinstance(c, ErrorbarContainer)]
    line, _, (segments,) = found[index].lines
    ends = np.array(segments.get_segments())
    return line.get_xdata(), (ends[:, 1, 0] - ends[:, 0, 0]) / 2
