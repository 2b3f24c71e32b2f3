# SPDX-License-Identifier: Apache-2.0
"""The JSON Schema of campaigns and the program accept and refuse the same
files.

IDEOTYPE_WRITE_GOLDEN=1 rewrites the schema of the package after a change of
keys."""

from __future__ import annotations

import datetime
import json
import os
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import h5py
import pytest
from jsonschema import Draft202012Validator, ValidationError
from real_program import CAMPAIGNS, output_of
from schemas import validator

BROKEN = Path(__file__).parents[2] / "data" / "broken"
IN_PACKAGE = (
    Path(__file__).parents[3]
    / "analysis/src/ideotype/schemas/campaign.schema.json"
)
NO_TOML = {"midnight", "syntax", "unclosed"}
NO_WEATHER = (
    "cannot read weather/no_such.csv; give a path relative to this file"
)
BOTH = "there are both [[climate]] and [[day]]"
ONLY_CHECK_SEES = {
    # Weights that are all 0, counts of lists, and tables that require others.
    "prices.toml": {
        "climate.weights",
        "no site has a weight above 0; give one to each that counts",
        "objective.scenarios",
        "prices are given",
        "prices.electricity",
        "prices.water",
    },
    "electricity.toml": {"climate.emergence", "prices.electricity"},
    "climate_and_day.toml": {BOTH},
    "climates.toml": {
        BOTH,
        NO_WEATHER,
        'climate "none" has no file',
        "climate",
        "climate.name",
        "climate.to",
        "day.date",
        "day.end",
        'site "bondville" has a weather file',
    },
    "contradictions.toml": {
        "final.candidates",
        "optics.leaf_transmittance",
        "search.elites",
        "search.tournament",
        "site.utc_offset",
    },
    "dark.toml": {
        'day "0125" has no light at site "tromso"',
        'day "0807" has no light at site "ames"',
        'day "0807" has no light at site "tromso"',
        'day "1221" has no light at site "tromso"',
    },
    "joined_names.toml": {"site.name"},
    "many.toml": {
        "day.date",
        "day.end",
        "final.candidates",
        "optics.leaf_transmittance",
        "plant.bounds",
        "search.elites",
        "spacing.plant",
        "stop.wall_time",
    },
    "missing.toml": {"traits.free"},
    "names.toml": {"day.name", "traits.free"},
    "no_plant.toml": {"cannot read plants/two_leafs.toml"},
    "outside_bounds.toml": {"plant.bounds"},
    "photosynthesis.toml": {
        "objective.maximise",
        "photosynthesis.amax",
        "photosynthesis.vmax",
    },
    "plants/broken.toml": {
        "leaf.curvature",
        "leaf.insertion_height",
        "leaf.width",
    },
    "plants/two_leaves.toml": {"leaf.insertion_angle", "leaf.length"},
    "ranges.toml": {
        "day.date",
        "plant.bounds.length",
        "plant.bounds.width",
        "site.longitude",
        "stop.wall_time",
    },
    "search_keys.toml": {
        "search.keys",
        "search.keys does not say how optics.soil_albedo varies",
        "search.keys.values excludes search.keys.range",
        'search.keys: field.boundary is "isolate"',
        "search.keys: field.rows is a text",
        "search.keys: spacing.plant is 20 m",
        "search.keys: the range of field.plants is [1.5, 4.5]",
    },
    "sensitivity.toml": {
        "optics.leaf_reflectance",
        "sensitivity.keys",
        "sensitivity.levels",
    },
    "soil.toml": {
        'climate "2011" has no rain',
        "irrigation.amounts",
        "soil",
        "soil.readily_evaporable",
        "soil.wilting_point",
    },
    "times.toml": {"day.date", "day.start", "day.step_minutes"},
    "types.toml": {"day.date", "day.end", "stop.wall_time"},
}
"""Faults of values against each other, of dates, times and texts of a form, of
other files, and of names that the rest of a file determines."""


def plain(value: Any) -> Any:
    """Returns TOML data as JSON data: dates and times become texts."""
    if isinstance(value, dict):
        return {key: plain(each) for key, each in value.items()}
    if isinstance(value, list):
        return [plain(each) for each in value]
    if isinstance(value, datetime.date | datetime.time):
        return value.isoformat()
    return value


def read(path: Path) -> dict[str, Any]:
    document: dict[str, Any] = plain(tomllib.loads(path.read_text()))
    return document


@pytest.fixture(scope="module")
def campaigns() -> Draft202012Validator:
    """Provides a validator of campaigns, by the schema that the program
    prints."""
    schema = json.loads(output_of("schema"))
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema)


@pytest.fixture(scope="module")
def crops(campaigns: Draft202012Validator) -> Draft202012Validator:
    """Provides a validator of crop files."""
    crop = {"$ref": "#/$defs/crop", "$defs": campaigns.schema["$defs"]}
    return campaigns.evolve(schema=crop)


def test_the_package_ships_the_schema_of_the_program() -> None:
    printed = output_of("schema")
    if "IDEOTYPE_WRITE_GOLDEN" in os.environ:
        IN_PACKAGE.write_text(printed)
    assert IN_PACKAGE.read_text() == printed, "see the head of this test"
    assert validator("campaign").schema == json.loads(printed)


def tables_in(schema: object) -> Iterator[dict[str, Any]]:
    """Yields the schemas of all tables within a schema."""
    if isinstance(schema, dict):
        if "properties" in schema and "type" in schema:
            yield schema["properties"]
        schema = list(schema.values())
    if isinstance(schema, list):
        for each in schema:
            yield from tables_in(each)


def test_the_schema_defines_each_table_once(
    campaigns: Draft202012Validator,
) -> None:
    texts = [json.dumps(x) for x in tables_in(campaigns.schema)]
    assert len(texts) > 20
    assert len({*texts}) == len(texts)
    of_leaves = {"$ref": "#/$defs/photosynthesis"}
    properties = campaigns.schema["properties"]
    assert properties["photosynthesis"] == of_leaves
    inside = properties["component"]["properties"]
    assert inside["photosynthesis"] == of_leaves


def test_both_forms_of_a_list_have_the_same_problems(
    campaigns: Draft202012Validator,
) -> None:
    document = read(CAMPAIGNS / "alley.toml")
    material = {"groups": "crown", "par": [0.1, 0.1]}
    for wrong in (material, {**material, "pr": 0}, [[material]]):
        (component,) = document["component"]
        is_fine = wrong == material
        for form in (wrong, [wrong]):
            component["material"] = form
            for both in (component, [component], [[component]]):
                document["component"] = both
                assert campaigns.is_valid(document) == (
                    is_fine and both != [[component]]
                )
        document["component"] = [component]


def test_shipped_campaigns_are_valid(campaigns: Draft202012Validator) -> None:
    checked = 0
    for path in CAMPAIGNS.rglob("*.toml"):
        document = read(path)
        if "site" in document:
            campaigns.validate(document)
            checked += 1
    assert checked >= 20


def test_shipped_crops_are_valid(crops: Draft202012Validator) -> None:
    files = [*CAMPAIGNS.glob("crops/*.toml"), *CAMPAIGNS.glob("plants/*.toml")]
    assert len(files) >= 10
    for path in files:
        crops.validate(read(path))


def test_resolved_campaigns_are_valid(
    campaigns: Draft202012Validator, tiny_run: Path
) -> None:
    with h5py.File(tiny_run) as file:
        resolved = file["campaign/resolved"].asstr()[()]
    campaigns.validate(plain(tomllib.loads(resolved)))


def test_new_campaigns_name_the_schema(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    place = ["--latitude", 42, "--longitude", -93.6, "--date", "2021-07-01"]
    field = ["--row", 0.76, "--plant-spacing", 0.15, "--plant", "maize"]
    output = output_of("new", path, *place, *field)
    # Editors find the schema by a directive in the first line of the campaign.
    directive, name = path.read_text().splitlines()[0].split()
    assert directive == "#:schema"
    assert str(tmp_path / name) in output.splitlines()
    schema = json.loads((tmp_path / name).read_text())
    document = read(path)
    Draft202012Validator(schema).validate(document)
    document["site"][0]["latitud"] = 42
    assert not Draft202012Validator(schema).is_valid(document)


def faults(error: ValidationError) -> Iterator[ValidationError]:
    """Yields the errors in the parts of a value, if one of the permitted forms
    has these parts; else the error of the value."""
    inside = [each for each in error.context if each.relative_path]
    for each in inside:
        yield from faults(each)
    if not inside:
        yield error


def seen_by(
    checked: Draft202012Validator, document: object
) -> tuple[set[str], set[str]]:
    """Returns the keys concerned by errors of the schema, with the names that
    the program prints; and those keys among them that are missing in a table
    with unknown keys."""
    errors = [
        fault
        for error in checked.iter_errors(document)
        for fault in faults(error)
    ]
    unknown = "additionalProperties"
    tables = [x.absolute_path for x in errors if x.validator == unknown]
    known, misspelt = set(), set()
    for error in errors:
        path = [x for x in error.absolute_path if isinstance(x, str)]
        keys: set[str] = set()
        if error.validator == unknown:
            keys = error.instance.keys() - error.schema["properties"].keys()
        elif error.validator == "required":
            keys = set(error.validator_value) - error.instance.keys()
        names = {".".join([*path, key]) for key in keys} or {".".join(path)}
        known |= names
        if error.validator == "required" and error.absolute_path in tables:
            misspelt |= names
    return known, misspelt


def named(messages: str, file: str) -> set[str]:
    """Returns the keys of a file that are named in messages of the program."""
    keys = set()
    for line in messages.splitlines():
        if not line.startswith(f"{file}:"):
            continue
        problem = line.split(": ", 1)[1]
        if lacking := re.match(
            r"(?:unknown|missing) (?:key|table) '(\w+)' (?:in|at) "
            r"(?:\[+([\w.]+)\]|the top)",
            problem,
        ):
            key, table = lacking.groups()
            keys.add(f"{table}.{key}" if table else key)
        elif lacking := re.match(r"missing table \[([\w.]+)\]", problem):
            keys.add(lacking[1])
        elif about := re.match(
            r"([a-z_.]+) (?:is|has|exclude|of leaf) ", problem
        ):
            keys.add(about[1])
        else:
            keys.add(problem.split(" (")[0])
    return keys


BROKEN_FILES = sorted(
    path.relative_to(BROKEN).as_posix() for path in BROKEN.rglob("*.toml")
)


@pytest.mark.parametrize("file", BROKEN_FILES)
def test_schema_and_program_find_the_same_problems(
    file: str, campaigns: Draft202012Validator, crops: Draft202012Validator
) -> None:
    if Path(file).stem in NO_TOML:
        with pytest.raises(tomllib.TOMLDecodeError):
            read(BROKEN / file)
        return
    checked = crops if file.startswith("plants/") else campaigns
    messages = "".join(x.read_text() for x in sorted(BROKEN.glob("*.txt")))
    expected = named(messages, file)
    seen, misspelt = seen_by(checked, read(BROKEN / file))
    # For a misspelt key, the program does not report the similar key as
    # missing.
    assert seen - expected <= misspelt
    assert expected - seen == ONLY_CHECK_SEES.get(file, set())
