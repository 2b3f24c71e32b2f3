# SPDX-License-Identifier: Apache-2.0
"""Reads the present contents of an open file."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import h5py
import numpy as np
from numpy.typing import NDArray

from .file import HistoryError, open_file, text


class Datasets:
    """The datasets and root attributes of a history by name."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        self._file = open_file(path)
        self._axes: dict[str, dict[str, tuple[str, ...]]] = {}
        self._about: dict[str, dict[str, str]] = {}
        self._open: dict[str, h5py.Dataset] = {}

    def __reduce__(self) -> tuple[type[Datasets], tuple[Path]]:
        """Makes a copy in another process open the file again."""
        return type(self), (self.path,)

    def close(self) -> None:
        """Closes the file."""
        self._file.close()

    def attributes(self) -> dict[str, str | int | float]:
        """Returns the root attributes: texts and single numbers."""
        found: dict[str, str | int | float] = {}
        with self._reading("attributes"):
            for name, value in self._file.attrs.items():
                if isinstance(value, (bytes, str)):
                    found[name] = text(value)
                elif isinstance(value, np.generic):
                    found[name] = value.item()
        return found

    def names(self, group: str) -> list[str]:
        """Returns the names of the datasets of a group, its scales
        included."""
        with self._reading(group):
            return list(self._file[group])

    def axes(self, name: str) -> tuple[str, ...]:
        """Returns the names of a dataset's dimensions, which are the names of
        the scales in its group; the dimension of a scale has the name of the
        scale."""
        group, _, dataset = name.rpartition("/")
        if group not in self._axes:
            # Dimensions never change, and looking them up takes long.
            self._axes[group] = self._axes_of(group)
        try:
            return self._axes[group][dataset]
        except KeyError as error:
            raise HistoryError(f"{self.path}: has no {name}") from error

    def about(self, name: str) -> dict[str, str]:
        """Returns a dataset's unit, as "units", and description, as
        "long_name"."""
        if name not in self._about:
            # Units and descriptions never change.
            with self._reading(name):
                known = dict(self._dataset(name).attrs)
                self._about[name] = {
                    key: text(known[key])
                    for key in ("units", "long_name")
                    if key in known
                }
        return dict(self._about[name])

    def read(
        self, name: str, first: int = 0, last: int | None = None
    ) -> NDArray:
        """Returns a dataset, or some of its rows.

        Raises HistoryError."""
        with self._reading(name):
            dataset = self._dataset(name)
            # A live file changes, but recorded values in the file do not.
            dataset.refresh()
            values = dataset[slice(first, last) if dataset.shape else ...]
            # Any byte except 0 is true, as in the program; numpy takes only 1
            # as true.
            return values.view("i1") != 0 if values.dtype == bool else values

    def texts(self, name: str) -> tuple[str, ...]:
        """Returns a dataset of strings."""
        return tuple(text(entry) for entry in self.read(name).ravel())

    def attribute_bytes(self, name: str) -> bytes:
        """Returns the bytes of a root attribute in the file."""
        with self._reading(f"attribute {name}"):
            attribute = h5py.h5a.open(self._file.id, name.encode())
            value = np.empty(attribute.shape, attribute.dtype)
            attribute.read(value)
            return value.tobytes()

    def _axes_of(self, group: str) -> dict[str, tuple[str, ...]]:
        def address(dataset: h5py.Dataset) -> int:
            return h5py.h5o.get_info(dataset.id).addr

        with self._reading(f"dimensions of /{group}"):
            datasets = dict(self._file[group])
            scales = {address(d): n for n, d in datasets.items() if d.is_scale}
            found: dict[str, tuple[str, ...]] = {}
            for name, dataset in datasets.items():
                found[name] = (
                    (name,)
                    if dataset.is_scale
                    else tuple(
                        scales.get(address(axis[0]), "") if len(axis) else ""
                        for axis in dataset.dims
                    )
                )
                # HDF5 has no checksums of references to scales.
                sizes = [len(datasets[a]) if a else -1 for a in found[name]]
                if sizes != [*dataset.shape] or len({*found[name]}) < len(
                    sizes
                ):
                    raise HistoryError(
                        f"{self.path}: dimensions of /{group}/{name} have no "
                        "scales, or not theirs"
                    )
        return found

    def _dataset(self, name: str) -> h5py.Dataset:
        if name not in self._open:
            found = self._file[name]
            if not isinstance(found, h5py.Dataset):
                raise HistoryError(f"{self.path}: has no {name}")
            self._open[name] = found
        return self._open[name]

    @contextmanager
    def _reading(self, name: str) -> Iterator[None]:
        """Turns exceptions of h5py, which may have any type in a damaged file,
        into a HistoryError."""
        try:
            yield
        except HistoryError:
            raise
        except Exception as error:
            if isinstance(error, KeyError) and "doesn't exist" in str(error):
                raise HistoryError(f"{self.path}: has no {name}") from error
            raise HistoryError(
                f"{self.path}: {name} can't be read ({error})"
            ) from error
