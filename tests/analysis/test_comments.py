# SPDX-License-Identifier: Apache-2.0
"""Comments can be read alone: none begins as if it continued another text."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

TOP = Path(__file__).parents[2]
#: Parts whose comments are not mended yet.
LATER = r"(src|include/ideotype|tests)/(campaign|canopy)/"
BEGINNING = r"(?:Of|The same|That of|Those of|What|Which|How)\b"
MARKS = {"py": "#:?", "sh": "#", "cpp": "//[!/]?<?", "hpp": "//[!/]?<?"}


def offences(text: str, mark: str) -> list[str]:
    """Returns comments that begin so, on lines of their own or behind code."""
    first = rf"^(?! *{mark}).*\n *{mark} *({BEGINNING}.*)"
    behind = rf"^ *(?!{mark})\S.* {mark} +({BEGINNING}.*)"
    quoted = rf'^ *"""({BEGINNING}.*)'
    found = re.findall(f"(?m){first}|{behind}|{quoted}", text)
    return ["".join(each) for each in found]


def test_comments_begin_with_what_they_are_about() -> None:
    for text in ("x = 1  # %s y.", "\n\n# %s z is.", '"""%s w is."""'):
        assert offences(text % "How", MARKS["py"])
    assert not offences("# A list\n# Of y.", MARKS["py"])
    listed = subprocess.run(
        ["git", "ls-files", *(f"*.{kind}" for kind in MARKS)],
        cwd=TOP, capture_output=True, text=True, check=True,
    )  # fmt: skip
    found = [
        f"{name}: {each}"
        for name in listed.stdout.split()
        if not re.match(LATER, name)
        for each in offences(
            (TOP / name).read_text(), MARKS[name.rpartition(".")[2]]
        )
    ]
    assert not found, "\n".join(found)
