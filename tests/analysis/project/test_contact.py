# SPDX-License-Identifier: Apache-2.0
"""Names and addresses of the project agree with .github/contact.toml. With
IDEOTYPE_WRITE_GOLDEN they are written into the other files."""

from __future__ import annotations

import os
import re
import subprocess
import tomllib
from pathlib import Path

import pytest

TOP = Path(__file__).parents[3]
CONTACT = TOP / ".github/contact.toml"
VALUES: dict[str, str] = tomllib.loads(CONTACT.read_text())

QUOTED = '"([^"]*)"'
LINK = r"<(https:[^>]*|[^>\s]*@[^>]*)>"
PLACES = (
    ("pyproject.toml", f"authors = .* name = {QUOTED}", "authors"),
    ("pyproject.toml", f"authors = .* email = {QUOTED}", "email"),
    ("pyproject.toml", f"Homepage = {QUOTED}", "homepage"),
    ("pyproject.toml", f"Documentation = {QUOTED}", "manual"),
    ("pyproject.toml", f"Repository = {QUOTED}", "repository"),
    ("pyproject.toml", f"Issues = {QUOTED}", "issues"),
    ("CITATION.cff", "  - name: (.*)", "authors"),
    ("CITATION.cff", "url: (.*)", "homepage"),
    ("CITATION.cff", "repository-code: (.*)", "repository"),
    ("codemeta.json", f' {{6}}"name": {QUOTED}', "authors"),
    ("codemeta.json", f' *"email": {QUOTED}', "email"),
    ("codemeta.json", f'  "url": {QUOTED}', "homepage"),
    ("codemeta.json", f'  "codeRepository": {QUOTED}', "repository"),
    ("codemeta.json", f'  "issueTracker": {QUOTED}', "issues"),
    ("codemeta.json", f' *"id": {QUOTED}', "manual"),
    (".ci/packaging/package.py", f"    homepage = {QUOTED}", "homepage"),
    (".ci/packaging/package.py", f"    git = {QUOTED}", "repository"),
    ("SECURITY.md", f"Write to {LINK}", "security"),
    ("SECURITY.md", "within ([0-9]+ days), agree", "acknowledged"),
    ("SECURITY.md", "within ([0-9]+ days)\\.", "fixed"),
    ("SUPPORT.md", f"  {LINK}\\)", "manual"),
    ("SUPPORT.md", f"bugs\\*\\*: {LINK}", "issues"),
    ("SUPPORT.md", f"or {LINK}", "email"),
    ("CODE_OF_CONDUCT.md", f"write to {LINK}", "conduct"),
    ("CONTRIBUTING.md", r"\[issue\]\((.*?)\)", "issues"),
    ("CONTRIBUTING.md", f"format-patch` to {LINK}", "email"),
    (".github/ISSUE_TEMPLATE/config.yml", "mail to (.*) \\(", "security"),
    (".github/ISSUE_TEMPLATE/config.yml", "Manual\n    url: (.*)", "manual"),
    (
        ".github/ISSUE_TEMPLATE/config.yml",
        "Vulnerability\n    url: (.*)",
        "homepage",
    ),
    # The files of packages, if the package exists.
    (".ci/packaging/debian/control", "Maintainer: (.*) <", "authors"),
    (".ci/packaging/debian/control", "Maintainer: .* <(.*)>", "email"),
    (".ci/packaging/debian/control", "Homepage: (.*)", "homepage"),
    (".ci/packaging/debian/control", "Vcs-Git: (.*)", "repository"),
)
"""Where a value stands: a file, the text around it, and its key."""
OPTIONAL = {".ci/packaging/debian/control"}


@pytest.mark.parametrize(("name", "around", "key"), PLACES)
def test_documents_have_the_values_of_contact_toml(
    name: str, around: str, key: str
) -> None:
    path = TOP / name
    if name in OPTIONAL and not path.exists():
        pytest.skip(f"there is no {name}")
    text = path.read_text()
    values = re.findall(f"(?m){around}", text)
    if name in OPTIONAL and not values:
        pytest.skip(f"{name} does not state {key}")
    assert values, f"{name} no longer states {key}"
    if "IDEOTYPE_WRITE_GOLDEN" in os.environ:

        def replaced(match: re.Match[str]) -> str:
            start, end = (x - match.start() for x in match.span(1))
            return match[0][:start] + VALUES[key] + match[0][end:]

        path.write_text(re.sub(f"(?m){around}", replaced, text))
    else:
        assert set(values) == {VALUES[key]}, f"{name} disagrees on {key}"


def test_placeholders_are_only_in_known_places() -> None:
    """Placeholder addresses occur only where contact.toml inserts them. Hosts
    in examples of the manual have a different name."""
    listed = subprocess.run(
        ["git", "grep", "-lI", r"[/@]example\.org"],
        cwd=TOP, capture_output=True, text=True, check=False,
    ).stdout.split()  # fmt: skip
    assert (".github/contact.toml" in listed) == bool(placeholders())
    for name in listed:
        if name == "tests/analysis/project/test_contact.py":
            continue
        text = (TOP / name).read_text()
        for address in re.findall(
            r"https://example\.org[\w/.-]*|[\w.-]+@example\.org", text
        ):
            assert address.rstrip(".") in VALUES.values() or VALUES[
                "repository"
            ].startswith(f"{address}/"), f"{name}: {address}"


def placeholders() -> set[str]:
    return {key for key, value in VALUES.items() if "example.org" in value}


def test_the_page_of_policies_lists_open_placeholders() -> None:
    page = (TOP / "docs/policies.md").read_text()
    _, section = page.split("\n## Only the owner can\n")
    listed = set(re.findall(r"`([a-z]+)`", section.split("\n## ")[0]))
    confirmed = {"acknowledged", "fixed", "authors"}
    assert listed & set(VALUES) - confirmed == placeholders()
