# SPDX-License-Identifier: Apache-2.0
"""Stands in for `ideotype export`: ten square leaves and a stalk.

Started as `made_program.py export HISTORY ROW... --to FILE`. The leaves of
the best plant are twice as long as those of the baseline, those of other slots
2 cm longer for each, those in Edmonton 10 % longer."""

from __future__ import annotations

import sys
from pathlib import Path

LEAVES = 10
FACES = LEAVES + 1
AREA = 0.03
"""Of a leaf of the baseline [m2]."""


def main() -> None:
    """Writes the plant, or fails as the program does."""
    arguments = sys.argv[1:]
    if "broken" in arguments[1]:
        sys.exit("ideotype: this history is broken")
    length = 0.6 if "--best" in arguments else 0.3
    if "--slot" in arguments:
        length += 0.02 * int(arguments[arguments.index("--slot") + 1])
    if "edmonton" in arguments[1]:
        length *= 1.1
    lines = ["# made"]
    for leaf in range(LEAVES):
        z, x = 0.2 + 0.15 * leaf, length * (-1) ** leaf
        lines += [f"v {a} {b} {z}" for a, b in ((0, 0), (x, 0))]
        lines += [f"v {a} {b} {z}" for a, b in ((x, 0.1), (0, 0.1))]
    lines += ["v -0.01 0 0", "v 0.01 0 0", "v 0 0 2"]
    for leaf in range(LEAVES):
        first = 4 * leaf + 1
        corners = " ".join(str(first + i) for i in range(4))
        lines += [f"g leaf{leaf + 1:02}", f"f {corners}"]
    lines += [
        "g stalk",
        f"f {4 * LEAVES + 1} {4 * LEAVES + 2} {4 * LEAVES + 3}",
    ]
    Path(arguments[arguments.index("--to") + 1]).write_text("\n".join(lines))


if __name__ == "__main__":
    main()
