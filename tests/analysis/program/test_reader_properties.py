# SPDX-License-Identifier: Apache-2.0
"""For a file of any content, its reader returns this content or raises one
error that names the file; hypothesis generates the files."""

from __future__ import annotations

import functools
import json
import re
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from made_weather import DATA as WEATHER
from real_program import CAMPAIGNS, SAMPLE

import ideotype
from ideotype import Error, InputError, _core
from ideotype.history import HistoryError
from ideotype.stand.measured.leaf_tables import measured_crops
from ideotype.tools import weather as converter

FUZZ = Path(__file__).parents[2] / "fuzz"
SMALL = (FUZZ / "campaigns/small.toml").read_text()
SCHEMA = json.loads(
    (
        Path(ideotype.__file__).parent / "schemas/campaign.schema.json"
    ).read_text()
)

JUNK = (
    *(
        "-1",
        "nan",
        "1e999",
        "\n",
        ",",
        "[",
        '"',
        "=",
        "#",
        "\0",
        "é",
        "\ufeff",
    ),
    *("9" * 30, "2025-02-30", "f ", "v ", "24:00"),
)
"""Texts that are likely to hurt."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("readers")


@st.composite
def spoilt(draw: st.DrawFn, texts: list[str]) -> str:
    """Draws one of the texts, with some parts replaced by random text or by
    parts of another of the texts."""
    text = draw(st.sampled_from(texts))
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(text)))
        length = draw(st.integers(0, 40))
        other = draw(st.sampled_from(texts))
        begin = draw(st.integers(0, len(other)))
        new = draw(
            st.one_of(
                st.just(""),
                st.sampled_from(JUNK),
                st.just(other[begin : begin + 60]),
                st.text(max_size=4),
            )
        )
        text = text[:at] + new + text[at + length :]
    return text


OTHERS = {("light", "dates"), ("light", "stages"), ("spacing", "density")}
"""Keys that resolved campaigns of days and of plant distances leave out."""


def numeric_keys() -> dict[tuple[str, str], dict[str, Any]]:
    """Returns the schemas of keys that are single numbers with limits, by
    table and key, for the tables that every campaign may contain."""
    tables = (
        *("site", "spacing", "field", "plant", "optics", "light", "search"),
        *("constraints", "stop", "final", "day"),
    )
    return {
        (table, key): schema
        for table in tables
        for key, schema in SCHEMA["properties"][table]["properties"].items()
        if schema.get("type") in ("number", "integer")
        and "maximum" in schema
        and (table, key) not in OTHERS
    }


KEYS = numeric_keys()


@st.composite
def changed_keys(draw: st.DrawFn) -> dict[tuple[str, str], float]:
    """Draws keys with values inside their range, at its ends, or close to its
    ends."""
    chosen = draw(
        st.lists(
            st.sampled_from(sorted(KEYS)), min_size=1, max_size=3, unique=True
        )
    )
    values = {}
    for name in chosen:
        low, high = KEYS[name]["minimum"], KEYS[name]["maximum"]
        if KEYS[name]["type"] == "integer":
            low, high = int(low), int(high)
            inside = st.integers(low, min(high, low + 1000))
            near = st.sampled_from([low - 1, low, high, high + 1])
        else:
            inside = st.floats(low, high)
            near = st.sampled_from(
                [np.nextafter(low, -np.inf), low, high, high * 1.001 + 1]
            )
        values[name] = draw(st.one_of(inside, inside, near))
    return values


def test_the_schema_has_numeric_keys_to_vary() -> None:
    assert len(KEYS) > 30


@given(changed_keys())
def test_resolved_campaigns_keep_each_number(
    changed: dict[tuple[str, str], float],
) -> None:
    tables = tomllib.loads(SMALL)
    for (table, key), value in changed.items():
        place = tables.setdefault(table, {})
        (place[0] if isinstance(place, list) else place)[key] = value
    outside = {
        f"{table}.{key}"
        for (table, key), value in changed.items()
        if not KEYS[table, key]["minimum"]
        <= value
        <= KEYS[table, key]["maximum"]
    }
    try:
        resolved = ideotype.Stand(tables).campaign
    except InputError as error:
        assert outside <= {each.key for each in error.problems}
        assert all(each.line > 0 and each.what for each in error.problems)
        return
    assert not outside
    again = _core.CaseStand.from_text(resolved, "again.toml", 0, [], "")
    assert again.resolved == resolved
    read = tomllib.loads(resolved)
    for (table, key), value in changed.items():
        place = read.get(table, {})
        kept = (place[0] if isinstance(place, list) else place).get(key)
        if kept is None:
            # A key may be omitted from the resolved campaign only if it has
            # its default, which the schema states.
            assert f"; default: {value:g}" in KEYS[table, key]["description"]
        else:
            assert kept == value, f"{table}.{key}"


@given(spoilt([SMALL]))
def test_the_error_for_a_spoilt_campaign_names_the_file(text: str) -> None:
    try:
        _core.CaseStand.from_text(text, "spoilt.toml", 0, [], "")
    except Error as error:
        assert "spoilt.toml" in str(error)


@st.composite
def rectangles(draw: st.DrawFn) -> tuple[str, np.ndarray, float]:
    """Draws an OBJ file of rectangles and triangles, written in any permitted
    form, its vertices [m], and the one-sided area of its faces [m2]."""
    size = st.floats(0.01, 1)
    lines, vertices, area = ["# made"], [], 0.0
    for _ in range(draw(st.integers(1, 5))):
        corner = np.array([draw(size) for _ in range(3)])
        width, height = draw(size), draw(size)
        turn = draw(st.floats(0, 2 * np.pi))
        along = width * np.array([np.cos(turn), np.sin(turn), 0])
        up = height * np.array([0, 0, 1.0])
        corners = [corner, corner + along, corner + along + up, corner + up]
        count = draw(st.sampled_from([3, 4]))
        first = len(vertices)
        vertices += corners[:count]
        area += width * height * (1 if count == 4 else 0.5)
        lines += [
            "v " + " ".join(map(repr, x.tolist())) for x in corners[:count]
        ]
        places = range(first, first + count)
        if draw(st.booleans()):  # indices from the last vertex backwards
            words = [str(i - len(vertices)) for i in places]
        else:
            words = [str(i + 1) for i in places]
        lines += ["vn 0 0 1"] if draw(st.booleans()) else []
        lines += [draw(st.sampled_from(["g leaf", "o part", "", "# -"]))]
        lines += ["f " + draw(st.sampled_from([" ", "  "])).join(words)]
    end = draw(st.sampled_from(["\n", "\r\n"]))
    return end.join(lines) + end, np.array(vertices), area


def with_object(folder: Path, text: str) -> str:
    """Returns the resolved campaign with an object of an OBJ file."""
    (folder / "object.obj").write_text(text, newline="", errors="replace")
    tables = tomllib.loads(SMALL)
    tables["object"] = [{"name": "wall", "obj": "object.obj"}]
    return ideotype.Stand(tables, folder=folder).campaign


@given(rectangles())
def test_objects_have_the_surfaces_of_their_file(
    folder: Path, drawn: tuple[str, np.ndarray, float]
) -> None:
    text, vertices, area = drawn
    (read,) = tomllib.loads(with_object(folder, text))["object"]
    corners = np.reshape(read["vertices"], (-1, 3))
    faces = corners[np.reshape(read["faces"], (-1, 4))]
    sides = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1])
    assert np.linalg.norm(sides, axis=1).sum() / 2 == pytest.approx(area)
    # The decimals of the reader may differ in the last digit.
    used = np.unique(corners.round(12), axis=0)
    assert used == pytest.approx(np.unique(vertices.round(12), axis=0))


@given(
    spoilt([path.read_text() for path in sorted(FUZZ.glob("meshes/*.obj"))])
)
def test_the_error_for_a_spoilt_object_names_the_file(
    folder: Path, text: str
) -> None:
    try:
        with_object(folder, text)
    except Error as error:
        # Invalid sizes of objects are reported as problems of the campaign.
        assert "object" in str(error)


WEEK = (WEATHER / "converted.csv").read_text().splitlines()
"""A table of weather: two lines about it, names of columns, rows."""
CLIMATE = """\
[[climate]]
name = "days"
file = "weather.csv"
from = 1981-07-02
to = 1981-07-03
"""


def with_weather(
    folder: Path, lines: list[str], columns: str = ""
) -> dict[str, Any]:
    """Returns the weather that a campaign reads from a table."""
    (folder / "weather.csv").write_text("\n".join(lines) + "\n", newline="")
    tables = tomllib.loads(SMALL)
    del tables["day"]
    tables["site"][0] |= {"latitude": 36.1, "longitude": -79.95}
    tables |= tomllib.loads(CLIMATE + columns)
    stand = ideotype.Stand(tables, folder=folder)
    again = _core.CaseStand.from_text(stand.campaign, "a.toml", 0, [], "")
    assert again.resolved == stand.campaign
    (read,) = tomllib.loads(stand.campaign)["weather"]
    return read


@given(
    st.lists(st.floats(0.6, 1), min_size=24, max_size=24),
    st.floats(-30, 45),
    st.floats(0, 100),
    st.sampled_from([1, 60, 300, -330]),
)
def test_weather_is_independent_of_clock_and_units(
    folder: Path,
    clearness: list[float],
    temperature: float,
    humidity: float,
    shift: int,
) -> None:
    ours, theirs = list(WEEK[:2]), []
    ours.append("time,global,diffuse,temperature,humidity")
    theirs.append("time,light,sky,kelvin,rh")
    expected = []
    for i, line in enumerate(WEEK[3:]):
        time, ghi, _, dhi, *_ = line.split(",")
        part = clearness[i % 24]
        light, sky = float(ghi) * part, float(dhi) * part
        expected.append((time, light))
        ours.append(f"{time},{light!r},{sky!r},{temperature!r},{humidity!r}")
        later = np.datetime64(time[:19]) + np.timedelta64(shift, "m")
        hours, minutes = divmod(abs(shift - 300), 60)
        sign = "+" if shift >= 300 else "-"
        theirs.append(
            f"{later}{sign}{hours:02d}:{minutes:02d},{light * 3600 / 1e6!r},"
            f"{sky * 3600 / 1e6!r},{temperature + 273.15!r},{humidity / 100!r}"
        )
    read = with_weather(folder, ours)
    units = (
        'time = ["time"]\nstamp = "middle"\nglobal = ["light", "MJ/m2"]\n'
        'diffuse = ["sky", "MJ/m2"]\ntemperature = ["kelvin", "K"]\n'
        'humidity = ["rh", "1"]\n'
    )
    other = by_instant(with_weather(folder, theirs, units))
    rows = by_instant(read)
    shared = sorted(rows.keys() & other.keys())
    assert len(shared) >= 37
    assert [other[x] for x in shared] == [
        pytest.approx(rows[x], abs=1e-9) for x in shared
    ]
    assert read["temperature"] == pytest.approx(48 * [temperature])
    light = [x for time, x in expected if "1981-07-02" <= time < "1981-07-04"]
    total = np.add(read["beam"], read["diffuse"])
    assert total == pytest.approx(0.45 * np.array(light), abs=1e-9)


def by_instant(read: dict[str, Any]) -> dict[float, list[float]]:
    """Returns light, temperature and humidity by the hour in UTC."""
    names = ("beam", "diffuse", "temperature", "humidity")
    rows = zip(*(read[name] for name in names))
    hours = [
        24 * date.toordinal() + hour - read["utc_offset"]
        for date in read["dates"]
        for hour in read["hours"]
    ]
    return {hour: list(row) for hour, row in zip(hours, rows, strict=True)}


@given(spoilt(["\n".join(WEEK)]))
def test_the_error_for_spoilt_weather_names_the_file(
    folder: Path, text: str
) -> None:
    try:
        with_weather(folder, [text])
    except Error as error:
        assert "weather.csv" in str(error)


LEAF = {
    "length": (0.1, 1.0),
    "width": (0.01, 0.09),
    "insertion_angle": (0.0, 90.0),
    "curvature": (0.0, 90.0),
    "azimuth": (0.0, 359.0),
}
"""Measures of leaves with values that every leaf may have [m, deg]."""
PER_METRE = {"_m": 1, "_cm": 100, "_mm": 1000}


@st.composite
def leaf_tables(draw: st.DrawFn) -> tuple[str, list[dict[str, float]]]:
    """Draws a table of measured leaves, with columns, lines and units in any
    permitted form, and its leaves, lowest first."""
    leaves, height = [], 0.0
    for _ in range(draw(st.integers(1, 8))):
        leaf = {name: draw(st.floats(*x)) for name, x in LEAF.items()}
        height += draw(st.floats(0.05, 0.3))
        leaves.append(leaf | {"insertion_height": height})
    columns = {}
    for name in leaves[0]:
        if name in ("length", "width", "insertion_height"):
            end = draw(st.sampled_from(sorted(PER_METRE)))
            columns[name] = (name + end, PER_METRE[end], 0.0)
        elif name == "insertion_angle" and draw(st.booleans()):
            columns[name] = (f"{name}_from_horizontal_deg", -1, 90.0)
        else:
            columns[name] = (f"{name}_deg", 1, 0.0)
    order = draw(st.permutations([*columns, "leaf"]))
    names = [columns[x][0] if x in columns else x for x in order]
    lines = [",".join(names)]
    for i in draw(st.permutations(range(len(leaves)))):
        entries = []
        for name in order:
            if name == "leaf":
                entries.append(str(i + 1))
            else:
                _, per_unit, zero = columns[name]
                entries.append(repr(zero + per_unit * leaves[i][name]))
        lines.append(",".join(entries))
        lines += draw(st.sampled_from([[], [""], ["# a remark"]]))
    return "\n".join(lines), leaves


def read_crops(folder: Path, text: str) -> list[dict[str, Any]]:
    table = folder / "leaves.csv"
    table.write_text(text, newline="", errors="replace")
    return [each.tables for each in measured_crops(table, "maize")]


@given(leaf_tables())
def test_crops_have_the_leaves_of_their_table(
    folder: Path, drawn: tuple[str, list[dict[str, float]]]
) -> None:
    text, leaves = drawn
    (crop,) = read_crops(folder, text)
    assert len(crop["leaf"]) == len(leaves)
    for read, leaf in zip(crop["leaf"], leaves, strict=True):
        for name, value in leaf.items():
            assert read[name] == pytest.approx(value, abs=1e-9), name


LEAF_TABLES = [
    path.read_text() for path in sorted(CAMPAIGNS.glob("plants/*.csv"))
]


@given(spoilt(LEAF_TABLES))
def test_problems_of_a_spoilt_leaf_table_have_their_lines(
    folder: Path, text: str
) -> None:
    lines = len(re.split("\r\n|\r|\n", text))
    try:
        read_crops(folder, text)
    except InputError as error:
        assert error.problems
        for each in error.problems:
            assert each.file.endswith(".csv") and each.what
            assert 1 <= each.line <= lines
    except Error as error:
        assert "leaves.csv" in str(error)


WEATHER_FILES = [
    WEATHER / name
    for name in ("nsrdb.csv", "power_utc.csv", "small.epw", "tmy3.csv")
]


NSRDB = (WEATHER / "nsrdb.csv").read_text().splitlines()


def changed(name: str, old: str, new: str) -> tuple[Path, str]:
    text = (WEATHER / name).read_text()
    assert old in text
    return WEATHER / name, text.replace(old, new, 1)


@example(changed("small.epw", "1981,7,1,1,60,", "1981,7,1,1,x,"))
@example(changed("small.epw", ",36.1,", ",-89,"))
@example((WEATHER / "nsrdb.csv", "\n".join(NSRDB[:4])))
@given(
    st.sampled_from(WEATHER_FILES).flatmap(
        lambda path: st.tuples(st.just(path), spoilt([path.read_text()]))
    )
)
@settings(max_examples=settings.default.max_examples // 5)
def test_spoilt_weather_files_are_converted_or_refused(
    folder: Path, drawn: tuple[Path, str]
) -> None:
    path, text = drawn
    file = folder / path.name
    file.write_text(text, newline="", errors="replace")
    to = folder / "converted.csv"
    to.unlink(missing_ok=True)
    words = [str(file), "--to", str(to), "--fill", "2"]
    assert converter.main(words) in (0, 3)


@st.composite
def damages(draw: st.DrawFn) -> bytes:
    """Draws a history that is truncated or contains wrong bytes."""
    content = SAMPLE.read_bytes()
    # The headers at the beginning are tested more often, because most faults
    # are possible there.
    near = st.integers(0, 30_000)
    at = draw(st.one_of(near, near, st.integers(0, len(content) - 1)))
    if draw(st.integers(0, 9)) == 0:
        return content[:at]
    new = draw(st.binary(min_size=1, max_size=8))
    return content[:at] + new + content[at + len(new) :]


@given(damages())
def test_damaged_histories_are_refused_or_read_as_before(
    folder: Path, content: bytes
) -> None:
    path = folder / "damaged.h5"
    path.write_bytes(content)
    try:
        arrays = ideotype.open(path)
    except HistoryError as error:
        assert "damaged.h5" in str(error)
    else:
        assert arrays.identical(whole_sample())


@functools.cache
def whole_sample() -> Any:
    return ideotype.open(SAMPLE)
