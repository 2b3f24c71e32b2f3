# SPDX-License-Identifier: Apache-2.0
"""Live pages as a program sees them: who may ask, what is opened, and whether
the numbers are right. test_play.py looks at them in a browser."""

from __future__ import annotations

import asyncio
import http.client
import json
import tomllib
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from conftest import WriterProcess
from live_page import CAMPAIGNS, Served, Talk, served, talk_with
from tornado.httpclient import HTTPClientError, HTTPRequest
from tornado.websocket import websocket_connect

from ideotype import Error, Stand
from ideotype.live.conditions import tables_under
from ideotype.live.numbers import ENOUGH, Samples
from ideotype.live.opened import CROPS, open_place
from ideotype.live.play import main as play
from ideotype.live.runs import Folder
from ideotype.live.watch import main as watch

pytestmark = pytest.mark.long

DAY = str(CAMPAIGNS / "ames.toml")


@pytest.fixture(scope="module")
def page() -> Iterator[Served]:
    with served("play", DAY) as found:
        yield found


def answer(
    page: Served, path: str, method: str = "GET", **headers: str
) -> tuple[int, dict[str, str], str]:
    link = http.client.HTTPConnection("127.0.0.1", page.port, timeout=20)
    link.request(method, path, headers=headers)
    found = link.getresponse()
    text = found.read().decode()
    link.close()
    return found.status, dict(found.getheaders()), text


def token(page: Served) -> str:
    return page.address.rstrip("/").rpartition("/")[2]


def test_the_page_and_its_parts_are_there(page: Served) -> None:
    status, headers, text = answer(page, f"/{token(page)}/")
    assert status == 200 and "<title>ideotype play</title>" in text
    assert "default-src 'none'" in headers["Content-Security-Policy"]
    assert "http://" not in text.replace("http://www.w3.org", "")
    assert "https://" not in text
    for name in ("play.js", "play.css", "base.css", "raster.js", "chart.js"):
        status, _, text = answer(page, f"/{token(page)}/{name}")
        assert status == 200 and "SPDX-License-Identifier" in text


@pytest.mark.parametrize(
    "path",
    ["/", "/talk", "/wrong/", "/wrong/talk", "/wrong/play.js",
     "/wrong/save/crop", "//", "/%00/"],
)  # fmt: skip
def test_a_wrong_token_is_refused(page: Served, path: str) -> None:
    status, _, text = answer(page, path)
    assert status == 403
    assert token(page) not in text


def test_no_other_file_is_served(page: Served) -> None:
    for path in ("../server.py", "..%2fserver.py", "server.py", "x/y"):
        status, _, text = answer(page, f"/{token(page)}/{path}")
        assert status in (403, 404) and "import" not in text


def test_other_origins_are_refused(page: Served) -> None:
    path = f"/{token(page)}/"
    own = f"http://127.0.0.1:{page.port}"
    assert answer(page, path, Origin=own)[0] == 200
    for origin in (
        "http://evil.example",
        "null",
        f"{own}0",
        f"https{own[4:]}",
    ):
        assert answer(page, path, Origin=origin)[0] == 403
        save = answer(page, f"{path}save/crop", "POST", Origin=origin)
        assert save[0] == 403


def test_names_of_this_machine_that_are_not_local_are_refused(
    page: Served,
) -> None:
    path = f"/{token(page)}/"
    for host in ("localhost:9", "127.0.0.1:9", "[::1]:9"):
        assert answer(page, path, Host=host)[0] == 200
    for host in ("evil.example", "127.0.0.1.evil.example", ""):
        assert answer(page, path, Host=host)[0] == 403


@pytest.mark.parametrize("case", ["origin", "token"])
def test_talks_with_others_are_refused(page: Served, case: str) -> None:
    address = f"{page.address}talk".replace("http", "ws")
    headers = {"Origin": "http://evil.example"} if case == "origin" else {}
    if case == "token":
        address = address.replace(token(page), "x" * len(token(page)))

    async def knock() -> None:
        await websocket_connect(HTTPRequest(address, headers=headers))

    with pytest.raises(HTTPClientError, match="403"):
        asyncio.run(knock())


def test_only_this_machine_is_listened_to(page: Served) -> None:
    lines = Path("/proc/net/tcp").read_text().splitlines()[1:]
    listening = [line.split()[1] for line in lines if line.split()[3] == "0A"]
    port = f"{page.port:04X}"
    mine = [address for address in listening if address.endswith(f":{port}")]
    assert mine == [f"0100007F:{port}"]


def test_numbers_are_those_of_evaluations(page: Served) -> None:
    """Means over the seeds 1, 2, ... of single evaluations."""

    async def ask(talk: Talk) -> tuple[dict, dict, list]:
        genome = list(talk.hello["genome"])
        genome[0] *= 1.1
        talk.say(kind="show", number=1, genome=genome)
        first = await talk.hear("numbers")
        return first, await talk.final(1), genome

    first, last, genome = talk_with(page, ask)
    opened = open_place(DAY)
    tables = dict(opened.base)
    tables["light"] = tables["light"] | {"fields": 1, "randomisations": 8}
    stand = Stand(tables)
    count = last["evaluations"]
    found = [
        stand.evaluate(genome, ["absorbed_par"], tolerance=0.05, seed=seed)
        for seed in range(1, count + 1)
    ]
    values = np.array([each.absorbed_par.item() for each in found])
    assert first["numbers"]["absorbed_par"][0] == pytest.approx(
        values[0], rel=1e-6
    )
    mean, error = last["numbers"]["absorbed_par"]
    assert mean == pytest.approx(values.mean(), rel=1e-6)
    if count >= ENOUGH:
        expected = values.std(ddof=1) / np.sqrt(count)
        assert error == pytest.approx(expected, rel=1e-5)
    assert error < first["numbers"]["absorbed_par"][1]
    reference = last["reference"]["absorbed_par"][0]
    apart = last["differences"]["absorbed_par"][0]
    assert apart == pytest.approx(mean - reference, abs=1e-5)


def test_only_the_last_change_is_answered_in_full(page: Served) -> None:
    async def ask(talk: Talk) -> list[int]:
        genome = talk.hello["genome"]
        for number in range(1, 31):
            genome[0] = 0.5 + number / 100
            talk.say(kind="show", number=number, genome=genome)
        heard = []
        while True:
            told = await talk.hear("numbers")
            heard.append(told["number"])
            if told["number"] == 30 and told.get("is_final"):
                return heard

    heard = talk_with(page, ask)
    assert heard == sorted(heard)
    assert sum(number < 30 for number in heard) < 15


def test_nonsense_is_told_and_ends_nothing(page: Served) -> None:
    async def ask(talk: Talk) -> None:
        genome = talk.hello["genome"]
        for message in (
            {"kind": "show"},
            {"kind": "show", "number": 1, "genome": [1, 2]},
            {"kind": "show", "number": 1, "genome": [1e9] * len(genome)},
            {"kind": "show", "number": 1, "genome": genome,
             "conditions": {"density": -1}},
            {"kind": "show", "number": 1, "genome": genome,
             "conditions": {"when": "<script>"}},
            {"kind": "show", "number": 1, "genome": genome, "component": 7},
            {"kind": "improve", "number": 1, "genome": genome, "goal": "x"},
            {"kind": "format the disk", "number": 1, "genome": genome},
        ):  # fmt: skip
            talk.say(**message)
            with pytest.raises(AssertionError, match="problem"):
                while True:
                    told = await talk.hear("improved")
                    assert "problem" not in told, "problem"
        talk.say(kind="show", number=9, genome=genome)
        await talk.first(9)

    talk_with(page, ask)


def test_a_denser_field_has_more_leaf(page: Served) -> None:
    async def ask(talk: Talk) -> list[float]:
        areas = []
        own = talk.hello["conditions"]["density"]
        for number, density in enumerate((own, 2 * own), start=1):
            talk.say(
                kind="show", number=number, genome=talk.hello["genome"],
                conditions={"density": density},
            )  # fmt: skip
            told = await talk.first(number)
            areas.append(told["numbers"]["lai"][0])
        return areas

    one, two = talk_with(page, ask)
    assert two == pytest.approx(2 * one, rel=1e-3)


def test_many_moves_leave_nothing_behind(page: Served) -> None:
    """Memory of the program after 100 moves and after as many more."""

    def resident() -> int:
        status = Path(f"/proc/{page.process.pid}/status").read_text()
        line = next(x for x in status.splitlines() if x.startswith("VmRSS"))
        return int(line.split()[1])

    async def move(talk: Talk) -> None:
        genome = talk.hello["genome"]
        for number in range(1, 101):
            genome[1] = 0.05 + 0.0004 * number
            talk.say(kind="show", number=number, genome=genome)
            await talk.first(number)

    talk_with(page, move)
    first = resident()
    talk_with(page, move)
    assert resident() < first + 15_000


def test_a_search_ends_with_a_gain_that_was_measured_anew(
    page: Served,
) -> None:
    async def ask(talk: Talk) -> tuple[list[int], dict]:
        talk.say(kind="improve", number=1, genome=talk.hello["genome"],
                 goal="absorbed_par")  # fmt: skip
        tried = []
        while True:
            told = await talk.hear("improved")
            tried.append(told["done"])
            if told.get("is_final"):
                return tried, told

    tried, told = talk_with(page, ask)
    assert tried == sorted(tried) and tried[-1] == told["of"] == 200
    assert told["is_better"] and told["gain"] > 3 * told["error"] > 0


def test_a_plant_that_was_saved_is_opened_again(
    page: Served, tmp_path: Path
) -> None:
    opened = open_place(DAY)
    genome = opened.genome.copy()
    genome[0] = 0.9
    link = http.client.HTTPConnection("127.0.0.1", page.port, timeout=60)
    own = f"http://127.0.0.1:{page.port}"
    for form in ("crop", "campaign"):
        body = json.dumps(
            {"genome": genome.tolist(), "conditions": {"density": 4.0}}
        )
        link.request(
            "POST", f"/{token(page)}/save/{form}", body, {"Origin": own}
        )
        found = link.getresponse()
        text = found.read().decode()
        assert found.status == 200, text
        path = tmp_path / f"{form}.toml"
        path.write_text(text)
        again = open_place(str(path))
        assert again.genome[0] == pytest.approx(0.9)
        if form == "campaign":
            assert again.conditions.density == pytest.approx(4.0)
    assert tomllib.loads(text)["plant"]["baseline"]["leaf"][0]["length"] == 0.9


MIDRIBS = (
    "leaf,x_cm,z_cm\n1,0,20\n1,20,45\n1,45,40\n2,0,60\n2,15,95\n2,40,110\n"
)


def test_measured_plants_are_opened(tmp_path: Path) -> None:
    midribs = tmp_path / "mine.csv"
    midribs.write_text(MIDRIBS)
    found = open_place(str(midribs))
    assert "2 leaves of mine.csv" in found.about
    stand = Stand(found.base)
    obj = tmp_path / "mine.obj"
    mesh = stand.mesh(found.genome)
    lines = [f"v {x} {y} {z}" for x, y, z in mesh.vertices]
    last = ""
    for face, group in zip(mesh.faces, mesh.groups):
        if group.startswith("leaf"):
            if group != last:
                lines.append(f"g {group}")
            last = group
            lines.append("f " + " ".join(str(i + 1) for i in face))
    obj.write_text("\n".join(lines) + "\n")
    again = open_place(str(obj))
    lengths = [
        [leaf["length"] for leaf in each.base["plant"]["baseline"]["leaf"]]
        for each in (found, again)
    ]
    assert lengths[1] == pytest.approx(lengths[0], rel=0.05)
    leaves = open_place(str(CAMPAIGNS / "plants" / "F331_S1.csv"))
    assert len(leaves.base["plant"]["baseline"]["leaf"]) == 11


@pytest.mark.parametrize("crop", CROPS)
def test_crops_that_come_with_the_package_are_opened(crop: str) -> None:
    found = open_place(crop)
    assert found.conditions.when == "season" and found.free.any()


def test_every_campaign_is_opened() -> None:
    for path in sorted(CAMPAIGNS.glob("*.toml")):
        found = open_place(str(path))
        tables = tables_under(found.base, found.conditions, found.conditions)
        stand = Stand(tables)
        assert len(stand.baseline) == len(found.genome), path


BAD = {
    "missing.toml": None,
    "text.md": b"hello",
    "garbage.toml": b"\x00\xff = [",
    "empty.toml": b"",
    "wrong.toml": b"name = 'x'\n[[site]]\nlatitude = 'north'\n",
    "no.h5": b"\x89HDF\r\n\x1a\n and then nothing",
    "empty.csv": b"",
    "bad.csv": b"leaf,x_cm,z_cm\n1,zero,0\n",
    "no_faces.obj": b"v 0 0 0\n",
    "\x1b[2Jname.toml": b"x =",
}


@pytest.mark.parametrize("name", BAD)
def test_bad_files_are_refused_with_a_reason(
    tmp_path: Path, capsys: pytest.CaptureFixture, name: str
) -> None:
    path = tmp_path / name
    if (content := BAD[name]) is not None:
        path.write_bytes(content)
    assert play([str(path), "--no-browser"]) == 3
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.startswith("ideotype play: ")
    assert path.name.replace("\x1b", "\\x1b") in told.err
    assert "\x1b" not in told.err and "Traceback" not in told.err


def test_a_missing_folder_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture
) -> None:
    assert watch([str(tmp_path / "none"), "--no-browser"]) == 3
    assert "there is no such folder" in capsys.readouterr().err
    assert play(["maize", "--no-browser", "--port", "1234567"]) == 3


def test_errors_of_differences_use_the_same_random_numbers() -> None:
    random = np.random.default_rng(3)
    shared = random.normal(0, 1, (12, 1, 1))
    mine, other = Samples(), Samples()
    for seed in range(12):
        error = np.full((1, 1), 1.0)
        noise = random.normal(0, 0.1)
        mine.by_seed[seed] = np.hstack([shared[seed] + 5 + noise, error])
        other.by_seed[seed] = np.hstack([shared[seed] + 3, error])
    seeds = list(range(12))
    apart, error = mine.less(other, seeds)
    assert apart[0] == pytest.approx(2, abs=4 * error[0])
    assert error[0] < 0.06 < mine.together(seeds)[1][0]
    few = mine.less(other, seeds[: ENOUGH - 1])[1]
    assert few[0] == pytest.approx(np.sqrt(2 / (ENOUGH - 1)))


def test_a_folder_is_told_with_what_is_broken(
    finished: Path, tmp_path: Path
) -> None:
    hostile = "<img src=x onerror=alert(1)>.h5"
    (tmp_path / hostile).write_bytes(b"no history")
    deep = tmp_path / "deep"
    deep.mkdir()
    (deep / "case.h5").write_bytes(finished.read_bytes())
    told = Folder(tmp_path).tell()
    by_file = {case["file"]: case for case in told["cases"]}
    assert "problem" in by_file[hostile]
    case = by_file["deep/case.h5"]
    assert case["state"] == "finished" and case["core_hours_left"] == 0
    assert case["generation"] == len(case["convergence"][0])
    assert case["best"][0] > case["baseline"][0]
    assert (told["finished"], told["damaged"]) == (1, 1)
    json.dumps(told, allow_nan=False)


def test_a_running_case_is_told_while_it_grows(writer: WriterProcess) -> None:
    folder = Folder(writer.path.parent)
    told = folder.tell()["cases"][0]
    assert (told["state"], told["evaluations"]) == ("running", 0)
    assert told["best"] is None and told["core_hours_left"] is None
    writer.do("record 0 3")
    assert folder.tell()["cases"][0]["evaluations"] == 1
    writer.kill()
    told = folder.tell()
    assert told["cases"][0]["state"] == "interrupted"
    assert told["rate"] == 0


def test_an_error_is_raised_for_a_folder_that_is_not_there() -> None:
    with pytest.raises(Error, match="no such folder"):
        Folder(Path("/nowhere/at/all"))
