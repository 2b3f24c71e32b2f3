# SPDX-License-Identifier: Apache-2.0
"""The files that describe the project to other programs agree with each other
and with the changelog."""

from __future__ import annotations

import io
import json
import re
import subprocess
import tarfile
import tomllib
from datetime import date
from pathlib import Path

import pytest
import yaml

TOP = Path(__file__).parents[3]
PROJECT = tomllib.loads((TOP / "pyproject.toml").read_text())["project"]
CITATION = yaml.safe_load((TOP / "CITATION.cff").read_text())
CODEMETA = json.loads((TOP / "codemeta.json").read_text())
VERSION = re.search(
    r"set\(IDEOTYPE_VERSION ([0-9.]+)\)", (TOP / "CMakeLists.txt").read_text()
)[1]

CODEMETA_TERMS = set(
    re.findall(
        r"\w+",
        """address affiliation applicationCategory applicationSubCategory author
    buildInstructions citation codeRepository continuousIntegration contributor
    copyrightHolder copyrightYear dateCreated dateModified datePublished
    description developmentStatus downloadUrl editor email embargoEndDate
    encoding endDate familyName fileFormat fileSize funder funding givenName
    hasPart hasSourceCode id identifier installUrl isAccessibleForFree isPartOf
    isSourceCodeOf issueTracker keywords license maintainer memoryRequirements
    name operatingSystem permissions position processorRequirements producer
    programmingLanguage provider publisher readme referencePublication
    relatedLink releaseNotes review reviewAspect reviewBody roleName
    runtimePlatform sameAs softwareHelp softwareRequirements
    softwareSuggestions softwareVersion sponsor startDate storageRequirements
    supportingData targetProduct type url version""",
    )
)
"""The terms of https://w3id.org/codemeta/3.0; others would be lost."""


def releases() -> dict[str, str]:
    """Returns the changelog of each release, newest first, by the version and
    date in its heading."""
    parts = re.split(
        r"(?m)^## (?=[0-9])(.*)$", (TOP / "CHANGELOG.md").read_text()
    )
    return dict(zip(parts[1::2], parts[2::2], strict=True))


def test_descriptions_of_the_project_agree() -> None:
    assert CITATION["version"] == CODEMETA["version"] == VERSION
    assert CITATION["title"] == CODEMETA["name"] == PROJECT["name"]
    assert CITATION["abstract"] == CODEMETA["description"]
    assert CITATION["abstract"].startswith(PROJECT["description"])
    assert CITATION["license"] == PROJECT["license"]["text"]
    assert CODEMETA["license"].endswith("/" + CITATION["license"])
    authors = [each["name"] for each in PROJECT["authors"]]
    assert [each["name"] for each in CITATION["authors"]] == authors
    assert [each["name"] for each in CODEMETA["author"]] == authors
    assert CITATION["keywords"] == CODEMETA["keywords"] == PROJECT["keywords"]


def test_codemeta_has_no_unknown_term() -> None:
    def collect_keys(value: object) -> set[str]:
        if isinstance(value, list):
            return set().union(*map(collect_keys, value))
        if isinstance(value, dict):
            return set(value).union(*map(collect_keys, value.values()))
        return set()

    assert CODEMETA["@context"] == "https://w3id.org/codemeta/3.0"
    assert collect_keys(CODEMETA) - {"@context"} <= CODEMETA_TERMS


def test_each_release_has_its_date_and_names_vulnerabilities() -> None:
    dates = []
    for heading, text in releases().items():
        version, day = re.fullmatch(
            r"([0-9.]+) - ([0-9]{4}-[0-9]{2}-[0-9]{2})", heading
        ).groups()
        dates.append(date.fromisoformat(day))
        assert re.match(r"\n\nVulnerabilities: .+\.\n\n", text), version
    assert dates == sorted(dates, reverse=True)
    version, day = next(iter(releases())).split(" - ")
    assert version == VERSION
    assert str(CITATION["date-released"]) == CODEMETA["datePublished"] == day


def test_blame_ignores_listed_commits() -> None:
    def git(*words: str) -> str:
        return subprocess.check_output(["git", *words], cwd=TOP, text=True)

    if git("rev-parse", "--is-shallow-repository").strip() == "true":
        pytest.skip("this clone lacks the history")
    text = (TOP / ".git-blame-ignore-revs").read_text()
    entries = re.findall(r"(?m)^# (.*)\n([0-9a-f]{40})$", text)
    assert len(entries) == len(re.findall(r"(?m)^[^#\n]", text)) > 0
    for subject, commit in entries:
        git("merge-base", "--is-ancestor", commit, "HEAD")
        assert git("log", "-1", "--format=%s", commit).strip() == subject


def test_archives_contain_the_sources_without_git_settings() -> None:
    tree = subprocess.check_output(
        ["git", "write-tree"], cwd=TOP, text=True
    ).strip()
    archive = subprocess.check_output(["git", "archive", tree], cwd=TOP)
    with tarfile.open(fileobj=io.BytesIO(archive)) as files:
        names = set(files.getnames())
    assert {".ci/install", "test.sh", ".github/contact.toml"} <= names
    hidden = {name for name in names if name.startswith((".git", ".read"))}
    assert hidden <= {".github", ".github/contact.toml"}


def test_read_the_docs_builds_the_manual_by_its_script() -> None:
    """Read the Docs installs packages as an administrator and then calls
    docs/build, which is not permitted to install."""
    settings = yaml.safe_load((TOP / ".readthedocs.yaml").read_text())
    build = settings["build"]
    assert build["jobs"]["build"]["html"][0] == "docs/build"
    script = (TOP / ".ci/install").read_text()
    packages = re.search(r'(?s)local packages=\((.*?)"\$@"\)', script)[1]
    (more,) = re.findall(
        "install_packages (.*)", (TOP / "docs/build").read_text()
    )
    assert build["apt_packages"] == [*packages.split(), *more.split()]
