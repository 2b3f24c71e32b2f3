# SPDX-License-Identifier: Apache-2.0
"""Converts settings of a campaign from Python to words of a command line, and
words of a command line to numbers."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np
import tomli_w

from .arrays import unmasked

Settings = Mapping[str, Any] | Iterable[str]
"""Keys of a campaign with values that replace those of its file:
{"light.paths": 1024} or ["light.paths=1024"]. Tables are dictionaries."""


def format_settings(settings: Settings) -> list[str]:
    """Returns settings as words for the option `--set`."""
    if isinstance(settings, str):
        return [settings]
    if isinstance(settings, Mapping):
        return [f"{key}={_toml(value)}" for key, value in settings.items()]
    return list(settings)


def _toml(value: Any) -> str:
    """Returns a value as TOML on one line."""
    if isinstance(value, Mapping):
        pairs = (f"{key} = {_toml(item)}" for key, item in value.items())
        return f"{{{', '.join(pairs)}}}"
    if isinstance(value, (list, tuple, np.ndarray)):
        return f"[{', '.join(map(_toml, unmasked(value, 'a setting')))}]"
    plain = value.item() if isinstance(value, np.generic) else value
    return tomli_w.dumps({"x": plain}).partition("=")[2].strip()


def number_within(
    kind: type[int] | type[float], lower: float, upper: float
) -> Callable[[str], Any]:
    """Returns a parser for option values from `lower` to `upper`. It raises
    ArgumentTypeError for other values."""

    def read(word: str) -> Any:
        try:
            value = kind(word)
        except ValueError:
            value = math.nan
        if not lower <= value <= upper:
            raise argparse.ArgumentTypeError(
                f"{word} (expected: {lower:g} .. {upper:g})"
            )
        return value

    return read
