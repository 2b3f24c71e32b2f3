# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype fit`: writes a crop file for each plant of a table of
measured leaves, or for a digitised plant, and reports the deviation of each
fitted leaf."""

from __future__ import annotations

import argparse
import json
import shlex
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import tomli_w

from ..common.output import REFUSED, OutputRefused, require_output, write_file
from ..errors import Error, printable, printable_lines
from ..stand.measured.agreement import agreement
from ..stand.measured.fitted import crop_of, mesh_of
from ..stand.measured.leaf_tables import MeasuredCrop, measured_crops
from ..stand.measured.plant_sources import (
    crop_tables,
    is_digitised,
    read_plant,
    require_blades,
)


def _fit_leaves(options: argparse.Namespace) -> int:
    """Writes a crop file for each plant of a table of measured leaves."""
    crops = measured_crops(
        options.source, options.crop or "", options.plant or ""
    )
    files = _choose_files(crops, options)
    for crop, file in zip(crops, files):
        text = _head(crop, options) + crop.text
        write_file(file, text, file.parent, replaces=False)
    if options.json:
        records = [
            {
                "plant": crop.plant,
                "file": str(file),
                "leaves": len(crop.tables["leaf"]),
                "crop": crop.crop,
            }
            for crop, file in zip(crops, files)
        ]
        print(json.dumps(records, indent=1))
        return 0
    for crop, file in zip(crops, files):
        remark = f" ({crop.remark})" if crop.remark else ""
        text = f"{len(crop.tables['leaf'])} leaves are in {file}{remark}"
        print(printable_lines(text))
    return 0


def _choose_files(
    crops: Sequence[MeasuredCrop], options: argparse.Namespace
) -> list[Path]:
    """Returns the output file of each crop. Raises Error or OutputRefused if a
    file exists or names collide."""
    to = options.to
    if to and len(crops) > 1 and to.suffix == ".toml":
        raise Error(
            f"{to}: the table has {len(crops)} plants (a file has one); "
            "name a folder, or choose a plant by --plant"
        )
    if to and not to.is_dir() and len(crops) == 1:
        files = [to]
    else:
        folder = to or options.source.parent
        files = [folder / f"{crop.name}.toml" for crop in crops]
    for file, count in Counter(files).items():
        if count > 1:
            raise Error(
                f"{options.source}: {count} plants have the name {file.stem} "
                "(names have letters, digits, _ and -); rename them"
            )
        require_output(file, replaces=False)
    return files


def _head(crop: MeasuredCrop, options: argparse.Namespace) -> str:
    """Returns the comments of a crop file: its origin and the comments of the
    table."""
    words = ["ideotype", "fit", options.source.name]
    words += ["--crop", options.crop] if options.crop else []
    words += ["--plant", options.plant] if options.plant else []
    plant = f"plant {crop.plant} of " if crop.plant else ""
    lines = [
        f"Leaves of {plant}{options.source.name}, by {shlex.join(words)}.",
        f"Everything that the table lacks is from the crop {crop.crop}.",
        *([f"Note: {crop.remark}."] if crop.remark else []),
        *crop.comments,
    ]
    return "".join(f"# {printable(x)}".rstrip() + "\n" for x in lines) + "\n"


def _fit_blades(options: argparse.Namespace) -> int:
    """Writes a crop file of a digitised plant and prints the deviations of its
    leaves."""
    to = options.to or options.source.with_suffix(".toml")
    require_output(to, replaces=False)
    if not options.crop:
        raise Error(
            f"{options.source}: a digitised plant has no stalk, organs and "
            "traits; name the crop that supplies them, such as --crop maize"
        )
    blades = read_plant(
        options.source,
        options.plant,
        options.leaves,
        options.unit,
        options.ground,
    )
    crop = crop_tables(options.crop)
    require_blades(crop, options.crop)
    crop = crop_of(blades, crop, options.name or to.stem, options.form)
    table = agreement(blades, crop, mesh_of(crop, Path(options.crop).parent))
    write_file(to, tomli_w.dumps(crop), replaces=False)
    if options.json:
        print(
            json.dumps(json.loads(table.to_json(orient="records")), indent=1)
        )
    else:
        print(table.to_string(index=False, float_format="{:.4g}".format))
        print(f"\n{len(table)} leaves are in {to}")
    return 0


_OF_BLADES = ("leaves", "unit", "ground", "form", "name")
"""The options of digitised plants."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Fits plants and returns the exit code: 0, 2 for a wrong command line, 3
    for an input that cannot be read, 4 for an output file that exists or is a
    symbolic link."""
    parser = argparse.ArgumentParser(
        prog="ideotype fit",
        description="Makes crop files of measured plants. SOURCE is a CSV file "
        "of leaves (one line for each, with length_cm, width_cm and so on; "
        "docs/plant.md lists all columns), a CSV file of midribs (leaf, x "
        "outward from the stalk, z up, optionally y, in _m, _cm or _mm), a DAT "
        "file of NURBS surfaces (MaizeField3D), or a mesh or point cloud with a "
        "group, object or colour for each leaf (OBJ, PLY). For a digitised "
        "plant the deviation of each leaf is printed.",
        epilog="example: ideotype fit trial.csv --crop maize",
    )
    add = parser.add_argument
    add("source", type=Path, metavar="SOURCE")
    add("--crop", metavar="CROP",
        help="crop, by name or file, that supplies everything not measured; a "
        "table of leaves may name it in a line # crop: maize")  # fmt: skip
    add("--to", type=Path, metavar="FILE|FOLDER",
        help="crop file to write, or folder for several plants (default: "
        "NAME.toml in the folder of SOURCE)")  # fmt: skip
    add("--plant", metavar="NAME",
        help="plant of a CSV file with a column plant (default for a table of "
        "leaves: all plants)")  # fmt: skip
    group = parser.add_argument_group("options of digitised plants")
    add = group.add_argument
    add("--leaves", type=Path, metavar="FILE",
        help="CSV file of lengths, widths, azimuths and heights of the leaves")  # fmt: skip
    add("--unit", choices=["auto", "m", "cm", "mm"], default="auto",
        help="unit of lengths, if the source does not state it; auto: by the "
        "length of leaves")  # fmt: skip
    add("--ground", type=float, default=float("nan"), metavar="Z",
        help="z of the soil in the unit of the source (default: of the lowest "
        "point)")  # fmt: skip
    add("--form", choices=["midrib", "angles"], default="midrib",
        help="form of leaves: points of midribs, or insertion angles and "
        "curvatures")  # fmt: skip
    add("--name", help="name of the plant (default: that of FILE)")
    parser.add_argument(
        "--json", action="store_true", help="print JSON instead of text"
    )
    options = parser.parse_args(arguments)
    is_table = options.source.suffix.lower() == ".csv" and not is_digitised(
        options.source
    )
    for name in _OF_BLADES if is_table else ():
        # A number that is not given is NaN, which differs from itself.
        if str(getattr(options, name)) != str(parser.get_default(name)):
            parser.error(f"--{name} is for digitised plants, not for leaves")
    try:
        return _fit_leaves(options) if is_table else _fit_blades(options)
    except OutputRefused as error:
        print(printable_lines(f"ideotype fit: {error}"), file=sys.stderr)
        return REFUSED
    except (Error, OSError) as error:
        print(printable_lines(f"ideotype fit: {error}"), file=sys.stderr)
        return 3


if __name__ == "__main__":
    sys.exit(main())
