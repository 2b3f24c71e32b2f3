# SPDX-License-Identifier: Apache-2.0
"""Builds the manual: pages in Markdown, which include texts of other folders,
and the references of Python and C++ from the sources."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

from pygments.lexers.special import TextLexer

sys.path.insert(0, str(Path(__file__).parent))

from gallery_pages import write_gallery

DOCS = Path(__file__).resolve().parent
TOP = DOCS.parent

project = "ideotype"
author = "the authors of ideotype"
copyright = author + ", Apache License 2.0"
_version = re.search(
    r"set\(IDEOTYPE_VERSION ([0-9.]+)\)", (TOP / "CMakeLists.txt").read_text()
)
assert _version
version = release = _version[1]

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "breathe",
    "sphinx_copybutton",
    "native_math",
]
exclude_patterns = ["_static"]
write_gallery()
nitpicky = True
# Types of other libraries; a build without a network lacks their manuals.
nitpick_ignore_regex = [(r"py:.*", r"(?!ideotype).*"), (r"cpp:.*", r".*")]

myst_enable_extensions = [
    "colon_fence",
    "deflist",
    "dollarmath",
    "substitution",
]
myst_substitutions = {"release": release}
myst_heading_anchors = 4
# Included texts begin below their title, and every header reopens the same
# namespace.
suppress_warnings = ["myst.header", "duplicate_declaration.cpp"]

autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_default_options = {"members": True}

breathe_projects = {"ideotype": os.environ["IDEOTYPE_DOXYGEN"]}
breathe_default_project = "ideotype"
breathe_show_include = False

html_theme = "furo"
html_title = f"ideotype {release}"
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_show_sphinx = False
copybutton_prompt_text = "$ "
copybutton_only_copy_prompt_lines = True


def pages_of_texts() -> dict[tuple[Path, str], str]:
    """Returns the pages that include a text, or a chapter of it, by the path
    of the text and the anchor of the chapter."""
    pages = {}
    for page in DOCS.glob("*.md"):
        for text, options in re.findall(
            r"(?ms)^```\{include\} (\S+)$(.*?)^```$", page.read_text()
        ):
            path = (DOCS / text).resolve()
            heading = re.search(r'(?m)^:start-after: "#+ (.*)"$', options)
            if heading:
                slug = re.sub(r"\W+", "-", heading[1].lower()).strip("-")
                pages[path, "#" + slug] = page.name
            if ":end-before:" not in options:
                pages[path, ""] = page.name
    return pages


PAGES = pages_of_texts()


def rebase_links(text: str, source: Path, folder: Path = DOCS) -> str:
    """Converts the links of a source, for a page in a folder, to links to
    pages of the manual or to downloads of files. Links to folders become
    text."""

    def rebase(link: re.Match[str]) -> str:
        is_image, shown, target, anchor = link.groups("")
        path = (source.parent / target).resolve() if target else source
        if path.is_dir():
            return shown
        name = os.path.relpath(path, folder)
        if is_image:
            return f"![{shown}]({name})"
        if (path, anchor) in PAGES:
            page = os.path.relpath(DOCS / PAGES[path, anchor], folder)
            return f"[{shown}]({page})"
        if not target:
            return link[0]
        if (path, "") in PAGES:
            page = os.path.relpath(DOCS / PAGES[path, ""], folder)
            return f"[{shown}]({page}{anchor})"
        if path.suffix == ".md" and DOCS in path.parents:
            return f"[{shown}]({name}{anchor})"
        return f"[{shown}](path:{name})"

    return re.sub(
        r"(!?)\[([^\]]*)\]\((?![a-z]+:)([^)#\s]*)(#[^)\s]*)?\)", rebase, text
    )


def list_arguments(lines: list[str]) -> list[str]:
    """Converts paragraphs `name: meaning` to a list, and `code` to
    literals."""
    result: list[str] = []
    for line in lines:
        line = re.sub(r"(?<![`:])`([^`]+)`(?!`)", r"``\1``", line)
        argument = re.match(r"([a-z_]+(?:, [a-z_]+)*): (.*)", line)
        if argument and (
            not result or not result[-1] or result[-1][0] in "* "
        ):
            result.append(f"* **{argument[1]}**: {argument[2]}")
        elif line.startswith("    "):
            result.append("  " + line.strip())
        else:
            result.append(line)
    return result


def setup(app: object) -> None:
    def of_page(_app: object, name: str, content: list[str]) -> None:
        page = DOCS / f"{name}.md"
        content[0] = rebase_links(content[0], page, page.parent)

    def of_include(
        _app: object, path: Path, _page: str, content: list[str]
    ) -> None:
        content[0] = rebase_links(content[0], (DOCS / path).resolve())

    def of_docstring(
        _app: object, _what: str, _name: str, _of: object, _options: object,
        lines: list[str],
    ) -> None:  # fmt: skip
        lines[:] = list_arguments(lines)

    app.add_lexer("csv", TextLexer)  # type: ignore[attr-defined]
    app.connect("autodoc-process-docstring", of_docstring)  # type: ignore[attr-defined]
    app.connect("source-read", of_page)  # type: ignore[attr-defined]
    app.connect("include-read", of_include)  # type: ignore[attr-defined]
