# SPDX-License-Identifier: Apache-2.0
"""Turns settings of a campaign from Python into words of a command line, and
words of a command line into numbers."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np
import tomli_w

from .arrays import unmasked

Settings = Mapping[str, Any] | Iterable[str]
"""Keys of a campaign with values that replace the values of its file:
{"light.paths": 1024} or ["light.paths=1024"]. Tables are dictionaries."""


def words_of(settings: Settings) -> list[str]:
    """Returns settings as words for the option `--set`."""
    if isinstance(settings, str):
        return [settings]
    if isinstance(settings, Mapping):
        return [f"{key}={_toml(value)}" for key, value in settings.items()]
    return list(settings)


def _toml(value: Any) -> str:
    """Returns a value as TOML on one line."""
    if isinstance(value, Mapping):
        pairs = (f"{key} = {_toml(each)}" for key, each in value.items())
        return f"{{{', '.join(pairs)}}}"
    if isinstance(value, (list, tuple, np.ndarray)):
        return f"[{', '.join(map(_toml, unmasked(value, 'a setting')))}]"
    plain = value.item() if isinstance(value, np.generic) else value
    return tomli_w.dumps({"x": plain}).partition("=")[2].strip()


def number_within(
    kind: type[int] | type[float], least: float, most: float
) -> Callable[[str], Any]:
    """Returns a function that reads the number of an option in a range."""

    def read(word: str) -> Any:
        try:
            value = kind(word)
        except ValueError:
            value = math.nan
        if not least <= value <= most:
            raise argparse.ArgumentTypeError(
                f"{word} (expected: {least:g} .. {most:g})"
            )
        return value

    return read
