# SPDX-License-Identifier: Apache-2.0
"""Reads files of facts: measurements with their conditions and sources."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from importlib.resources import files
from pathlib import Path
from typing import Any

from ..common.arrays import require_file
from ..errors import Error, did_you_mean
from .table import Measurement, measurements_from_rows, read_table


class Read(StrEnum):
    """The part of a source from which values were taken."""

    data = "data"
    text = "text"
    abstract = "abstract"


class Verdict(StrEnum):
    """Whether the program agrees with a fact."""

    passes = "passes"
    misses = "misses"
    none = "cannot be compared"


@dataclass(frozen=True)
class Source:
    """The origin of measurements."""

    name: str
    citation: str
    """The publication with its DOI or address."""
    read: Read


@dataclass(frozen=True)
class Intervention:
    """A change of the plant or its stand that might close a miss."""

    name: str
    keys: Mapping[str, Any]
    sources: str
    """Whether sources allow the change."""


@dataclass(frozen=True)
class Fact:
    """Measurements that answer one question in one experiment."""

    name: str
    question: str
    source: Source
    campaign: Path
    keys: Mapping[str, Any]
    """The keys of the campaign that the experiment sets."""
    than: Mapping[str, Any] | None
    """The keys of the control, if values are changes from a control, in the
    unit "1" or "%"."""
    measurements: list[Measurement]
    axis: str
    """The column for the horizontal axis of the figure."""
    is_assumption: bool
    """Whether the values are assumptions of a model, not measurements."""
    cannot: str
    """The reason why it cannot be compared, or ""."""
    note: str
    verdict: Verdict | None
    """The verdict that the file records."""
    interventions: list[Intervention] = field(default_factory=list)


@dataclass(frozen=True)
class Facts:
    """The facts of a file."""

    path: Path
    facts: list[Fact]

    def named(self, names: list[str]) -> list[Fact]:
        """Returns the facts with the given names, by default all. Raises Error
        for unknown names."""
        known = {fact.name: fact for fact in self.facts}
        for name in names:
            if name not in known:
                raise Error(
                    f"{self.path} has no fact '{name}'"
                    + (
                        did_you_mean(name, list(known))
                        or "; it has " + ", ".join(known)
                    )
                )
        return [known[name] for name in names] if names else self.facts


def shipped_facts() -> Path:
    """Returns the path of the facts that come with the program."""
    return Path(str(files(__package__) / "facts" / "facts.toml"))


FACT = {
    "name", "question", "source", "campaign", "set", "than", "axis", "table",
    "measured", "cannot", "note", "verdict", "intervention",
}  # fmt: skip
SOURCE = {"citation", "read"}
INTERVENTION = {"name", "set", "sources"}


class _Reader:
    """Reads a file and collects its problems."""

    def __init__(self, path: Path) -> None:
        require_file(path)
        self.path = path
        self.problems: list[str] = []
        try:
            text = path.read_text(encoding="utf-8")
            self.tables = tomllib.loads(text)
        except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
            raise Error(f"{path}: {error}") from None
        self.lines = text.splitlines()
        self.sources: dict[str, Source] = {}

    def line(self, header: str, number: int = 0) -> str:
        """Returns the path and line of the table `number` with this header,
        such as [[fact]]."""
        lines = [
            i
            for i, text in enumerate(self.lines, 1)
            if text.split("#")[0].strip() == header
        ]
        return f"{self.path}:{lines[number] if number < len(lines) else 1}"

    def check_names(
        self, table: Mapping[str, Any], known: set[str], where: str
    ) -> None:
        """Records the unknown keys of a table as problems."""
        for name in table:
            if name not in known:
                self.problems.append(
                    f"{where}: there is no key '{name}'"
                    + (
                        did_you_mean(name, sorted(known))
                        or "; use " + ", ".join(sorted(known))
                    )
                )

    def text(
        self, table: Mapping[str, Any], key: str, where: str, other: str = ""
    ) -> str:
        """Returns the text of a key; records a problem if it is missing and
        there is no default, `other`."""
        value = table.get(key, other)
        if not isinstance(value, str) or (key not in table and not other):
            self.problems.append(f'{where}: give {key} = "..."')
            return ""
        return value

    def choice(self, kind: Any, value: str, key: str, where: str) -> Any:
        try:
            return kind(value)
        except ValueError:
            self.problems.append(
                f"{where}: {key} is '{value}'; use one of "
                + ", ".join(f'"{value}"' for value in kind)
            )
            return None

    def keys(
        self, table: Mapping[str, Any], key: str, where: str
    ) -> dict[str, Any]:
        value = table.get(key, {})
        if isinstance(value, dict):
            return dict(value)
        self.problems.append(
            f'{where}: {key} is {value!r}; write {{"spacing.density" = 7.5}}'
        )
        return {}

    def read_sources(self) -> None:
        for name, table in self.tables.get("source", {}).items():
            where = self.line(f"[source.{name}]")
            self.check_names(table, SOURCE, where)
            read = self.choice(
                Read, self.text(table, "read", where), "read", where
            )
            citation = self.text(table, "citation", where)
            self.sources[name] = Source(name, citation, read or Read.abstract)

    def facts(self, kind: str) -> Iterator[Fact]:
        for number, table in enumerate(self.tables.get(kind, [])):
            yield self.fact(table, kind, self.line(f"[[{kind}]]", number))

    def fact(self, table: dict[str, Any], kind: str, where: str) -> Fact:
        self.check_names(table, FACT, where)
        name = self.text(table, "name", where)
        if name and not re.fullmatch(r"[a-z0-9_]+", name):
            self.problems.append(
                f"{where}: name is '{name}'; use a-z, 0-9 and _, since files "
                "have this name"
            )
        source = self.text(table, "source", where)
        if source and source not in self.sources:
            self.problems.append(
                f"{where}: there is no [source.{source}]"
                + did_you_mean(source, list(self.sources))
            )
        cannot = self.text(table, "cannot", where, " ").strip()
        campaign = self.text(table, "campaign", where, "-" if cannot else "")
        return Fact(
            name,
            self.text(table, "question", where),
            self.sources.get(source, Source(source, "", Read.abstract)),
            self.path.parent / campaign,
            self.keys(table, "set", where),
            self.keys(table, "than", where) if "than" in table else None,
            self.measurements(table, where),
            self.text(table, "axis", where, "quantity"),
            kind == "assumption",
            cannot,
            self.text(table, "note", where, " ").strip(),
            self.choice(Verdict, table["verdict"], "verdict", where)
            if "verdict" in table
            else None,
            [
                self.intervention(change, where)
                for change in table.get("intervention", [])
            ],
        )

    def intervention(self, table: dict[str, Any], where: str) -> Intervention:
        self.check_names(table, INTERVENTION, where)
        return Intervention(
            self.text(table, "name", where),
            self.keys(table, "set", where),
            self.text(table, "sources", where),
        )

    def measurements(
        self, table: Mapping[str, Any], where: str
    ) -> list[Measurement]:
        rows = []
        try:
            if "table" in table:
                rows += read_table(self.path.parent / str(table["table"]))
            rows += measurements_from_rows(table.get("measured", []), where)
        except Error as error:
            self.problems.append(str(error))
        return rows


def read_facts(path: Path) -> Facts:
    """Reads a file of facts; docs/validation.md describes the format.

    Raises Error with all problems of the file and the lines of their
    tables."""
    reader = _Reader(path)
    unknown = set(reader.tables) - {"source", "fact", "assumption"}
    for name in sorted(unknown):
        reader.problems.append(
            f"{path}: there is no table '{name}'; use [source.NAME], "
            "[[fact]] and [[assumption]]"
        )
    reader.read_sources()
    facts = [*reader.facts("fact"), *reader.facts("assumption")]
    names = [fact.name for fact in facts]
    for name in sorted({name for name in names if names.count(name) > 1}):
        reader.problems.append(
            f"{path}: two facts are named '{name}'; rename one"
        )
    if reader.problems:
        raise Error("\n".join(reader.problems))
    return Facts(path, facts)


def facts_from_table(table: Path, campaign: Path) -> Facts:
    """Returns the measurements of a CSV table as facts about a campaign, one
    for each quantity."""
    rows = read_table(table)
    source = Source("table", str(table), Read.data)
    facts = []
    for quantity in dict.fromkeys(row.quantity for row in rows):
        chosen = [row for row in rows if row.quantity == quantity]
        axes = ("date", "hours", "height", "leaves")
        varied = (x for x in axes if len({getattr(r, x) for r in chosen}) > 1)
        facts.append(
            Fact(
                quantity, quantity, source, campaign, {}, None, chosen,
                next(varied, "quantity"), False, "", "", None,
            )
        )  # fmt: skip
    return Facts(table, facts)
