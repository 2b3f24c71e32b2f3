# SPDX-License-Identifier: Apache-2.0
"""Distinct names for the contents of several files."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path


def distinct_names(names: Sequence[str], paths: Sequence[str]) -> list[str]:
    """Returns the names; equal names are followed by the part in which their
    paths differ, such as "b73 (results)" and "b73 (long)". Names with equal
    paths get numbers. An empty path means none."""
    groups: dict[str, list[int]] = {}
    for i, name in enumerate(names):
        groups.setdefault(name, []).append(i)
    distinct = list(names)
    for name, members in groups.items():
        parts = _differing_parts([paths[i] for i in members])
        for i, part in zip(members, parts):
            if part:
                distinct[i] = f"{name} ({part})"
    times: Counter[str] = Counter()
    for i, name in enumerate(distinct):
        times[name] += 1
        if times[name] > 1:
            distinct[i] = f"{name} ({times[name]})"
    return distinct


def _differing_parts(paths: Sequence[str]) -> list[str]:
    """Returns each path without its common beginning and end."""
    parts = [Path(path).parts for path in paths]
    begin = _shared(parts)
    end = _shared([x[begin:][::-1] for x in parts])
    return ["/".join(x[begin : len(x) - end]) for x in parts]


def _shared(paths: Sequence[tuple[str, ...]]) -> int:
    """Returns the number of leading parts that all paths share."""
    count = 0
    for parts in zip(*paths):
        if len({*parts}) > 1:
            break
        count += 1
    return count
