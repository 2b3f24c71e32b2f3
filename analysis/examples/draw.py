#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs examples as users run them, and draws the gallery of the manual.

    draw.py [--examples FOLDER] [NUMBER...]

Examples in C++ are the programs in FOLDER, which CMakeLists.txt builds. A
picture is docs/figures/gallery/NAME.png: a figure of the example, a chart of the
table that it writes or prints, or the last figure of a notebook."""

from __future__ import annotations

import argparse
import base64
import json
import os
import subprocess
import sys
from io import BytesIO, StringIO
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib
import pandas as pd
from PIL import Image

HERE = Path(__file__).resolve().parent
TOP = HERE.parents[1]
GALLERY = TOP / "docs" / "figures" / "gallery"


def examples() -> list[Path]:
    return sorted(HERE.glob("[0-9][0-9]_*"))


def run(example: Path, folder: Path, built: Path | None = None) -> str:
    """Runs an example in a folder, and returns what it prints."""
    for name in ("campaigns", "analysis"):
        place = folder / name
        if not place.exists():
            place.symlink_to(TOP / name)
    if example.suffix == ".ipynb":
        return run_notebook(example, folder)
    words = {
        ".py": [sys.executable, str(example)],
        ".sh": ["bash", str(example)],
        ".cpp": [str((built or Path()) / example.stem)],
    }[example.suffix]
    tools = [Path(sys.executable).parent]
    if program := os.environ.get("IDEOTYPE_EXECUTABLE"):
        tools.insert(0, Path(program).parent)
    path = os.pathsep.join([*map(str, tools), os.environ["PATH"]])
    done = subprocess.run(
        words,
        cwd=folder,
        env=os.environ
        | {
            "PATH": path,
            "MPLBACKEND": "Agg",
            "IDEOTYPE_PYTHON": sys.executable,
        },
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    if done.returncode != 0:
        raise RuntimeError(
            f"{example.name} failed:\n{done.stdout}{done.stderr}"
        )
    return done.stdout


def run_notebook(example: Path, folder: Path) -> str:
    """Executes a notebook, and saves its last picture."""
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.read(example, as_version=4)
    resources = {"metadata": {"path": folder}}
    NotebookClient(notebook, timeout=600, resources=resources).execute()
    outputs = [
        output for cell in notebook.cells for output in cell.get("outputs", [])
    ]
    pictures = [
        each.data["image/png"]
        for each in outputs
        if "image/png" in each.get("data", {})
    ]
    (folder / f"{example.stem}.png").write_bytes(
        base64.b64decode(pictures[-1])
    )
    return "".join(each.get("text", "") for each in outputs)


def chart(table: pd.DataFrame, path: Path) -> None:
    """Draws the columns of a table against its first."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5, 3.2), layout="constrained")
    axes = figure.add_subplot()
    x, *columns = (c for c in table.columns if c != "standard error")
    for column in columns:
        axes.plot(
            table[x], table[column], "o-", ms=4, label=column.split(" [")[0]
        )
    unit = columns[0].partition(" [")[2].rstrip("]")
    axes.set(
        xlabel=x, ylabel=unit or (columns[0] if len(columns) == 1 else "")
    )
    if len(columns) > 1:
        axes.legend()
    figure.savefig(path)


def bars(indices: dict, path: Path) -> None:
    """Draws total indices of absorbed light from the JSON of `ideotype indices`."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5, 3.2), layout="constrained")
    axes = figure.add_subplot()
    factors = indices["quantities"]["absorbed_par"]["factors"]
    totals = [each["total"] for each in factors.values()]
    axes.barh(
        list(factors),
        [each["mean"] for each in totals],
        xerr=[1.96 * each["standard_error"] for each in totals],
    )
    axes.set(xlabel="total Sobol' index")
    figure.savefig(path)


def draw(example: Path, folder: Path, built: Path | None) -> str:
    """Runs an example and saves its reduced picture in the gallery."""
    said = run(example, folder, built)
    drawn = folder / f"{example.stem}.png"
    table, tree = drawn.with_suffix(".csv"), drawn.with_suffix(".json")
    if example.suffix == ".cpp":
        chart(pd.read_csv(StringIO(said)), drawn)
    elif table.exists():
        chart(pd.read_csv(table), drawn)
    elif tree.exists():
        bars(json.loads(tree.read_text()), drawn)
    GALLERY.mkdir(parents=True, exist_ok=True)
    picture = Image.open(BytesIO(drawn.read_bytes())).convert("RGB")
    picture.thumbnail((560, 420))
    picture.quantize(32, dither=Image.Dither.NONE).save(
        GALLERY / f"{example.stem}.png", optimize=True
    )
    return said


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--examples", type=Path)
    parser.add_argument("numbers", nargs="*")
    options = parser.parse_args()
    matplotlib.use("Agg")
    for example in examples():
        if options.numbers and example.name[:2] not in options.numbers:
            continue
        with TemporaryDirectory() as folder:
            said = draw(example, Path(folder), options.examples)
        print(f"{example.name}\n{said}")


if __name__ == "__main__":
    main()
