# SPDX-License-Identifier: Apache-2.0
"""Comments can be read alone: none begins as if it continued another text."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

TOP = Path(__file__).parents[3]
BEGINNING = r"(?:Of|The same|That of|Those of|What|Which|How)\b"
SHELL = ("*.sh", "*.cmake", "*CMakeLists.txt", ".ci/*", "*.toml")
MARKS = {"//[!/]?<?": ("*.cpp", "*.hpp", "*.js"), "#:?": ("*.py", *SHELL)}


def offences(text: str, mark: str) -> list[str]:
    """Returns comments with a forbidden beginning, on separate lines or behind
    code."""
    first = rf"^(?:(?! *{mark}).*|.*SPDX.*)\n *{mark} *({BEGINNING}.*)"
    behind = rf"^ *(?!{mark})\S.* {mark} +({BEGINNING}.*)"
    quoted = rf'^ *"""({BEGINNING}.*)'
    top = rf"\A{mark} *({BEGINNING}.*)"
    found = re.findall(f"(?m){first}|{behind}|{quoted}|{top}", text)
    return ["".join(each) for each in found]


def test_comments_begin_with_what_they_are_about() -> None:
    for text in (
        "x = 1  # %s y.",
        "\n\n# %s z is.",
        "# %s v is.",
        '"""%s w is."""',
    ):
        assert offences(text % "How", "#")
    assert not offences("# A list\n# Of y.", "#")
    found = []
    for mark, names in MARKS.items():
        listed = subprocess.check_output(
            ["git", "ls-files", *names], cwd=TOP, text=True
        ).split()
        for path in (TOP / x for x in listed):
            bad = offences(path.read_text(), mark)
            found += [f"{path.relative_to(TOP)}: {each}" for each in bad]
    assert not found, "\n".join(found)
