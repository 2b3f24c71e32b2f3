# SPDX-License-Identifier: Apache-2.0
"""Texts that people read use the terms of the field.

docs/terms.csv lists the words that they avoid: a pattern, a better text, how
often it may occur in 10,000 words, and contexts that are exempt for a reason.
"""

from __future__ import annotations

import ast
import csv
import io
import re
import subprocess
import tokenize
from collections.abc import Iterator
from pathlib import Path

TOP = Path(__file__).parents[3]

# Names, code and tables of the study are not prose and are removed: code
# blocks and spans, tables between marks, HTML comments, addresses and
# formulas.
CODE = re.compile(
    r"(?ms)^ *(`{3,}|:{3,}).*?^ *\1 *$|<!-- study: .*?<!-- end of study -->"
    r"|<!--.*?-->|`[^`\n]+`|\]\([^)\s]*\)"
    r"|\$[^$\n]+\$|https?://\S+|\\[cp] \S+"
)
C_COMMENT = re.compile(r"//[!/]?<?(.*)$")
C_STRING = re.compile(r'"((?:[^"\\\n]|\\.)* (?:[^"\\\n]|\\.)*)"')
SHELL_COMMENT = re.compile(r"^\s*#(?!!)(.*)$")


def c_texts(text: str, is_read_by_users: bool) -> Iterator[str]:
    for line in text.splitlines():
        comment = C_COMMENT.search(line)
        if comment:
            yield comment[1]
        elif is_read_by_users and not line.lstrip().startswith("#"):
            yield from C_STRING.findall(line)


def python_texts(text: str) -> Iterator[str]:
    """Returns comments, docstrings and other texts that contain spaces."""
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield token.string.lstrip("#: ")
    for node in ast.walk(ast.parse(text)):
        if (
            isinstance(node, ast.Constant)
            and isinstance(node.value, str)
            and " " in node.value
        ):
            yield node.value


def texts_of(path: Path) -> str:
    """Returns the prose of a file."""
    text = path.read_text(encoding="utf-8")
    name = path.relative_to(TOP).as_posix()
    if path.suffix == ".md":
        prose = text
    elif path.suffix == ".py":
        prose = "\n".join(python_texts(text))
    elif path.suffix in (".cpp", ".hpp", ".js"):
        prose = "\n".join(c_texts(text, name.startswith("src/")))
    else:
        prose = "\n".join(
            comment[1]
            for line in text.splitlines()
            if (comment := SHELL_COMMENT.match(line))
        )
    return CODE.sub(" ", prose)


def read_files() -> dict[str, str]:
    """Returns the prose of each file that contains any."""
    listed = subprocess.check_output(
        ["git", "ls-files", "*.md", "*.py", "*.cpp", "*.hpp", "*.js",
         "*.sh", "*.cmake", "*CMakeLists.txt", ".ci/*", "slurm/*"],
        cwd=TOP, text=True,
    ).split()  # fmt: skip
    return {
        name: texts_of(TOP / name)
        for name in sorted(set(listed))
        if "/vendor/" not in name
        and not name.startswith(("tests/data/", "docs/gallery/"))
        and name != Path(__file__).relative_to(TOP).as_posix()
    }


def find_offences(
    prose: dict[str, str], term: dict[str, str]
) -> list[tuple[str, str]]:
    """Returns the file and the surrounding words of each occurrence of a
    term."""
    exempt = re.compile(term["except"]) if term["except"] else None
    return [
        (name, text[max(0, hit.start() - 30) : hit.end() + 30])
        for name, text in prose.items()
        for hit in re.finditer(term["pattern"], text, re.IGNORECASE)
        if exempt is None
        or not exempt.search(text[max(0, hit.start() - 30) : hit.end() + 30])
    ]


def test_texts_use_the_terms_of_the_field() -> None:
    prose = read_files()
    words = sum(len(text.split()) for text in prose.values())
    with (TOP / "docs" / "terms.csv").open(encoding="utf-8") as file:
        terms = list(csv.DictReader(file))
    problems = []
    for term in terms:
        assert not term["except"] or term["reason"], term["pattern"]
        offences = find_offences(prose, term)
        most = float(term["most_per_10000"]) * words / 1e4
        if len(offences) > most:
            shown = "\n".join(
                f"    {name}: {' '.join(around.split())}"
                for name, around in offences[:40]
            )
            problems.append(
                f"{term['pattern']} occurs {len(offences)} times (at most "
                f"{most:.0f} are allowed); write {term['write']}\n{shown}"
            )
    assert not problems, "\n".join(problems)


def test_prose_is_found_and_code_is_not() -> None:
    assert list(c_texts('x("a b"); // Say it.', True)) == [" Say it."]
    assert list(c_texts('x("a b");', True)) == ["a b"]
    assert not list(c_texts('x("a b");', False))
    assert set(python_texts('"""A doc."""\nx = 1  # Why.\n')) == {
        "A doc.",
        "Why.",
    }
    assert CODE.sub("", "a `told` b\n```\ntold\n```\n").split() == ["a", "b"]
