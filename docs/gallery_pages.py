# SPDX-License-Identifier: Apache-2.0
"""Writes the gallery of the manual: one page for each example of
analysis/examples, with its picture and introduction, and one of thumbnails."""

from __future__ import annotations

import ast
import json
import re
from pathlib import Path

DOCS = Path(__file__).resolve().parent
EXAMPLES = DOCS.parent / "analysis" / "examples"
LANGUAGES = {".py": "python", ".sh": "bash", ".cpp": "cpp"}
NAMES = {
    ".py": "Python",
    ".sh": "command line",
    ".cpp": "C++",
    ".ipynb": "notebook",
}

INTRODUCTION = """# Gallery

Twenty examples, from a single leaf to modules over a crop. Each takes less than
a minute on two cores, is a test of the project, and runs in the top folder of a
clone: those in Python with the package, those of the command line with the
program too, and those in C++ with the installed library
(`cmake -S analysis/examples -B build/examples`).
`analysis/examples/draw.py` draws the pictures.

"""


def introduction(example: Path) -> str:
    """Returns the introduction of an example: its docstring, first comment or
    first cell."""
    text = example.read_text()
    if example.suffix == ".py":
        return ast.get_docstring(ast.parse(text)) or ""
    if example.suffix == ".ipynb":
        cell = next(
            x
            for x in json.loads(text)["cells"]
            if x["cell_type"] == "markdown"
        )
        return "".join(cell["source"]).removeprefix("# ")
    mark = "//" if example.suffix == ".cpp" else "#"
    lines = []
    for line in text.splitlines():
        if line.startswith("#!") or "SPDX-License-Identifier" in line:
            continue
        if not line.startswith(mark):
            break
        lines.append(line.removeprefix(mark).removeprefix(" "))
    return "\n".join(lines)


def parts(example: Path) -> tuple[str, str]:
    """Returns the title of an example and the rest of its introduction."""
    title, _, rest = introduction(example).partition("\n\n")
    return re.sub(r"\s+", " ", title).strip().rstrip("."), rest.strip()


def page(example: Path) -> str:
    title, rest = parts(example)
    path = f"../../analysis/examples/{example.name}"
    lines = [
        f"# {int(example.name[:2])}. {title}",
        "",
        rest,
        "",
        f"![{title}](../figures/gallery/{example.stem}.png)",
        "",
    ]
    if language := LANGUAGES.get(example.suffix):
        lines += [
            f"`analysis/examples/{example.name}`:",
            "",
            f"```{{literalinclude}} {path}",
            f":language: {language}",
            "```",
        ]
    else:
        lines.append(f"{{download}}`{example.name} <{path}>` is a notebook.")
    return "\n".join(lines) + "\n"


def write_gallery(folder: Path = DOCS / "gallery") -> None:
    folder.mkdir(exist_ok=True)
    for old in folder.glob("*.md"):
        old.unlink()
    index = [INTRODUCTION, "::::{container} gallery\n"]
    examples = sorted(EXAMPLES.glob("[0-9][0-9]_*"))
    for example in examples:
        (folder / f"{example.stem}.md").write_text(page(example))
        title, _ = parts(example)
        index.append(
            f":::{{container}} example\n"
            f"```{{image}} ../figures/gallery/{example.stem}.png\n"
            f":alt: {title}\n:target: {example.stem}.html\n```\n"
            f"[{int(example.name[:2])}. {title}]({example.stem}.md) "
            f"({NAMES[example.suffix]})\n:::\n"
        )
    index.append("::::\n\n```{toctree}\n:hidden:\n")
    index += [example.stem for example in examples]
    index.append("```")
    (folder / "index.md").write_text("\n".join(index) + "\n")
