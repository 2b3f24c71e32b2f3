# SPDX-License-Identifier: Apache-2.0
"""All command blocks of the manual and of the READMEs for users are run, and
no page is wider than the screen of a phone. A block of bash or python is a
separate program, and the blocks of a page begin in a clone of the project. A
block of console contains commands after `$ ` and their output: each line must
occur in the real output, except for numbers. A block with a file name as its
caption is this file."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path

import pytest
from phone import phone_with

TOP = Path(__file__).parents[3]
DOCS = TOP / "docs"
PAGES = sorted([*DOCS.glob("*.md"), *(DOCS / "results").glob("*.md")])
READMES = [
    TOP / folder / "README.md"
    for folder in (
        ".",
        "analysis",
        "slurm",
        "campaigns",
        "analysis/benchmark",
    )
]

REASONS = (
    "changes the system",
    "takes long",
    "needs a cluster",
    "needs another system",
    "it serves until it is stopped",
    "it asks questions",
)
"""The reasons why a block may not be run: `<!-- not run: REASON -->` stands
before it."""
MOST_EXEMPT = 0.25
"""The largest part of all blocks that may not be run."""

_BLOCK = re.compile(
    r"(?ms)^(?:<!-- not run: (?P<reason>[^>]*) -->\n)?"
    r"^(?P<fence>```+)(?:\{code-block\} )?(?P<kind>bash|console|python|toml|csv)\n"
    r"(?::caption: (?P<file>\S+)\n+)?(?P<text>.*?)^(?P=fence)$"
)


@dataclass(frozen=True)
class Block:
    kind: str
    text: str
    file: str
    reason: str

    @property
    def is_run(self) -> bool:
        return self.kind in ("bash", "console", "python")


def list_blocks(page: Path) -> list[Block]:
    return [
        Block(
            block["kind"], block["text"], block["file"] or "",
            block["reason"] or "",
        )
        for block in _BLOCK.finditer(page.read_text())
    ]  # fmt: skip


def list_commands(console: str) -> list[tuple[str, list[str]]]:
    """Returns the commands, each with the lines of its output."""
    steps: list[tuple[str, list[str]]] = []
    for line in console.splitlines():
        if line.startswith("$ "):
            steps.append((line[2:], []))
        elif steps[-1][0].endswith("\\"):
            steps[-1] = (f"{steps[-1][0]}\n{line}", [])
        else:
            steps[-1][1].append(line)
    return steps


def without_numbers(line: str) -> str:
    return re.sub(
        r"\s+", " ", re.sub(r"[-+]?[0-9][0-9.e]*", "#", line)
    ).strip()


@pytest.fixture
def clone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Makes a copy of the parts of the project that pages use, with the
    program on PATH."""
    program = os.environ.get("IDEOTYPE_EXECUTABLE")
    assert program, "IDEOTYPE_EXECUTABLE names no program"
    for folder in ("campaigns", "analysis", "docs", "slurm", "tests/data"):
        shutil.copytree(
            TOP / folder, tmp_path / folder,
            ignore=shutil.ignore_patterns("*.png", "__pycache__"),
        )  # fmt: skip
    tools = tmp_path / ".tools"
    tools.mkdir()
    (tools / "ideotype").symlink_to(Path(program).resolve())
    python = Path(sys.executable)
    (tools / "python").symlink_to(python)
    path = f"{tools}:{python.parent}:{os.environ['PATH']}"
    monkeypatch.setenv("PATH", path)
    return tmp_path


def run(command: list[str], folder: Path, title: str) -> str:
    done = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, timeout=300,
        check=False,
    )  # fmt: skip
    said = done.stdout + done.stderr
    assert done.returncode == 0, f"{title}\n{said[-3000:]}"
    return said


@pytest.mark.parametrize(
    "page",
    PAGES,
    ids=lambda page: str(page.relative_to(DOCS).with_suffix("")),
)
def test_every_block_of_a_page_runs(page: Path, clone: Path) -> None:
    for block in list_blocks(page):
        if block.file:
            (clone / block.file).write_text(block.text)
        elif block.reason or not block.is_run:
            continue
        elif block.kind == "bash":
            run(
                ["bash", "-euo", "pipefail", "-c", block.text],
                clone,
                block.text,
            )
        elif block.kind == "python":
            run([sys.executable, "-c", block.text], clone, block.text)
        else:
            for command, shown in list_commands(block.text):
                said = run(
                    ["bash", "-euo", "pipefail", "-c", command], clone, command
                )
                printed = [without_numbers(line) for line in said.splitlines()]
                for line in shown:
                    assert line == "..." or without_numbers(line) in printed, (
                        f"{command}\ndoes not print\n{line}\nbut\n{said}"
                    )


@pytest.fixture
def clone_with_results(clone: Path) -> Path:
    """Adds an environment, a built program and the results of a shortened
    ames.toml, at the paths that READMEs name."""
    (clone / ".venv").symlink_to(sys.prefix)
    built = clone / "build" / "release" / "src"
    built.mkdir(parents=True)
    (built / "ideotype").symlink_to(clone / ".tools" / "ideotype")
    ames = clone / "campaigns" / "ames.toml"
    text = ames.read_text()
    for long, short in (
        ("generations = 200", "generations = 2"),
        ("[search]", "[search]\npopulation = 8"),
        ("replicates = 3", "replicates = 1"),
        ("candidates = 5", "candidates = 2"),
    ):
        assert long in text
        text = text.replace(long, short)
    ames.write_text(text)
    run(["ideotype", "run", "campaigns/ames.toml"], clone, "a short run")
    return clone


@pytest.mark.parametrize(
    "page", READMES, ids=lambda page: str(page.parent.relative_to(TOP))
)
def test_every_command_of_a_readme_runs(
    page: Path, clone_with_results: Path
) -> None:
    """Python blocks of analysis/README.md depend on each other, so that
    test_report runs them together."""
    for block in list_blocks(page):
        if block.kind == "bash" and not block.reason:
            command = ["bash", "-euo", "pipefail", "-c", block.text]
            run(command, clone_with_results, block.text)


def test_every_submission_of_a_readme_can_be_planned(
    clone_with_results: Path,
) -> None:
    """tests/slurm submits jobs; this test checks the options of each
    command."""
    commands = [
        line
        for block in list_blocks(TOP / "slurm" / "README.md")
        for line in block.text.splitlines()
        if line.startswith("slurm/submit ") and block.reason
    ]
    assert len(commands) == 4
    for command in commands:
        dry = command.replace("submit", "submit --dry-run --out none", 1)
        said = run(["bash", "-c", dry], clone_with_results, dry)
        assert "sbatch" in said


def test_every_installation_of_a_text_is_possible() -> None:
    """The project is not on a package index. Installation commands therefore
    use its folder with existing extras, or the wheel made by .ci/wheel; the
    quickstart installs the extras of all commands."""
    extras = tomllib.loads((TOP / "pyproject.toml").read_text())["project"][
        "optional-dependencies"
    ]
    named = set()
    for page in [*PAGES, *READMES]:
        for words in re.findall(r"pip install ([^`\n#]+)", page.read_text()):
            for word in shlex.split(words):
                if word == "dist/ideotype-*.whl":
                    assert ".ci/wheel\n" in page.read_text()
                    continue
                found = re.fullmatch(r"\.(?:\[(.*)\])?", word)
                assert found, f"{page}: pip install {words}"
                named |= set((found[1] or "").split(",")) - {""}
    assert named <= set(extras)
    assert {"weather", "sensitivity"} <= named
    quick = re.search(
        r"install_python release (\S+)", (TOP / "quickstart.sh").read_text()
    )
    assert quick
    assert named - {"test", "docs", "lint", "examples"} <= set(
        quick[1].split(",")
    )


def test_every_promise_of_the_contract_names_tests_that_exist() -> None:
    """Tests are shell scripts, folders, or suites of GoogleTest."""
    page = (DOCS / "contract.md").read_text()
    promises = re.findall(r"(?m)^\| \*\*C\d\*\* .* \| (.*) \|$", page)
    assert len(promises) == 5
    sources = [
        path.read_text() for path in (TOP / "tests").rglob("test_*.cpp")
    ]
    scripts = {
        "App": "tests/cli/test_{}.sh",
        "Stress": "tests/stress/{}.sh",
        "Slurm": "tests/slurm/test_all.sh",
    }
    for promise in promises:
        names = re.findall("`(.*?)`", promise)
        assert names, promise
        for name in names:
            area, _, test = name.partition(".")
            if area in scripts or "/" in name:
                path = scripts.get(area, name).format(test)
                assert (TOP / path).exists(), name
            else:
                suite = re.compile(rf"\bTEST(_F|_P)?\({name},")
                assert any(map(suite.search, sources)), name


def test_few_blocks_are_exempt(capsys: pytest.CaptureFixture[str]) -> None:
    blocks = [
        block for page in PAGES for block in list_blocks(page) if block.is_run
    ]
    exempt = [block for block in blocks if block.reason]
    of_readmes = [block for page in READMES for block in list_blocks(page)]
    for block in [*exempt, *of_readmes]:
        assert block.reason in ("", *REASONS), block
    # At most half of the blocks in READMEs may be exempt: those that install,
    # start servers, or need SLURM.
    exempt_readme = [block for block in of_readmes if block.reason]
    assert len(exempt_readme) <= 0.6 * len(of_readmes)
    with capsys.disabled():
        print(
            f"\nmanual: {len(blocks) - len(exempt)} blocks are run,"
            f" {len(exempt)} exempt"
        )
    assert len(exempt) <= MOST_EXEMPT * len(blocks)


@pytest.mark.parametrize(
    "page",
    [*PAGES, *READMES],
    ids=lambda page: str(page.relative_to(TOP).with_suffix("")),
)
def test_all_blocks_are_found(page: Path) -> None:
    """Every block of code is of a kind that this test knows, or is not a
    program."""
    text = page.read_text()
    fences = re.findall(r"(?m)^```+(?=[^`\s])(.*)$", text)
    code = [
        fence
        for fence in fences
        if not re.match(r"\{(?!code-block)|text$|json$", fence)
    ]
    assert len(code) == len(list_blocks(page)), code
    outside = _BLOCK.sub("", text)
    indented = r"(?m)^    (ideotype |slurm/|\.venv/|\./)"
    assert not re.search(indented, outside), "an indented block"
    assert text.count("<!-- not run") == sum(
        bool(block.reason) for block in list_blocks(page)
    )


def test_links_of_every_text_lead_somewhere(manual: Path) -> None:
    """All links in Markdown files of the repository are checked, including
    those to generated pages of the manual; docs/build checks anchors."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "*.md"],
        cwd=TOP, capture_output=True, text=True, check=True,
    )  # fmt: skip
    texts = [TOP / name for name in listed.stdout.split("\0") if name]
    assert TOP / "README.md" in texts
    for text in texts:
        for target in re.findall(
            r"\]\((?![a-z]+:|#)([^)#\s]+)", text.read_text()
        ):
            assert (text.parent / target).exists(), f"{text}: {target}"


@pytest.fixture(scope="session")
def manual() -> Path:
    """Provides the manual, rebuilt after changes; warnings are errors."""
    done = subprocess.run(
        [DOCS / "build", sys.executable],
        capture_output=True, text=True, timeout=600, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return TOP / "build" / "manual"


def test_pages_are_as_wide_as_the_screen(manual: Path, tmp_path: Path) -> None:
    """The widths are those of a phone and of a desktop screen; wider elements,
    such as tables, scroll separately."""
    names = sorted(
        str(path.relative_to(manual))
        for pattern in ("*.html", "results/*.html")
        for path in manual.glob(pattern)
    )
    assert {"index.html", "results/index.html"} <= set(names)
    for width in (390, 1280):
        folder = tmp_path / str(width)
        folder.mkdir()
        with phone_with(manual / "index.html", folder, width) as phone:
            for name in names:
                phone.show(manual / name)
                wide = phone.value("document.documentElement.scrollWidth")
                assert wide <= width, f"{name} is {wide} wide at {width}"


def test_the_reference_documents_the_compiled_module(
    manual: Path,
) -> None:
    page = (manual / "python_api.html").read_text()
    for name in (
        "Stand.evaluate",
        "mesh",
        "Canopy.evaluate",
        "search.gest.vocs",
    ):
        assert f'id="ideotype.{name}"' in page


def test_the_manual_reports_missing_packages(
    tmp_path: Path,
) -> None:
    empty = tmp_path / "empty"
    command = [sys.executable, "-m", "venv", "--without-pip", empty]
    subprocess.run(command, check=True)
    done = subprocess.run(
        [DOCS / "build", empty / "bin" / "python"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert "No module named 'breathe'" in done.stderr
    assert f"run  {empty}/bin/python -m pip install '.[docs]'" in done.stderr
    assert done.stderr.count("\n") == 1


def test_every_picture_is_small_and_has_its_script() -> None:
    drawn = (DOCS / "draw.py").read_text()
    pages = (DOCS / "draw_pages.py").read_text()
    for picture in (DOCS / "figures").glob("*.*"):
        assert picture.stat().st_size <= 150_000, picture
        assert f'"{picture.stem}"' in drawn or f'"{picture.name}"' in pages, (
            picture
        )
