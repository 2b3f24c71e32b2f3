# SPDX-License-Identifier: Apache-2.0
"""Draws facts: measured and computed values over the conditions of points."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ..figures import style
from .comparison import Point, Result, effective_error


def draw_fact(result: Result) -> Figure:
    """Draws the measured values, with 95 % confidence intervals or ranges, and
    the computed values over the axis of the fact."""
    fact = result.fact
    figure = style.new_figure(style.WIDTH, 3.4)
    axes = figure.subplots()
    positions = [_position(point, fact.axis) for point in result.points]
    points = result.points
    if all(isinstance(x, int | float) for x in positions):
        order = sorted(range(len(points)), key=lambda i: positions[i])
        points = [points[i] for i in order]
        positions = [positions[i] for i in order]
    # Measurements of the same hours make a curve.
    for hours in dict.fromkeys(_hours(point, fact.axis) for point in points):
        curve = [
            (position, point)
            for position, point in zip(positions, points, strict=True)
            if _hours(point, fact.axis) == hours
        ]
        axes.errorbar(
            [position for position, _ in curve],
            [point.computed for _, point in curve],
            style.half_width([point.standard_error for _, point in curve]),
            color=style.BEST,
            marker="o",
            linestyle="--" if hours else "-",
            label=f"computed, {hours}" if hours else "computed",
        )
    known = [
        (position, point.measurement)
        for position, point in zip(positions, points, strict=True)
        if point.measurement.is_measured
    ]
    if known:
        bars = []
        for _, row in known:
            half = float(style.half_width(effective_error(row)))
            low, high = (
                abs(row.value - x) if math.isfinite(x) else 0.0
                for x in (row.low, row.high)
            )
            bars.append((low or half, high or half))
        axes.errorbar(
            [position for position, _ in known],
            [row.value for _, row in known],
            np.transpose(bars),
            color=style.BASELINE,
            marker="s",
            linestyle="",
            label="measured",
        )
    row = points[0].measurement
    unit = "" if row.unit == "1" else f" [{row.unit}]"
    change = "change of " if fact.than is not None else ""
    axes.set_ylabel(f"{change}{row.quantity}{unit}")
    axes.set_xlabel("" if fact.axis == "quantity" else fact.axis)
    if fact.axis == "date":
        figure.autofmt_xdate()
    axes.set_title(f"{fact.question}: {result.verdict}", wrap=True)
    axes.legend()
    return figure


def _hours(point: Point, axis: str) -> str:
    """Returns the hours of a measurement of a part of the day, unless they are
    the axis."""
    return "" if axis == "hour" else point.measurement.hours_text


def _position(point: Point, axis: str) -> Any:
    row = point.measurement
    if axis in row.keys:
        return row.keys[axis]
    if axis == "hour":
        ends = [60 * x.hour + x.minute for x in row.hours or ()]
        return sum(ends) / 120 if ends else "day"
    return getattr(row, axis)
