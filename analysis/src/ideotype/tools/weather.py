# SPDX-License-Identifier: Apache-2.0
"""The command `ideotype weather`: converts weather files of many formats to
the format of the program, and checks the result."""

from __future__ import annotations

import argparse
import sys
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pandas as pd

from ..common.output import REFUSED, OutputRefused, require_output, write_file
from ..errors import Error, printable_lines
from .meteo.checks import check_clock, find_place, mend
from .meteo.formats import FORMATS, read
from .meteo.tables import COLUMNS, Readings

_HOUR = pd.Timedelta("1h")
_LIGHT = ["global", "beam_normal", "diffuse"]


def main(arguments: Sequence[str] | None = None) -> int:
    """Converts files and returns the exit code: 0, 1 after a failure, 2 for a
    wrong command line, 3 for implausible or unreadable files, 4 for an output
    that is a symbolic link."""
    parser = argparse.ArgumentParser(
        prog="ideotype weather",
        description="Converts weather files to the CSV format of campaigns, and "
        "checks clock, location and gaps.",
    )
    add = parser.add_argument
    add(
        "files",
        nargs="+",
        type=Path,
        metavar="FILE",
        help="files of one station",
    )
    add("--to", type=Path, required=True, metavar="FILE", help="CSV to write")
    add("--format", default="auto", choices=["auto", *FORMATS])
    add("--latitude", type=float, metavar="DEG", help="latitude of the site")
    add("--longitude", type=float, metavar="DEG", help="longitude of the site")
    add(
        "--utc-offset",
        type=float,
        metavar="HOURS",
        help="UTC offset of the output, if the clock of the files, such as UTC, "
        "differs from solar time by more than 3 hours (default: by the "
        "longitude)",
    )
    add("--from", dest="first", type=pd.Timestamp, metavar="DATE")
    add("--until", type=pd.Timestamp, metavar="DATE", help="last day")
    add(
        "--step",
        type=int,
        metavar="MINUTES",
        help="time step of the output (default: that of the files; 60 if it is "
        "below 5 or irregular)",
    )
    add(
        "--fill",
        type=float,
        default=0,
        metavar="HOURS",
        help="interpolate gaps up to this length",
    )
    options = parser.parse_args(arguments)

    def warn(message: object) -> None:
        text = f"ideotype weather: {message}"
        print(printable_lines(text), file=sys.stderr)

    try:
        import pvlib  # noqa: F401
    except ImportError:
        warn(
            "pvlib, which reads weather files, is not installed; run "
            "pip install 'pvlib>=0.13'"
        )
        return 1
    try:
        with warnings.catch_warnings():
            # The warnings of readers are for programmers.
            warnings.simplefilter("ignore")
            require_output(options.to)
            print(_convert(options, warn))
    except OutputRefused as error:
        warn(error)
        return REFUSED
    except Error as error:
        warn(error)
        return 3
    except OSError as error:
        warn(error)
        return 1
    return 0


def _convert(options: argparse.Namespace, warn: Any) -> str:
    sources = [_read(path, options.format) for path in options.files]
    place = find_place(options, [x.place for x in sources], warn)
    frame, step = _joined(sources, options.step, warn)
    offset = sources[0].utc_offset
    ahead = (offset - place[1] / 15 + 12) % 24 - 12
    if abs(ahead) > 3:
        by_sun = round(place[1] / 15)
        wanted = by_sun if options.utc_offset is None else options.utc_offset
        frame.index += (wanted - offset) * _HOUR
        offset = wanted
    if sources[0].is_typical:
        frame = _with_years(frame, options.first, options.until)
    begin = options.first or frame.index[0].normalize()
    end = (options.until or frame.index[-1].normalize()) + pd.Timedelta("1D")
    frame = frame[(frame.index >= begin) & (frame.index < end)]
    if not len(frame):
        raise Error(
            "the files have no data of this period; leave out --from and "
            "--until to see their period"
        )
    frame = frame.reindex(
        pd.date_range(frame.index[0], frame.index[-1], freq=step)
    )
    leap = (frame.index.month == 2) & (frame.index.day == 29)
    if not frame[leap].notna().any(axis=None):
        frame = frame[~leap]
    check_clock(frame, offset, place, warn)
    mend(frame, step, offset, place, options.fill, warn)
    return _write(options, frame, step, offset, place)


def _read(path: Path, form: str) -> Readings:
    try:
        return read(path, form)
    except (
        ValueError,
        TypeError,
        KeyError,
        IndexError,
        StopIteration,
    ) as error:
        reason = f"{type(error).__name__}: {error}".splitlines()[0]
        raise Error(
            f"{path}: cannot be read ({reason}); check the format, or name it "
            "with --format"
        ) from error


def _joined(
    sources: list[Readings], minutes: int | None, warn: Any
) -> tuple[pd.DataFrame, pd.Timedelta]:
    """Joins files of successive periods or with different columns, on the
    clock of the first file. Returns a table indexed by the middles of time
    steps, and the step."""
    groups: dict[tuple, list[Readings]] = {}
    for source in sources:
        shift = sources[0].utc_offset - source.utc_offset
        source.frame.index += shift * _HOUR
        groups.setdefault((*source.frame, source.stamp), []).append(source)
    joined, steps = [], []
    for group in groups.values():
        frame = pd.concat([x.frame for x in group]).sort_index(kind="stable")
        twice = frame.index.duplicated()
        if twice.any():
            warn(
                f"warning: {twice.sum()} rows repeat the time of another, first "
                f"at {frame.index[twice][0]}; the first row of each time counts"
            )
        frame = frame[~twice]
        if len(frame) < 2:
            raise Error(
                "a file has fewer than two times, so the time step is unknown; "
                "check --format"
            )
        step = frame.index.to_series().diff().mode().iloc[0]
        if not pd.Timedelta("1min") <= step <= _HOUR:
            raise Error(
                f"the time step is {step}; give files with steps from 1 minute "
                "to 1 hour"
            )
        parts = {"beginning": 0, "middle": 0.5, "end": 1}
        frame.index -= parts[group[0].stamp] * step
        is_regular = ((frame.index - frame.index[0]) % step == 0 * step).all()
        wanted = pd.Timedelta(minutes or 0, "min")
        if not minutes:
            usual = is_regular and step >= pd.Timedelta("5min")
            wanted = step if usual else _HOUR
        if not is_regular or wanted != step:
            frame = _means(frame, step, wanted, is_regular)
        frame.index += wanted / 2
        joined.append(frame)
        steps.append(wanted)
    whole = joined[0]
    for frame in joined[1:]:
        whole = whole.combine_first(frame)
    if len(set(steps)) > 1:
        raise Error("the files have different time steps; give --step 60")
    # Time steps before the first and after the last value of light are
    # omitted.
    light = (
        whole[[name for name in _LIGHT if name in whole]].notna().any(axis=1)
    )
    if not light.any():
        raise Error(
            "no file has light; give one with global light, or with "
            "beam and diffuse light"
        )
    return whole[light.idxmax() : light[::-1].idxmax()], steps[0]


def _means(
    frame: pd.DataFrame, step: Any, wanted: Any, is_regular: bool
) -> pd.DataFrame:
    """Returns means over longer or shifted time steps, weighted by minutes;
    three quarters of each step must be known."""
    if not is_regular or step > wanted:
        minute = pd.Timedelta("1min")
        frame = frame.resample("1min").ffill(limit=step // minute - 1)
        step = minute
    groups = frame.resample(wanted)
    return groups.mean().where(groups.count() * step >= 0.75 * wanted)


def _with_years(frame: pd.DataFrame, first: Any, until: Any) -> pd.DataFrame:
    """Returns the rows of a typical year with the dates of a period, by
    default of the year of the first row."""
    index = frame.index
    first = first or pd.Timestamp(index[0].year, 1, 1)
    until = until or pd.Timestamp(first.year, 12, 31)
    if until - first >= pd.Timedelta("366D"):
        raise Error(
            "the period is longer than the typical year of the file; choose "
            "one of up to 365 days"
        )
    parts = []
    for year in range(first.year, until.year + 1):
        date = pd.DataFrame(
            {"year": year, "month": index.month, "day": index.day}
        )
        days = pd.DatetimeIndex(pd.to_datetime(date, errors="coerce"))
        part = frame.set_axis(days + (index - index.normalize()))
        parts.append(part[part.index.notna()])
    joined = pd.concat(parts).sort_index()
    return joined[~joined.index.duplicated()]


def _write(
    options: argparse.Namespace,
    frame: pd.DataFrame,
    step: Any,
    offset: float,
    place: tuple[float, float],
) -> str:
    """Writes the file and returns a message with the tables of a campaign."""
    zone = f"{'-' if offset < 0 else '+'}{int(abs(offset)):02}:" + (
        f"{round(abs(offset) % 1 * 60):02}"
    )
    names = ", ".join(path.name for path in options.files)
    head = (
        f"# made by ideotype weather from {names}: middles of time steps, "
        f"W m-2, deg C, %\n# latitude {place[0]:.6g}, longitude {place[1]:.6g}\n"
    )
    # The program refuses gaps in these columns, but not in rain.
    air = [name for name in COLUMNS[5:-1] if name in frame]
    table = frame[
        [
            name
            for name in COLUMNS
            if name in frame and (name not in air or frame[name].notna().all())
        ]
    ]
    times = table.index.strftime("%Y-%m-%dT%H:%M:%S") + zone
    text = head + table.set_axis(times).to_csv(index_label="time")
    write_file(options.to, text)
    first, last = frame.index[0].date(), frame.index[-1].date()
    return (
        f"{options.to}: {len(table)} steps of {step / _HOUR * 60:.4g} min\n"
        f'In a campaign of the same folder:\n\n[[site]]\nname = "mine"\n'
        f"latitude = {place[0]:.6g}\nlongitude = {place[1]:.6g}\n"
        f"utc_offset = {offset:g}\n\n[[climate]]\n"
        f'file = "{options.to.name}"\nfrom = {first}\nto = {last}'
    )


if __name__ == "__main__":
    sys.exit(main())
