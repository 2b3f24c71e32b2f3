# SPDX-License-Identifier: Apache-2.0
"""Writes a finished study as a Research Object Crate (RO-Crate 1.1,
doi:10.3233/DS-210053): inputs, program, results, authors."""

from __future__ import annotations

import argparse
import hashlib
import json
import re
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any
from urllib.parse import quote

import tomli_w

from ..common.output import file_name, require_output, write_file
from ..history.case import Case
from ..history.estimate import NORMAL
from ..history.file import HistoryError
from ..history.history import History
from ..history.study import Study
from .commands import guarded

METADATA = "ro-crate-metadata.json"
_INPUTS = "inputs"
"""The folder of the inputs with which histories were begun."""

_PAGES = (
    ("results.csv", "text/csv", "A line for each case."),
    ("report.html", "text/html", "The report about all histories."),
)
"""Names, formats and meanings of the files of reports."""

_SPECIFICATION = "https://w3id.org/ro/crate/1.1"
_TOML = "application/toml"
_ORCID = re.compile(r"(?:https://orcid\.org/)?(\d{4}-\d{4}-\d{4}-\d{3}[\dX])")
_Entity = dict[str, Any]


def main(arguments: Sequence[str] | None = None) -> int:
    """Answers `ideotype crate` and returns the exit code."""
    parser = argparse.ArgumentParser(
        prog="ideotype crate",
        description="Describes a folder of finished histories as a Research "
        f"Object Crate: writes {METADATA}, and the campaign, crop and weather "
        f"of each history into {_INPUTS}/.",
    )
    add = parser.add_argument
    add("results", nargs=1, metavar="FOLDER", help="folder of the histories")
    add(
        "--author", action="append", required=True, metavar="NAME[, ORCID]",
        help="who made the study; may be repeated",
    )  # fmt: skip
    add(
        "--license", required=True, metavar="SPDX",
        help="licence of the results by its SPDX name, such as CC-BY-4.0",
    )  # fmt: skip
    add("--organisation", metavar="NAME[, URL]", help="where the authors work")
    add("--title", help="name of the crate (default: that of the campaigns)")

    def write(options: argparse.Namespace, study: Study) -> None:
        print(
            write_crate(
                study, options.results[0], options.author, options.license,
                options.organisation, options.title,
            )
        )  # fmt: skip

    return guarded(parser, arguments, write)


def write_crate(
    study: Study,
    folder: str | Path,
    authors: Sequence[str],
    license: str,
    organisation: str | None = None,
    title: str | None = None,
) -> Path:
    """Writes the metadata of a folder that holds all histories of a study, and
    the histories' inputs beside them; an earlier crate is replaced. Authors
    are "NAME" or "NAME, ORCID". Returns the path of the metadata.

    Raises HistoryError if a history is not finished, or a file of the crate
    lies elsewhere; OutputRefused if a symbolic link is where a file or folder
    is to be written; OSError if the folder can't be written."""
    folder = Path(folder)
    for history in study:
        if not history.state().finished:
            raise HistoryError(
                f"{history.path}: {history.state()}; a crate takes finished "
                "histories only"
            )
        _require_inside(history.path, folder)
    for path in (folder / METADATA, folder / _INPUTS / "any"):
        require_output(path, folder)
    for page, *_ in _PAGES:
        for path in folder.rglob(page):
            _require_inside(path, folder)
    every = list(_entities(study, folder, _people(authors, organisation)))
    bred = ", ".join(sorted({str(h.attributes["campaign"]) for h in study}))
    root = {
        "@id": "./",
        "@type": "Dataset",
        "name": title or f"Ideotypes of {bred}",
        "description": (
            f"Plants that the program ideotype has bred for {bred}, with all "
            f"evaluations; number of searches: {len(study)}."
        ),
        "datePublished": datetime.now(UTC).date().isoformat(),
        "license": _of(license_url := f"https://spdx.org/licenses/{license}"),
        "author": _all_of(every, "Person"),
        "hasPart": _all_of(every, "File"),
        "mentions": _all_of(every, "CreateAction"),
    }
    if organisation:
        root["publisher"] = _all_of(every, "Organization")
    about = {
        "@id": METADATA,
        "@type": "CreativeWork",
        "conformsTo": _of(_SPECIFICATION),
        "about": _of("./"),
    }
    terms = {
        "@id": license_url,
        "@type": "CreativeWork",
        "name": license,
        "description": f"The licence {license}, as SPDX has it.",
    }
    path = folder / METADATA
    text = json.dumps(
        {
            "@context": f"{_SPECIFICATION}/context",
            "@graph": [about, root, terms, *every],
        },
        indent=2,
        ensure_ascii=False,
    )
    write_file(path, text + "\n", folder)
    return path


def _of(name: str) -> _Entity:
    return {"@id": name}


def _all_of(
    every: Sequence[_Entity], kind: str = ""
) -> _Entity | list[_Entity]:
    """Returns references to all entities, or to the entities of a type: a
    list, or the reference to a single entity."""
    found = [_of(e["@id"]) for e in every if kind in ("", e["@type"])]
    return found[0] if len(found) == 1 else found


def _entities(
    study: Study, folder: Path, makers: Sequence[_Entity]
) -> Iterator[_Entity]:
    """Returns each entity to which the root of a crate refers once."""
    found = {each["@id"]: each for each in makers}
    for case in study.cases():
        for history in case.histories:
            inputs = list(_inputs(history, folder))
            program = _program(history)
            result = _history(case, history, folder)
            made = _action(history, inputs, program, result, makers)
            for each in (*inputs, program, result, made):
                found[each["@id"]] = each
    for page, kind, about in _PAGES:
        for path in sorted(folder.rglob(page)):
            each = _file(path, folder, kind, page, about)
            found[each["@id"]] = each
    return iter(found.values())


def _people(authors: Sequence[str], organisation: str | None) -> list[_Entity]:
    """Returns the authors and any organisation."""
    people = [_person(author, k) for k, author in enumerate(authors, start=1)]
    if not organisation:
        return people
    name, _, url = (part.strip() for part in organisation.partition(", http"))
    where = {
        "@id": f"http{url}" if url else "#organisation",
        "@type": "Organization",
        "name": name,
    }
    if url:
        where["url"] = where["@id"]
    return [
        *(each | {"affiliation": _of(where["@id"])} for each in people),
        where,
    ]


def _person(author: str, number: int) -> _Entity:
    name, _, identity = (part.strip() for part in author.partition(","))
    if not identity:
        return {"@id": f"#author-{number}", "@type": "Person", "name": name}
    if not (found := _ORCID.fullmatch(identity)):
        raise HistoryError(
            f"'{identity}' is no ORCID; write it as 0000-0002-1825-0097"
        )
    url = f"https://orcid.org/{found[1]}"
    return {"@id": url, "@type": "Person", "name": name}


def _program(history: History) -> _Entity:
    has = history.attributes
    version = str(has["program_version"])
    told = ", ".join(
        str(has[part])
        for part in ("compiler", "embree_version", "hdf5_version", "isa")
        if part in has
    )
    return {
        "@id": f"#ideotype-{version}",
        "@type": "SoftwareApplication",
        "name": "ideotype",
        "version": version,
        "softwareVersion": version,
        "description": f"Commit {has.get('git_sha', 'unknown')}; {told}.",
        "license": _of("https://spdx.org/licenses/Apache-2.0"),
    }


def _inputs(history: History, folder: Path) -> Iterator[_Entity]:
    """Writes the inputs with which a history was begun, and describes each
    file."""
    campaign = str(history.attributes["campaign"])
    texts = {
        "": (history.campaign(), "The campaign as its author wrote it."),
        "_resolved": (
            history.campaign("resolved"),
            "The campaign with every default, crop and weather.",
        ),
    }
    if crop := history.resolved.get("plant", {}).get("baseline"):
        told = "The crop and the plant that the search begins with."
        texts["_crop"] = tomli_w.dumps(crop), told
    if weather := history.resolved.get("weather"):
        told = "The weather in steps, as evaluations take it."
        texts["_weather"] = tomli_w.dumps({"weather": weather}), told
    for part, (text, about) in texts.items():
        # Campaigns with equal names may differ in content.
        digest = hashlib.sha256(text.encode()).hexdigest()[:8]
        name = f"{file_name(campaign)}{part}_{digest}.toml"
        write_file(path := folder / _INPUTS / name, text, folder)
        yield _file(path, folder, _TOML, f"{campaign}{part}", about)


def _history(case: Case, history: History, folder: Path) -> _Entity:
    about = f"All evaluations of one search of the case {case.name}."
    if pair := history.comparison():
        gain = pair.gain
        about += (
            f" Gain of the best plant in {pair.best.row.goals[0].name}: "
            f"{gain.mean:.4g} % (95 % interval of its light: "
            f"{NORMAL * gain.standard_error:.2g})."
        )
    return _file(
        history.path, folder, "application/x-hdf5",
        str(history.attributes["case"]), about,
    )  # fmt: skip


def _require_inside(path: Path, folder: Path) -> None:
    if folder.resolve() not in path.resolve().parents:
        raise HistoryError(
            f"{path}: this file is not in {folder}; move it there, or name "
            "another folder"
        )


def _file(
    path: Path, folder: Path, kind: str, name: str, about: str
) -> _Entity:
    with path.open("rb") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
    return {
        "@id": quote(path.resolve().relative_to(folder.resolve()).as_posix()),
        "@type": "File",
        "name": name,
        "description": about,
        "encodingFormat": kind,
        "contentSize": str(path.stat().st_size),
        "sha256": digest,
    }


def _action(
    history: History,
    inputs: Sequence[_Entity],
    program: _Entity,
    result: _Entity,
    makers: Sequence[_Entity],
) -> _Entity:
    """Describes how a history came to be."""
    sessions = history.sessions()
    return {
        "@id": f"#search-{result['@id']}",
        "@type": "CreateAction",
        "name": f"Search {result['name']}",
        "description": "; then ".join(s.command for s in sessions),
        "instrument": _of(program["@id"]),
        "object": _all_of(inputs),
        "result": _of(result["@id"]),
        "agent": _all_of(makers, "Person"),
        "startTime": sessions[0].started,
        "actionStatus": "http://schema.org/CompletedActionStatus",
    }
