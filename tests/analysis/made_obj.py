# SPDX-License-Identifier: Apache-2.0
"""Makes files of a plant with two digitised leaves."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

from ideotype import Stand
from ideotype.live.opened import open_place

MIDRIBS = (
    "leaf,x_cm,z_cm\n1,0,20\n1,20,45\n1,45,40\n2,0,60\n2,15,95\n2,40,110\n"
)


def obj_of(midribs: str) -> str:
    """Returns the mesh of the leaves of a digitised plant as an OBJ file."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "plant.csv"
        path.write_text(midribs)
        found = open_place(str(path))
    mesh = Stand(found.base).mesh(found.genome)
    lines = [f"v {x} {y} {z}" for x, y, z in mesh.vertices]
    last = ""
    for face, group in zip(mesh.faces, mesh.groups):
        if group.startswith("leaf"):
            if group != last:
                lines.append(f"g {group}")
            last = group
            lines.append("f " + " ".join(str(i + 1) for i in face))
    return "\n".join(lines) + "\n"
