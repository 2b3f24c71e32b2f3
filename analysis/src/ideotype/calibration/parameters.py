# SPDX-License-Identifier: Apache-2.0
"""Parameters of a calibration and their prior distributions."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

from ..common.arrays import require_file
from ..errors import Error, did_you_mean

Numbers = NDArray[np.float64]

KEYS = {"key", "range", "mean", "deviation", "factor", "source"}
"""The keys of a table [[parameter]]."""

_ESTIMATE = re.compile(
    r"\s*(?P<key>\w+)\s*=\s*(?P<value>-?[\d.]+)\s*#.*\bE:\s*"
    r"(?P<low>-?[\d.]+) to (?P<high>-?[\d.]+)\s*$"
)
_TABLE = re.compile(r"\s*(?P<brackets>\[{1,2})(?P<name>[\w.]+)\]{1,2}")


@dataclass(frozen=True)
class Parameter:
    """A numeric key with a prior distribution.

    The prior is uniform between `low` and `high` if `deviation` is NaN, else
    normal, cut off at `low` and `high`. Samplers work with z, which is standard
    normal under every prior: the value is the quantile of the prior at the
    normal probability of z."""

    key: str
    """A key of the campaign, crop.TABLE.KEY or leaf.PART.MEASURE."""
    low: float
    high: float
    mean: float = math.nan
    deviation: float = math.nan
    is_factor: bool = False
    """Whether values multiply the value of the baseline."""
    source: str = ""

    @property
    def is_uniform(self) -> bool:
        """Whether the prior is uniform."""
        return math.isnan(self.deviation)

    @property
    def _ends(self) -> tuple[float, float]:
        """The normal probabilities of `low` and `high`."""
        ends = (np.array([self.low, self.high]) - self.mean) / self.deviation
        low, high = ndtr(ends)
        return float(low), float(high)

    def value(self, z: Any) -> Any:
        """Returns values of the parameter at standard normal numbers z."""
        p = ndtr(z)
        if self.is_uniform:
            return self.low + (self.high - self.low) * p
        low, high = self._ends
        return np.clip(
            self.mean + self.deviation * ndtri(low + (high - low) * p),
            self.low,
            self.high,
        )

    def z(self, value: Any) -> Any:
        """Returns the standard normal numbers of values; the inverse of
        `value`."""
        if self.is_uniform:
            return ndtri(
                (np.asarray(value) - self.low) / (self.high - self.low)
            )
        low, high = self._ends
        p = ndtr((np.asarray(value) - self.mean) / self.deviation)
        return ndtri((p - low) / (high - low))

    def scaled(self, value: Any) -> Any:
        """Returns values on a scale on which the prior is from about -1 to
        1."""
        if self.is_uniform:
            half = (self.high - self.low) / 2
            return (np.asarray(value) - (self.low + self.high) / 2) / half
        return (np.asarray(value) - self.mean) / (2 * self.deviation)

    def setting(self, value: float) -> Any:
        """Returns a value as that of the key, as facts have it."""
        return {"times": float(value)} if self.is_factor else float(value)

    def describe(self) -> str:
        """Returns the prior in words."""
        if self.is_uniform:
            return f"{self.low:g} to {self.high:g}"
        return f"{self.mean:g} ± {1.96 * self.deviation:.3g}"


def values_at(parameters: Sequence[Parameter], z: Any) -> Numbers:
    """Returns the values of parameters at standard normal numbers
    [..., parameters]."""
    columns = [
        p.value(np.asarray(z)[..., i]) for i, p in enumerate(parameters)
    ]
    return np.stack(columns, axis=-1)


def settings_at(
    parameters: Sequence[Parameter], values: Sequence[float] | Numbers
) -> dict[str, Any]:
    """Returns the keys that parameters set at the given values."""
    return {p.key: p.setting(x) for p, x in zip(parameters, values)}


def read_parameters(path: Path) -> list[Parameter]:
    """Reads a TOML file with one table [[parameter]] for each parameter, with
    `key`, `range = [low, high]` or `mean` and `deviation` (and `range`, at which
    the normal prior is then cut off), `factor = true` for factors of the
    baseline's value, and `source`.

    Raises Error with all problems of the file."""
    require_file(path)
    try:
        text = path.read_text(encoding="utf-8")
        tables = tomllib.loads(text)
    except (OSError, ValueError) as error:
        raise Error(f"{path}: {error}") from None
    lines = [
        number
        for number, line in enumerate(text.splitlines(), 1)
        if line.split("#")[0].strip() == "[[parameter]]"
    ]
    problems = [
        f"{path}: there is no table '{name}'; use [[parameter]]"
        for name in tables
        if name != "parameter"
    ]
    parameters: list[Parameter] = []
    for number, table in enumerate(tables.get("parameter", [])):
        line = lines[number] if number < len(lines) else 1
        where = f"{path}:{line}"
        faults, parameter = _parameter(table, where)
        problems += faults
        if parameter and any(p.key == parameter.key for p in parameters):
            problems.append(
                f"{where}: '{parameter.key}' has two priors; remove one"
            )
        if parameter:
            parameters.append(parameter)
    if not problems and not parameters:
        problems.append(f"{path}: there is no [[parameter]]; add one")
    if problems:
        raise Error("\n".join(problems))
    return parameters


def read_priors(path: Path) -> list[Parameter]:
    """Returns the priors of a file: those of its tables [[parameter]], or of
    the estimates of a crop file. Raises Error as read_parameters() and
    estimates()."""
    require_file(path)
    has_tables = "[[parameter]]" in path.read_text(encoding="utf-8")
    return read_parameters(path) if has_tables else estimates(path)


def _parameter(
    table: Mapping[str, Any], where: str
) -> tuple[list[str], Parameter | None]:
    """Returns the problems of a table and, if there are none, its
    parameter."""
    problems = [
        f"{where}: there is no key '{name}'"
        + (
            did_you_mean(name, sorted(KEYS))
            or f"; use {', '.join(sorted(KEYS))}"
        )
        for name in table
        if name not in KEYS
    ]
    key = table.get("key")
    if not isinstance(key, str) or "." not in key:
        problems.append(
            f'{where}: key is {key!r}; give a key such as "photosynthesis.theta"'
        )
    ends = table.get("range", [-math.inf, math.inf])
    if not (
        isinstance(ends, list)
        and len(ends) == 2
        and all(isinstance(x, int | float) for x in ends)
        and ends[0] < ends[1]
    ):
        problems.append(
            f"{where}: range is {ends!r}; give [low, high] with low < high"
        )
        ends = [0.0, 1.0]
    moments: list[Any] = [table.get(name) for name in ("mean", "deviation")]
    is_normal = any(x is not None for x in moments)
    if is_normal and not (
        all(isinstance(x, int | float) and math.isfinite(x) for x in moments)
        and moments[1] > 0
    ):
        problems.append(
            f"{where}: mean is {moments[0]!r} and deviation {moments[1]!r}; give "
            "two numbers, and a deviation above 0"
        )
    elif is_normal and not ends[0] < moments[0] < ends[1]:
        problems.append(
            f"{where}: mean {moments[0]!r} is outside of the range; correct one"
        )
    if not is_normal and not all(map(math.isfinite, ends)):
        problems.append(
            f"{where}: there is no prior; give range = [low, high], or mean and "
            "deviation"
        )
    if problems:
        return problems, None
    mean, deviation = (
        (float(moments[0]), float(moments[1]))
        if is_normal
        else (math.nan, math.nan)
    )
    return [], Parameter(
        str(key), float(ends[0]), float(ends[1]), mean, deviation,
        bool(table.get("factor", False)), str(table.get("source", "")),
    )  # fmt: skip


def estimates(crop: Path) -> list[Parameter]:
    """Returns the estimates of a crop file that state a range, as parameters
    with a uniform prior.

    An estimate is a line KEY = NUMBER # E: LOW to HIGH in a table. Values in
    [photosynthesis] are keys of the campaign, and others crop.TABLE.KEY."""
    require_file(crop)
    return list(_estimates(crop))


def _estimates(crop: Path) -> Iterator[Parameter]:
    table, counts = "", dict[str, int]()
    lines = crop.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        if header := _TABLE.match(line):
            table = header["name"]
            if header["brackets"] == "[[":
                counts[table] = counts.get(table, 0) + 1
                table += f".{counts[table]}"
        elif (found := _ESTIMATE.match(line)) and table:
            in_campaign = table == "photosynthesis"
            prefix = "" if in_campaign else "crop."
            yield Parameter(
                f"{prefix}{table}.{found['key']}",
                float(found["low"]),
                float(found["high"]),
                source=f"{crop.name}:{number}",
            )
