# SPDX-License-Identifier: Apache-2.0
"""The page of policies counts its items correctly, and the evidence that it
cites exists."""

from __future__ import annotations

import re
import shutil
from collections import Counter
from pathlib import Path

TOP = Path(__file__).parents[3]
PAGE = (TOP / "docs/policies.md").read_text()
LISTS = {
    name: re.findall(r"(?m)^\| (.+) \| ([ypn-]) \| ([ypn-]) \| (.+) \|$", part)
    for name, part in re.findall(r"(?ms)^## (\w+)$(.*?)(?=^## |\Z)", PAGE)
}


def test_counts_of_policies_agree_with_their_lists() -> None:
    counts = re.findall(
        r"(?m)^\| \[(\w+)\]\(#\w+\) \| (\d+) \| (.*?) \| (.*?) \|$", PAGE
    )
    assert [name for name, *_ in counts] == list(LISTS)
    for name, items, before, now in counts:
        rows = LISTS[name]
        # The count excludes the header of the table and its separator line.
        part = PAGE.split(f"\n## {name}\n")[1].split("\n## ")[0]
        assert len(re.findall(r"(?m)^\|", part)) == len(rows) + 2, name
        assert len({row[0] for row in rows}) == len(rows) == int(items), name
        for column, written in ((1, before), (2, now)):
            found = Counter(row[column] for row in rows)
            assert written == ", ".join(str(found[x]) for x in "ypn-"), name


def test_evidence_of_policies_exists() -> None:
    for rows in LISTS.values():
        for item, _, now, evidence in rows:
            named = re.findall("`([^`]+)`", evidence)
            assert named or now != "y", f"{item} has no evidence"
            for each in named:
                first = each.split()[0]
                assert (TOP / first).exists() or shutil.which(first), (
                    f"{item}: there is no {first}"
                )
