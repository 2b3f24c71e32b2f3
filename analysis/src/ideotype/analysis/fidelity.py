# SPDX-License-Identifier: Apache-2.0
"""Speed for accuracy: what `ideotype fidelity --json` has measured."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path

from matplotlib.figure import Figure

from . import style
from .file import HistoryError

_TITLES = {
    "value": "light in one canopy",
    "difference": "difference of two canopies",
}
_FIELDS = {"one": "one field", "each": "a field each"}


@dataclass(frozen=True)
class Front:
    """The settings that nothing beats: milliseconds of one evaluation and
    its relative error, cheapest first."""

    goal: str
    fields: str
    milliseconds: tuple[float, ...]
    error: tuple[float, ...]


@dataclass(frozen=True)
class Check:
    """A setting evaluated again, with the error found."""

    goal: str
    fields: str
    milliseconds: float
    error: float
    standard_error: float


@dataclass(frozen=True)
class Fidelity:
    """The trade of one case."""

    case: str
    fronts: tuple[Front, ...]
    checks: tuple[Check, ...]


def read_fidelity(path: str | Path) -> Fidelity:
    """Raises FileNotFoundError, or HistoryError if it is something else."""
    path = Path(path)
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        return Fidelity(
            str(data["case"]),
            tuple(_front(front) for front in data["fronts"]),
            tuple(
                _check(choice)
                for choice in data["choices"]
                if "check" in choice
            ),
        )
    except (
        AttributeError,
        KeyError,
        TypeError,
        ValueError,
    ) as error:
        raise HistoryError(
            f"{path}: not written by ideotype fidelity --json ({error!r})"
        ) from error


def _front(data: dict[str, object]) -> Front:
    found = data.get("combinations") or []
    if not isinstance(found, list):
        raise TypeError("combinations are no list")
    return Front(
        str(data["goal"]),
        str(data["fields"]),
        tuple(float(each["milliseconds"]) for each in found),
        tuple(float(each["error"]) for each in found),
    )


def _check(choice: dict[str, object]) -> Check:
    found = choice["check"]
    if not isinstance(found, dict):
        raise TypeError("a check is no table")
    bias, scatter = found["bias"], found["standard_error"]
    error = math.hypot(bias["mean"], scatter["mean"])
    uncertain = math.hypot(
        bias["mean"] * bias["standard_error"],
        scatter["mean"] * scatter["standard_error"],
    )
    return Check(
        str(choice["goal"]),
        str(choice["fields"]),
        float(found["milliseconds"]),
        error,
        uncertain / error if error > 0 else 0.0,
    )


def draw_fidelity(fidelity: Fidelity) -> Figure:
    """Error against cost: the fronts as lines, what was evaluated again as
    points with standard errors."""
    figure = style.new_figure(style.WIDTH, 3.4)
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    for axes, (goal, title) in zip(panels, _TITLES.items(), strict=True):
        for index, (fields, label) in enumerate(_FIELDS.items()):
            color, marker = style.series(index)
            for front in fidelity.fronts:
                if (front.goal, front.fields) == (goal, fields):
                    axes.plot(
                        front.milliseconds,
                        [100 * error for error in front.error],
                        color=color,
                        linestyle="-" if index == 0 else "--",
                        label=label,
                    )
            for check in fidelity.checks:
                if (check.goal, check.fields) == (goal, fields):
                    axes.errorbar(
                        check.milliseconds,
                        100 * check.error,
                        100 * check.standard_error,
                        color=color,
                        marker=marker,
                    )
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(title)
        axes.set_xlabel("cost of one evaluation [ms]")
    panels[0].set_ylabel("error [% of the light in leaves]")
    panels[0].legend()
    return figure
