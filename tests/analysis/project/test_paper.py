# SPDX-License-Identifier: Apache-2.0
"""The paper follows the form of the Journal of Open Source Software, and its
numbers agree with their source files."""

from __future__ import annotations

import re
from pathlib import Path

TOP = Path(__file__).parents[3]
PAPER = (TOP / "paper/paper.md").read_text()
ENTRIES = dict(
    re.findall(
        r"(?ms)^@\w+\{(\w+),\n(.*?)^\}",
        (TOP / "paper/paper.bib").read_text(),
    )
)
SECTIONS = [
    "Summary",
    "Statement of need",
    "State of the field",
    "Software design",
    "Research impact statement",
    "AI usage disclosure",
    "Acknowledgements",
    "References",
]


def test_the_paper_has_the_sections_and_the_length_of_the_journal() -> None:
    assert re.findall("(?m)^# (.*)$", PAPER) == SECTIONS
    body = PAPER.split("---\n", 2)[2].split("# References")[0]
    text = re.sub(r"(?s)<!--.*?-->|\[@[^]]*\]", "", body)
    assert 750 <= len(text.split()) <= 1750


def test_citations_and_references_agree() -> None:
    cited = set(re.findall(r"@([a-z]+[0-9]{4})", PAPER))
    assert cited == set(ENTRIES)
    for name, entry in ENTRIES.items():
        assert re.search(r"(?m)^  (doi|url) = \{\S+\},?$", entry), name


def test_figures_of_the_paper_agree_with_their_source() -> None:
    """A comment in the paper names the source, the numbers and the command."""
    notes = re.findall(
        r"<!-- figures: (\S+): (.*?); command: (.*?) -->", PAPER
    )
    assert len(notes) == PAPER.count("<!--") == 6
    text = " ".join(re.sub("(?s)<!--.*?-->", "", PAPER).split())
    for source, figures, command in notes:
        origin = " ".join((TOP / source).read_text().split())
        for figure in figures.split("; "):
            assert figure in text, figure
            assert figure in origin, f"{figure} is no longer in {source}"
        for name in re.findall(r"[\w./]+/[\w./]+", command):
            assert (TOP / name).exists(), name
