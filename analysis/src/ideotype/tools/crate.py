# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype crate`: describes a finished study as a Research
Object Crate (RO-Crate 1.1, doi:10.3233/DS-210053): inputs, program, results,
authors."""

from __future__ import annotations

import argparse
import hashlib
import json
import re
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import tomli_w

from ..common.output import file_name, require_output, write_file
from ..history.case import Case
from ..history.estimate import NORMAL
from ..history.file import HistoryError
from ..history.history import History
from ..history.study import Study
from .commands import guarded

if TYPE_CHECKING:
    from rocrate.model.entity import Entity
    from rocrate.rocrate import ROCrate

METADATA = "ro-crate-metadata.json"
_INPUTS = "inputs"
"""The folder for the inputs of histories."""

_PAGES = (
    ("results.csv", "text/csv", "A line for each case."),
    ("report.html", "text/html", "The report about all histories."),
)
"""The names, formats and descriptions of the files of reports."""

_TOML = "application/toml"
_ORCID = re.compile(r"(?:https://orcid\.org/)?(\d{4}-\d{4}-\d{4}-\d{3}[\dX])")


def main(arguments: Sequence[str] | None = None) -> int:
    """Writes a crate and returns the exit code, as `ideotype summary`."""
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
        help="author of the study; may be repeated",
    )  # fmt: skip
    add(
        "--license", required=True, metavar="SPDX",
        help="licence of the results by its SPDX name, such as CC-BY-4.0",
    )  # fmt: skip
    add("--organisation", metavar="NAME[, URL]", help="their affiliation")
    add("--title", help="title of the crate (default: by the campaigns)")

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
    """Writes the metadata of a study into its folder, and the inputs of its
    histories into the subfolder "inputs"; replaces an earlier crate. Returns
    the path of the metadata.

    study: finished histories, all in `folder`.
    authors: "NAME" or "NAME, ORCID" of each author.
    license: SPDX name of the licence of the results.
    organisation: affiliation of the authors, "NAME" or "NAME, URL".
    title: title of the crate, by default made of the names of campaigns.

    Raises HistoryError if a history is not finished or a file is outside the
    folder; OutputRefused if an output is a symbolic link; OSError if the
    folder can't be written."""
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
    crate = _empty_crate()
    people = _people(crate, authors, organisation)
    searches = [
        _search(crate, case, history, folder, people)
        for case in study.cases()
        for history in case.histories
    ]
    for page, kind, about in _PAGES:
        for path in sorted(folder.rglob(page)):
            _file(crate, path, folder, kind, page, about)
    names = ", ".join(sorted({str(h.attributes["campaign"]) for h in study}))
    root = crate.root_dataset
    root["name"] = title or f"Ideotypes of {names}"
    root["description"] = (
        f"Plants designed by the program ideotype for {names}, with all "
        f"evaluations; number of searches: {len(study)}."
    )
    root["datePublished"] = datetime.now(UTC).date().isoformat()
    root["license"] = _add(
        crate, f"https://spdx.org/licenses/{license}", "CreativeWork",
        name=license, description=f"The licence {license} of the SPDX list.",
    )  # fmt: skip
    # A list of one element is written as this element.
    root.append_to("author", people, compact=True)
    root.append_to("mentions", searches, compact=True)
    if organisation:
        root["publisher"] = people[0]["affiliation"]
    path = folder / METADATA
    text = json.dumps(crate.metadata.generate(), indent=2, ensure_ascii=False)
    write_file(path, text + "\n", folder)
    return path


def _empty_crate() -> ROCrate:
    try:
        from rocrate.rocrate import ROCrate
    except ImportError as error:
        raise HistoryError(
            "crates need rocrate, which is not installed; run "
            "pip install 'rocrate>=0.16'"
        ) from error
    return ROCrate(version="1.1")


def _add(
    crate: ROCrate, identity: str, kind: str, **properties: Any
) -> Entity:
    from rocrate.model.contextentity import ContextEntity

    has = {"@type": kind}
    for key, value in properties.items():
        is_one = isinstance(value, list) and len(value) == 1
        has[key] = value[0] if is_one else value
    return crate.add(ContextEntity(crate, identity, properties=has))


def _people(
    crate: ROCrate, authors: Sequence[str], organisation: str | None
) -> list[Entity]:
    """Adds the authors and their organisation, if any, to the crate."""
    people = []
    for number, author in enumerate(authors, start=1):
        name, _, identity = (part.strip() for part in author.partition(","))
        url = f"#author-{number}"
        if identity:
            if not (match := _ORCID.fullmatch(identity)):
                raise HistoryError(
                    f"'{identity}' is no ORCID; write it as "
                    "0000-0002-1825-0097"
                )
            url = f"https://orcid.org/{match[1]}"
        people.append(_add(crate, url, "Person", name=name))
    if organisation:
        name, _, rest = (x.strip() for x in organisation.partition(", http"))
        url = f"http{rest}" if rest else "#organisation"
        where = _add(crate, url, "Organization", name=name)
        if rest:
            where["url"] = url
        for person in people:
            person["affiliation"] = where
    return people


def _program(crate: ROCrate, history: History) -> Entity:
    has = history.attributes
    version = str(has["program_version"])
    libraries = ", ".join(
        str(has[part])
        for part in ("compiler", "embree_version", "hdf5_version", "isa")
        if part in has
    )
    return _add(
        crate,
        f"#ideotype-{version}",
        "SoftwareApplication",
        name="ideotype",
        version=version,
        softwareVersion=version,
        description=f"Commit {has.get('git_sha', 'unknown')}; {libraries}.",
        license={"@id": "https://spdx.org/licenses/Apache-2.0"},
    )


def _inputs(
    crate: ROCrate, history: History, folder: Path
) -> Iterator[Entity]:
    """Writes the inputs of a history and adds their files to the crate."""
    campaign = str(history.attributes["campaign"])
    texts = {
        "": (history.campaign(), "The campaign as its author wrote it."),
        "_resolved": (
            history.campaign("resolved"),
            "The campaign with every default, crop and weather.",
        ),
    }
    if crop := history.resolved.get("plant", {}).get("baseline"):
        description = "The crop and the baseline plant of the search."
        texts["_crop"] = tomli_w.dumps(crop), description
    if weather := history.resolved.get("weather"):
        description = "The weather in the time steps of evaluations."
        texts["_weather"] = tomli_w.dumps({"weather": weather}), description
    for part, (text, about) in texts.items():
        # Campaigns with equal names may differ in content.
        digest = hashlib.sha256(text.encode()).hexdigest()[:8]
        name = f"{file_name(campaign)}{part}_{digest}.toml"
        write_file(path := folder / _INPUTS / name, text, folder)
        yield _file(crate, path, folder, _TOML, f"{campaign}{part}", about)


def _search(
    crate: ROCrate,
    case: Case,
    history: History,
    folder: Path,
    people: Sequence[Entity],
) -> Entity:
    """Adds a history with its inputs and provenance to the crate."""
    about = f"All evaluations of one search of the case {case.name}."
    if pair := history.comparison():
        gain = pair.gain
        about += (
            f" Gain of the best plant in {pair.best.row.goals[0].name}: "
            f"{gain.mean:.4g} % (95 % interval of its light: "
            f"{NORMAL * gain.standard_error:.2g})."
        )
    name = str(history.attributes["case"])
    result = _file(
        crate, history.path, folder, "application/x-hdf5", name, about
    )
    sessions = history.sessions()
    return _add(
        crate,
        f"#search-{result.id}",
        "CreateAction",
        name=f"Search {name}",
        description="; then ".join(s.command for s in sessions),
        instrument=_program(crate, history),
        object=list(_inputs(crate, history, folder)),
        result=result,
        agent=list(people),
        startTime=sessions[0].started,
        actionStatus="http://schema.org/CompletedActionStatus",
    )


def _require_inside(path: Path, folder: Path) -> None:
    if folder.resolve() not in path.resolve().parents:
        raise HistoryError(
            f"{path}: this file is not in {folder}; move it there, or name "
            "another folder"
        )


def _file(
    crate: ROCrate, path: Path, folder: Path, kind: str, name: str, about: str
) -> Entity:
    with path.open("rb") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
    return crate.add_file(
        dest_path=path.resolve().relative_to(folder.resolve()),
        properties={
            "name": name,
            "description": about,
            "encodingFormat": kind,
            "contentSize": str(path.stat().st_size),
            "sha256": digest,
        },
    )
