#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flips single bits of histories and looks at what every reader makes of it.

    flip.py IDEOTYPE [FLIPS=300] [SEED=1]
    flip.py IDEOTYPE metadata [EVERY=1]

The second flips every bit, or one of EVERY, of what describes the data of a small
history, closed and marked as open, and opens each as arrays.

The first runs a small campaign to its end, and another until it is killed. A third of the
flips is in the finished history, a third in the killed one, a third in the
killed one while its lock is held, so that it looks live. Every second flip is in
a byte that is not zero. Each copy is read by the program (status, verify,
export, evaluate, compare, run --resume) and by this Python (arrays, frame,
what a report reads, with the table of ideotype summary), each within a minute. A flip is

    noticed       the reader fails, and says why
    harmless      it says what it says of the whole file
    no checksum   it says something else, where FORMAT.md promises no checksum:
                  times, sessions, messages, generations that are not complete
    silent        it says something else
    hanging       it does not end
    crashing      it is killed, or fails in another way

Both fail unless the last three are 0."""

from __future__ import annotations

import collections
import fcntl
import json
import multiprocessing
import os
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import h5py

sys.path.insert(0, str(Path(__file__).parents[1] / "analysis"))
from flipped_bits import OPEN, flip, marked, metadata

import ideotype
from ideotype.history import HistoryError, open_history, open_study
from ideotype.report.provenance import tabulate_provenance
from ideotype.report.tables import tabulate_gains

LIMIT = 60  # The longest time that a reader may take [s].
CAMPAIGN = Path(__file__).parents[2] / "campaigns" / "ames_quick.toml"
SMALL = {
    "search.population": 6,
    "field.rows": 2,
    "field.plants": 2,
    "light.tolerance": 0,
    "light.paths": 256,
    "final.paths": 256,
    "final.candidates": 2,
}
KINDS = ("noticed", "harmless", "no checksum", "silent", "hanging", "crashing")
GROUPS = ("evaluations", "final", "generations", "genes", "objectives")

Said = tuple[str, str]
"""The kind of the end (noticed, hanging, crashing, or read), and all that was
said."""


class Place:
    """A folder that contains the history under test."""

    def __init__(self, program: str, folder: Path, generations: int) -> None:
        self.program = program
        self.folder = folder
        settings = SMALL | {"stop.generations": generations}
        words = [f"{key}={value}" for key, value in settings.items()]
        self.campaign = [str(CAMPAIGN)]
        for word in words:
            self.campaign += ["--set", word]

    @property
    def path(self) -> Path:
        """The path of the history."""
        (path,) = self.folder.glob("*/*.h5")
        return path

    def run(self, *words: str) -> list[str]:
        """Returns the command that runs the campaign in this folder."""
        return [
            self.program,
            "run",
            *self.campaign,
            "--out",
            str(self.folder),
            *words,
        ]


def finished(program: str, folder: Path) -> Place:
    place = Place(program, folder, 4)
    subprocess.run(place.run(), check=True, capture_output=True)
    return place


def killed(program: str, folder: Path) -> Place:
    place = Place(program, folder, 12)
    process = subprocess.Popen(
        place.run(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    complete = 0
    while complete < 3:
        if process.poll() is not None:
            sys.exit("the run ended before it could be killed")
        time.sleep(0.01)
        if found := [*folder.glob("*/*.h5")]:
            with open_history(found[0]) as history:
                complete = len(history.generations())
    process.send_signal(signal.SIGKILL)
    process.wait()
    return place


def said(command: list[str], without: str = "") -> Said:
    """Returns the output of the program, without lines that match
    `without`."""
    try:
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
            timeout=LIMIT,
        )
    except subprocess.TimeoutExpired:
        return "hanging", ""
    if done.returncode < 0 or done.returncode > 5:
        return "crashing", done.stderr
    if done.returncode != 0:
        return "noticed", done.stderr
    lines = done.stdout.splitlines()
    kept = [x for x in lines if not (without and re.search(without, x))]
    return "read", "\n".join(kept)


def exported(place: Place, *words: str) -> Said:
    table = place.folder / words[-1]
    table.unlink(missing_ok=True)
    command = [place.program, "export", str(place.path), *words[:-1]]
    kind, text = said([*command, "--to", str(table)])
    return (kind, table.read_text()) if kind == "read" else (kind, text)


def resumed(place: Place) -> Said:
    kind, text = said(place.run("--resume"))
    if kind != "read":
        return kind, text
    kind, text = exported(place, "--generations", "resumed.csv")
    again = exported(place, "--best", "resumed.toml")
    return max(kind, again[0]), text + again[1]


PROGRAMS: dict[str, Callable[[Place], Said]] = {
    "status": lambda p: said([p.program, "status", str(p.path)]),
    "verify": lambda p: said([p.program, "verify", str(p.path)]),
    "export --generations": lambda p: exported(p, "--generations", "a.csv"),
    "export --best": lambda p: exported(p, "--best", "a.toml"),
    "evaluate --best": lambda p: said(
        [p.program, "evaluate", str(p.path), "--best", "--json"], "seconds"
    ),
    "compare": lambda p: said(
        [p.program, "compare", str(p.path), "--under", *p.campaign, "--json"]
    ),
    "run --resume": resumed,
}


def arrays(path: Path) -> str:
    datasets = [ideotype.open(path, group) for group in GROUPS]
    return "".join(
        f"{name} {array.dims} {array.attrs} {array.values.tolist()}"
        for group in datasets
        for name, array in group.variables.items()
    )


def frame(path: Path) -> str:
    with open_study(path) as study:
        return study.frame().to_csv()


def report(path: Path) -> str:
    with open_study(path) as study:
        cases = study.cases()
        return f"{tabulate_gains(cases, None)} {tabulate_provenance(cases)}"


PYTHON = {
    "open": arrays,
    "frame": frame,
    "ideotype report": report,
}


def serve(parent: multiprocessing.connection.Connection) -> None:
    while True:
        name, path = parent.recv()
        try:
            parent.send(("read", PYTHON[name](path)))
        except (HistoryError, OSError) as error:
            parent.send(("noticed", str(error)))
        except Exception as error:
            parent.send(("crashing", repr(error)))


class Readers:
    """All readers. Those in Python run in a separate process."""

    def __init__(self) -> None:
        self._start()

    def _start(self) -> None:
        self._answers, theirs = multiprocessing.Pipe()
        self._process = multiprocessing.Process(
            target=serve, args=(theirs,), daemon=True
        )
        self._process.start()
        theirs.close()

    def python(self, name: str, path: Path) -> Said:
        self._answers.send((name, path))
        kind = "hanging"
        try:
            if self._answers.poll(LIMIT):
                return self._answers.recv()
        except EOFError:
            kind = "crashing"
        self._process.kill()
        self._process.join()
        self._start()
        return kind, ""

    def read(self, place: Place, content: bytes) -> dict[str, Said]:
        """Writes the content to the history and returns the answer of each
        reader."""
        path = place.path
        arrays = {}
        for name in (*PYTHON, *PROGRAMS):
            with path.open("r+b") as file:
                file.write(content)
                file.truncate()
            arrays[name] = (
                self.python(name, path)
                if name in PYTHON
                else PROGRAMS[name](place)
            )
        return arrays


def without_checksum(path: Path) -> list[range]:
    """Returns the positions of the bytes of a history that no checksum
    covers."""
    ranges = []
    with open_history(path) as history:
        generations = history.generations()
        first = int(generations.count.sum())
        complete = len(generations)

    def look(name: str, dataset: object) -> None:
        if not isinstance(dataset, h5py.Dataset):
            return
        start, size = dataset.id.get_offset(), dataset.id.get_storage_size()
        group = name.split("/")[0]
        if group in ("state", "sessions", "messages"):
            ranges.append(range(start, start + size))
        for table, row in (("evaluations", first), ("generations", complete)):
            if group == table and dataset.shape[0] > row:
                at = start + size // dataset.shape[0] * row
                ranges.append(range(at, start + size))

    with h5py.File(
        path, "r", swmr=True, libver="latest", locking=False
    ) as file:
        file.visititems(look)
    return ranges


def look(
    state: str, place: Place, flips: int, chosen: random.Random
) -> collections.Counter[tuple[str, str, str]]:
    """Counts kinds of answers by state and reader."""
    readers = Readers()
    content = place.path.read_bytes()
    unprotected = without_checksum(place.path)
    used = [i for i, byte in enumerate(content) if byte]
    whole = readers.read(place, content)
    # A reader that refuses a live file gives no information about its content.
    names = [name for name in whole if whole[name][0] == "read"]
    counts: collections.Counter[tuple[str, str, str]] = collections.Counter()
    for number in range(flips):
        byte = (
            chosen.choice(used)
            if number % 2
            else chosen.randrange(len(content))
        )
        bit = 8 * byte + chosen.randrange(8)
        found = readers.read(place, flip(content, bit))
        for name in names:
            kind, text = found[name]
            if kind == "read":
                kind = "harmless"
                if text != whole[name][1]:
                    has_none = any(byte in each for each in unprotected)
                    kind = "no checksum" if has_none else "silent"
            counts[state, name, kind] += 1
            if kind in KINDS[3:]:
                print(
                    f"{state}, bit {bit}: {name} is {kind}",
                    text[:200] if kind == "crashing" else "",
                    flush=True,
                )
    return counts


def look_at_metadata(program: str, every: int) -> int:
    readers = Readers()
    wrong = 0
    with tempfile.TemporaryDirectory() as name:
        path = finished(program, Path(name)).path
        original = path.read_bytes()
        bits = metadata(path)[::every]
        for state, marks in (("closed", 0), ("open", OPEN)):
            content = marked(original, marks)
            path.write_bytes(content)
            whole = readers.python("open", path)
            counts: collections.Counter[str] = collections.Counter()
            for bit in bits:
                path.write_bytes(flip(content, int(bit)))
                kind, text = readers.python("open", path)
                if kind == "read":
                    kind = "harmless" if (kind, text) == whole else "silent"
                counts[kind] += 1
                if kind in KINDS[3:]:
                    print(
                        f"{state}, bit {bit}: {kind} {text[:200]}", flush=True
                    )
            print(f"{state}: {len(bits)} bits, {dict(counts)}", flush=True)
            wrong += sum(counts[kind] for kind in KINDS[3:])
    return min(wrong, 1)


def main() -> int:
    program = os.path.abspath(sys.argv[1])
    if sys.argv[2:3] == ["metadata"]:
        every = int(sys.argv[3]) if len(sys.argv) > 3 else 1
        return look_at_metadata(program, every)
    flips = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    chosen = random.Random(seed)
    counts: collections.Counter[tuple[str, str, str]] = collections.Counter()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for state, make in (
            ("finished", finished),
            ("killed", killed),
            ("live", killed),
        ):
            place = make(program, folder / state)
            locks = []
            if state == "live":
                locks.append(place.path.open("r+b"))
                whole = (fcntl.F_WRLCK, os.SEEK_SET, 0, 0, 0)
                # The bytes are those of struct flock.
                lock = struct.pack("hhqqi4x", *whole)
                fcntl.fcntl(locks[-1], fcntl.F_OFD_SETLK, lock)
            counts += look(state, place, flips // 3, chosen)
    print(f"{flips // 3} flips in each state (seed {seed})")
    print(f"{'state':<10}{'reader':<22}", *(f"{kind:>12}" for kind in KINDS))
    for state, name in dict.fromkeys(key[:2] for key in counts):
        numbers = (f"{counts[state, name, kind]:>12}" for kind in KINDS)
        print(f"{state:<10}{name:<22}", *numbers)
    total = {
        k: sum(n for key, n in counts.items() if key[2] == k) for k in KINDS
    }
    print(json.dumps(total))
    return 1 if any(total[kind] for kind in KINDS[3:]) else 0


if __name__ == "__main__":
    sys.exit(main())
