# SPDX-License-Identifier: Apache-2.0
"""Imports within the package have no cycle, and its public names are exactly
the documented ones."""

from __future__ import annotations

import ast
import graphlib
import inspect
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import pytest

import ideotype

TOP = Path(__file__).parents[3]
PACKAGE = TOP / "analysis/src/ideotype"


def sources(package: Path) -> dict[str, Path]:
    """Returns the files of a package by the names of their modules."""
    modules = {}
    for path in package.rglob("*.py"):
        parts = path.relative_to(package.parent).with_suffix("").parts
        name = ".".join(parts).removesuffix(".__init__")
        modules[name] = path
    return modules


def imported(name: str, files: dict[str, Path]) -> set[str]:
    """Returns the modules of the package that a module imports anywhere: at
    the top, in functions, and only for types."""
    tree = ast.parse(files[name].read_text())
    modules = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            modules |= {each.name for each in node.names}
        elif isinstance(node, ast.ImportFrom):
            is_package = files[name].name == "__init__.py"
            place = name.split(".")
            above = place[: len(place) - node.level + is_package]
            module = node.module or ""
            if node.level:
                module = ".".join([*above, *filter(None, [node.module])])
            for each in node.names:
                inner = f"{module}.{each.name}"
                modules.add(inner if inner in files else module)
    return (modules & files.keys()) - {name}


def graph(package: Path) -> dict[str, set[str]]:
    files = sources(package)
    return {name: imported(name, files) for name in files}


def between_packages(modules: dict[str, set[str]]) -> dict[str, set[str]]:
    """Returns the imports between packages; modules outside of packages count
    as packages."""

    def place(module: str) -> str:
        return ".".join(module.split(".")[:2])

    packages: dict[str, set[str]] = {
        place(module): set() for module in modules
    }
    for module, others in modules.items():
        packages[place(module)] |= {place(x) for x in others} - {place(module)}
    return packages


def test_modules_and_packages_import_without_a_circle() -> None:
    modules = graph(PACKAGE)
    assert len(modules) > 100
    # Imports inside functions are included.
    assert "ideotype.figures.field" in modules["ideotype.stand.stand"]
    # If imports have a cycle, this raises CycleError with the cycle.
    graphlib.TopologicalSorter(modules).prepare()
    graphlib.TopologicalSorter(between_packages(modules)).prepare()


def test_packages_import_those_above_them_in_the_table() -> None:
    text = (TOP / "analysis/README.md").read_text()
    table = re.findall(r"^\| `(ideotype\.\w+)` \|", text, re.MULTILINE)
    helpers = {"ideotype.common", "ideotype.errors"}
    packages = between_packages(graph(PACKAGE))
    assert {*table, *helpers, "ideotype", "ideotype.__main__"} == {*packages}
    for place, package in enumerate(table):
        assert packages[package] <= {*table[:place], *helpers}, package


def test_a_circle_of_imports_is_found(tmp_path: Path) -> None:
    package = tmp_path / "circle"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "first.py").write_text("from .second import name\n")
    (package / "second.py").write_text(
        "def name():\n    from . import first\n    return first\n"
    )
    with pytest.raises(graphlib.CycleError):
        graphlib.TopologicalSorter(graph(package)).prepare()


def test_importing_the_package_loads_no_large_library() -> None:
    large = ("matplotlib", "pandas", "xarray", "h5py", "scipy", "numpy")
    program = (
        "import sys, ideotype; dir(ideotype); "
        f"print([x for x in {large} if x in sys.modules]); "
        "ideotype.Stand; print('matplotlib' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.split("\n")[:2] == ["[]", "False"]


def documented() -> list[str]:
    """Returns the names documented on the page about the Python package."""
    text = (TOP / "docs/python_api.md").read_text()
    found = re.findall(r"^\.\. auto\w+:: (\S+)$", text, re.MULTILINE)
    assert len(found) > 30
    return found


@pytest.mark.parametrize("name", documented())
def test_documented_names_are_public(name: str) -> None:
    package, *inner = name.split(".")
    assert package == "ideotype" and inner[0] in dir(ideotype)
    assert not any(part.startswith("_") for part in inner)
    value = pkgutil.resolve_name(name)
    owner = pkgutil.resolve_name(name.rpartition(".")[0])
    if not inspect.ismodule(value) and hasattr(owner, "__all__"):
        assert inner[-1] in owner.__all__


def test_all_public_names_of_packages_are_documented() -> None:
    """Names of different packages may be equal, so that objects are
    compared."""
    packages = [*map(ideotype.__getattr__, ideotype._PACKAGES)]
    # The function `mesh` has the same name as a package, which would be found
    # instead.
    shown = {id(ideotype.mesh)}
    shown |= {id(pkgutil.resolve_name(name)) for name in documented()}
    shown |= {id(package) for package in packages}
    for package in (ideotype, *packages):
        for name in getattr(package, "__all__", ()):
            about = f"{package.__name__}.{name}"
            assert id(getattr(package, name)) in shown, about


@pytest.mark.parametrize("package", ["figures", "live", "search", "tools"])
def test_packages_use_the_names_of_a_stand_that_users_have(
    package: str,
) -> None:
    for path in (PACKAGE / package).rglob("*.py"):
        assert not re.findall(r"\bstand\._\w+", path.read_text()), path


def test_the_function_mesh_is_not_hidden_by_the_package_mesh() -> None:
    program = (
        "import ideotype.mesh.canopy, ideotype; "
        "print(callable(ideotype.mesh), ideotype.Canopy.__module__)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout == "True ideotype.mesh.canopy\n"
