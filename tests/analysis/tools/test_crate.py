# SPDX-License-Identifier: Apache-2.0
"""A finished study is described as a Research Object Crate."""

from __future__ import annotations

import hashlib
import json
import shutil
import sys
from pathlib import Path
from typing import Any

import pytest
from made_history import MadeHistory

from ideotype.history import HistoryError
from ideotype.history.study import open_study
from ideotype.tools.crate import METADATA, main, write_crate

ADA = "Ada Lovelace, 0000-0002-1825-0097"
CONTEXT = "https://w3id.org/ro/crate/1.1/context"
TERMS = {
    "about", "actionStatus", "agent", "author", "contentSize",
    "datePublished", "description", "encodingFormat", "hasPart", "instrument",
    "license", "mentions", "name", "object", "result", "sha256",
    "softwareVersion", "startTime", "url", "version", "affiliation", "publisher",
    "CreateAction", "CreativeWork", "Dataset", "Organization", "Person",
    "SoftwareApplication",
}  # fmt: skip
"""The terms of schema.org that a crate has."""


def write_and_read(folder: Path, where: str | None = None) -> dict[str, Any]:
    with open_study(folder) as study:
        path = write_crate(study, folder, [ADA, "Grace"], "CC-BY-4.0", where)
    assert path == folder / METADATA
    return json.loads(path.read_text(encoding="utf-8"))


def test_a_crate_describes_files_authors_licence_and_program(
    sweep: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "of a study"
    shutil.copytree(sweep, folder)
    crate = write_and_read(folder)
    graph = {each["@id"]: each for each in crate["@graph"]}
    root = graph["./"]
    assert graph[METADATA]["about"] == {"@id": "./"}
    for parts in ("hasPart", "author", "mentions", "license"):
        references = (
            root[parts] if isinstance(root[parts], list) else [root[parts]]
        )
        assert references and all(each["@id"] in graph for each in references)
    files = {each["@id"] for each in root["hasPart"]}
    histories = {path.name for path in folder.glob("*.h5")}
    assert histories < files and len(histories) == 4
    for name in files:
        path, entity = folder / name, graph[name]
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
        assert entity["sha256"] == digest
        assert entity["contentSize"] == str(path.stat().st_size)
    people = [graph[each["@id"]]["name"] for each in root["author"]]
    assert people == ["Ada Lovelace", "Grace"]
    for entity in root["mentions"]:
        made = graph[entity["@id"]]
        assert made["result"]["@id"] in histories
        assert {x["@id"] for x in made["object"]} < files
        program = graph[made["instrument"]["@id"]]
        assert program["name"] == "ideotype" and program["softwareVersion"]
        assert "ideotype run" in made["description"]
    texts = {
        (folder / name).read_text()
        for name in files
        if name.startswith("inputs/")
    }
    with open_study(folder) as study:
        for form in ("source", "resolved"):
            assert study[0].campaign(form) in texts
    # A second crate replaces the first.
    assert write_and_read(folder) == crate


def test_unfinished_or_outside_histories_have_no_crate(
    drained: Path, sweep: Path, tmp_path: Path
) -> None:
    words = ["--author", "Ada", "--license", "CC-BY-4.0"]
    assert main([str(drained.parent), *words]) == 1
    assert not (drained.parent / METADATA).exists()
    with (
        open_study(sweep) as study,
        pytest.raises(HistoryError, match="is not in"),
    ):
        write_crate(study, tmp_path, ["Ada"], "CC-BY-4.0")
    with (
        open_study(sweep) as study,
        pytest.raises(HistoryError, match="'12' is no ORCID"),
    ):
        write_crate(study, sweep, ["Ada, 12"], "CC-BY-4.0")


def test_without_rocrate_the_error_states_its_installation(
    sweep: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "rocrate.rocrate", None)
    remedy = "run pip install 'rocrate>=0.16'"
    with open_study(sweep) as study, pytest.raises(HistoryError, match=remedy):
        write_crate(study, sweep, ["Ada"], "CC-BY-4.0")


@pytest.mark.long
def test_a_crate_passes_the_official_validator(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The validator would load the context from the network; the test provides
    a context with the terms of our crates."""
    import requests
    from rdflib.plugins.shared.jsonld.context import Context
    from rocrate_validator import models, services
    from rocrate_validator.utils.http import HttpRequester

    terms = {name: f"http://schema.org/{name}" for name in TERMS}
    terms["File"] = "http://schema.org/MediaObject"
    terms["conformsTo"] = "http://purl.org/dc/terms/conformsTo"

    def load(_: object, source: str, *__: object) -> dict[str, Any]:
        assert source == CONTEXT
        return {"@context": terms}

    monkeypatch.setattr(Context, "_fetch_context", load)
    answer = requests.Response()
    answer.status_code = 200
    answer._content = json.dumps({"@context": terms}).encode()
    answer.headers["Content-Type"] = "application/ld+json"
    monkeypatch.setattr(
        HttpRequester, "get", lambda *_, **__: answer, raising=False
    )
    made = MadeHistory(tmp_path / "a.h5")
    made.evolve(1)
    made.finish()
    made.close()
    crate = write_and_read(tmp_path, "Analytical Society, https://a.org")
    names = set().union(*crate["@graph"])
    assert names - {"@id", "@type", "conformsTo"} <= TERMS

    def problems() -> list[str]:
        validation = services.validate(
            services.ValidationSettings(
                rocrate_uri=models.URI(str(tmp_path)),
                profile_identifier="ro-crate-1.1",
                requirement_severity=models.Severity.RECOMMENDED,
                abort_on_first=False,
            )
        )
        return [
            f"{x.check.identifier}: {x.message}"
            for x in validation.get_issues()
        ]

    assert problems() == []
    # The validator must detect errors.
    for each in crate["@graph"]:
        each.pop("license", None)
    (tmp_path / METADATA).write_text(json.dumps(crate))
    assert problems()
