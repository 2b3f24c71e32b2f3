# SPDX-License-Identifier: Apache-2.0
"""Files that commands write are complete or absent, stay in the folder that
the user has named, and replace nothing through a symbolic link."""

from __future__ import annotations

import os
import re
import resource
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from made_history import MadeHistory
from matplotlib.figure import Figure

from ideotype.common.output import (
    OutputRefused,
    file_name,
    require_output,
    save_figure,
    write_file,
)
from ideotype.tools import (
    commands,
    compare,
    crate,
    fidelity,
    fit,
    weather,
)

EVIL = "../../PWN"
CRATE = ("--author", "Ada", "--license", "CC0-1.0")


def finished(path: Path, **attributes: str) -> Path:
    """Writes a finished history; its attributes may have any content."""
    path.parent.mkdir(parents=True, exist_ok=True)
    made = MadeHistory(path, attributes=attributes)
    made.evolve(2)
    made.finish()
    made.close()
    return path


def tree(folder: Path) -> dict[str, bytes]:
    """Returns all files of a folder with their contents."""
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and not path.is_symlink()
    }


@contextmanager
def small_files() -> Iterator[None]:
    """Limits the size of files, which imitates a full disk."""
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)


@pytest.mark.parametrize("former", [None, b"former"])
@pytest.mark.parametrize("has_root", [False, True])
def test_a_failed_write_leaves_the_former_file_or_none(
    former: bytes | None, has_root: bool, tmp_path: Path
) -> None:
    path = tmp_path / "some.csv"
    root = tmp_path if has_root else None
    if former:
        path.write_bytes(former)
    before = tree(tmp_path)
    with small_files(), pytest.raises(OSError, match=re.escape(str(path))):
        write_file(path, b"x" * 10_000, root)
    assert tree(tmp_path) == before
    write_file(path, "new", root)
    assert tree(tmp_path) == {"some.csv": b"new"}


def test_a_file_that_must_be_new_replaces_nothing(tmp_path: Path) -> None:
    path = tmp_path / "some.csv"
    write_file(path, "first", replaces=False)
    with pytest.raises(OutputRefused, match="exists already"):
        write_file(path, "second", replaces=False)
    assert tree(tmp_path) == {"some.csv": b"first"}


def test_an_interrupted_write_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_file(tmp_path / "some.csv", "text")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("kind", ["file", "nothing", "folder", "pipe"])
def test_special_files_are_refused_as_outputs(
    kind: str, tmp_path: Path
) -> None:
    precious, path = tmp_path / "precious", tmp_path / "out" / "some.csv"
    path.parent.mkdir()
    if kind == "folder":
        path.mkdir()
    elif kind == "pipe":
        os.mkfifo(path)
    else:
        path.symlink_to(precious)
    if kind == "file":
        precious.write_text("precious")
    for refuse in (require_output, lambda path: write_file(path, "x")):
        with pytest.raises(OutputRefused, match=r"some\.csv: this is a "):
            refuse(path)
    assert tree(tmp_path) == (
        {"precious": b"precious"} if kind == "file" else {}
    )


def test_an_output_folder_named_by_the_user_may_be_a_link(
    tmp_path: Path,
) -> None:
    (tmp_path / "disk").mkdir()
    root = tmp_path / "link"
    root.symlink_to(tmp_path / "disk")
    write_file(root / "figures" / "a.svg", "x", root)
    write_file(root / "b.csv", "y")
    assert tree(tmp_path / "disk") == {"figures/a.svg": b"x", "b.csv": b"y"}


def test_links_below_the_output_folder_are_refused(tmp_path: Path) -> None:
    root, other = tmp_path / "out", tmp_path / "other"
    root.mkdir()
    other.mkdir()
    (root / "figures").symlink_to(other)
    path = root / "figures" / "a.svg"
    for refuse in (
        require_output,
        lambda path, root: write_file(path, "x", root),
    ):
        with pytest.raises(OutputRefused, match="figures: this is a symbolic"):
            refuse(path, root)
        with pytest.raises(OutputRefused, match="is not in"):
            refuse(root / ".." / "a.svg", root)
    assert not tree(tmp_path)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("ames_0807-r1", "ames_0807-r1"),
        (EVIL, "_PWN"),
        ("/etc/passwd", "_etc_passwd"),
        ("..", "_"),
        ("a\0b\nc", "a_b_c"),
        ("maïs", "maïs"),
    ],
)
def test_any_text_becomes_a_file_name(text: str, name: str) -> None:
    assert file_name(text) == name


def test_long_file_names_are_cut_and_stay_distinct() -> None:
    one, two = (file_name("ä" * 500 + end) for end in "12")
    assert one != two
    assert len(one.encode()) <= 200


def test_a_crate_writes_only_into_its_folder(tmp_path: Path) -> None:
    folder = tmp_path / "a" / "b"
    finished(folder / "x.h5", campaign=EVIL, case=EVIL)
    assert crate.main([str(folder), *CRATE]) == 0
    assert all(name.startswith("a/b/") for name in tree(tmp_path))
    names = sorted(path.name for path in (folder / "inputs").iterdir())
    assert [re.sub(r"[0-9a-f]{8}", "#", name) for name in names] == [
        "_PWN_#.toml",
        "_PWN_resolved_#.toml",
    ]


def test_a_report_writes_only_into_its_folder(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = finished(tmp_path / "a" / "x.h5", campaign=EVIL, case=EVIL)
    out = tmp_path / "b" / "report"
    assert commands.report([str(path), "-o", str(out), "-j1"]) == 0
    names = set(tree(tmp_path)) - {"a/x.h5"}
    assert all(name.startswith("b/report/") for name in names)
    assert any(name.startswith("b/report/figures/_PWN_") for name in names)


@pytest.mark.parametrize("name", [crate.METADATA, "inputs", "report.html"])
def test_a_crate_writes_through_no_link(
    name: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    folder, other = tmp_path / "a", tmp_path / "other"
    finished(folder / "x.h5")
    other.mkdir()
    (other / "precious").write_text("precious")
    target = other if name == "inputs" else other / "precious"
    (folder / name).symlink_to(target)
    before = tree(tmp_path)
    # report.html is an input, which the command only reads.
    code = 1 if name == "report.html" else 4
    assert crate.main([str(folder), *CRATE]) == code
    assert f"{folder / name}: this " in capfd.readouterr().err
    assert tree(tmp_path) == before


@pytest.mark.parametrize("name", ["results.csv", "report.html", "figures"])
def test_a_report_writes_through_no_link(
    name: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = finished(tmp_path / "a" / "x.h5")
    out, other = tmp_path / "report", tmp_path / "other"
    out.mkdir()
    other.mkdir()
    (other / "precious").write_text("precious")
    target = other if name == "figures" else other / "precious"
    (out / name).symlink_to(target)
    before = tree(tmp_path)
    assert commands.report([str(path), "-o", str(out), "-j1"]) == 4
    assert f"{out / name}: this is a symbolic" in capfd.readouterr().err
    assert tree(tmp_path) == before


def test_a_report_on_a_full_disk_leaves_no_partial_file(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = finished(tmp_path / "a" / "x.h5")
    out = tmp_path / "report"
    with small_files():
        assert commands.report([str(path), "-o", str(out), "-j1"]) == 1
    assert "File too large" in capfd.readouterr().err
    for name, content in tree(out).items():
        assert name.endswith(".csv") and content.endswith(b"\n")


def test_every_option_for_an_output_refuses_links(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    precious = tmp_path / "precious"
    precious.write_text("precious")
    link = tmp_path / "link.png"
    link.symlink_to(precious)
    to, no = str(link), str(tmp_path / "none.toml")
    for main, words in (
        (compare.main, [no, "--under", no, "--csv", to]),
        (fit.main, [no, "--crop", no, "--to", to]),
        (weather.main, [no, "--to", to]),
        (fidelity.main, [no, "--figure", to]),
        (fidelity.main, [no, "--json", to]),
    ):
        assert main(words) == 4, words
        assert f"{link}: this is a symbolic link" in capsys.readouterr().err
    assert precious.read_text() == "precious"


def test_outputs_that_must_be_new_replace_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    to, no = tmp_path / "precious", str(tmp_path / "none.toml")
    to.write_text("precious")
    for main, words in (
        (compare.main, [no, "--under", no, "--csv", str(to)]),
        (fit.main, [no, "--crop", no, "--to", str(to)]),
    ):
        assert main(words) == 4
        assert f"{to}: this file exists already" in capsys.readouterr().err
    assert to.read_text() == "precious"


def test_figures_are_written_in_the_format_of_their_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for ending, begin in (
        ("png", b"\x89PNG"),
        ("PDF", b"%PDF"),
        ("svg", b"<?xml"),
    ):
        save_figure(Figure(), path := tmp_path / f"a.{ending}")
        assert path.read_bytes().startswith(begin)
    for main, words in ((fidelity.main, ["a.toml"]),):
        with pytest.raises(SystemExit) as ended:
            main([*words, "--figure", "a.doc"])
        assert ended.value.code == 2
        assert "a name that ends in .png" in capsys.readouterr().err
