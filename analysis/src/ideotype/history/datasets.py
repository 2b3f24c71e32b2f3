# SPDX-License-Identifier: Apache-2.0
"""Reads datasets and attributes of an open HDF5 file, which may be growing."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import h5py
import numpy as np
from numpy.typing import NDArray

from .file import HistoryError, open_file, text


class Datasets:
    """The datasets and root attributes of a history, by name."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        self._file = open_file(path)
        self._axes: dict[str, dict[str, tuple[str, ...]]] = {}
        self._about: dict[str, dict[str, str]] = {}
        self._open: dict[str, h5py.Dataset] = {}

    def __reduce__(self) -> tuple[type[Datasets], tuple[Path]]:
        """Pickles the path alone: a copy in another process reopens the
        file."""
        return type(self), (self.path,)

    def close(self) -> None:
        """Closes the file."""
        self._file.close()

    def attributes(self) -> dict[str, str | int | float]:
        """Returns the root attributes: texts and single numbers."""
        attributes: dict[str, str | int | float] = {}
        with self._reading("attributes"):
            for name, value in self._file.attrs.items():
                if isinstance(value, (bytes, str)):
                    attributes[name] = text(value)
                elif isinstance(value, np.generic):
                    attributes[name] = value.item()
        return attributes

    def names(self, group: str) -> list[str]:
        """Returns the names of the datasets of a group, including scales."""
        with self._reading(group):
            return list(self._file[group])

    def axes(self, name: str) -> tuple[str, ...]:
        """Returns the names of the dimensions of a dataset: those of the
        dimension scales in its group."""
        group, _, dataset = name.rpartition("/")
        if group not in self._axes:
            # Dimensions never change, and reading them is slow.
            self._axes[group] = self._read_axes(group)
        try:
            return self._axes[group][dataset]
        except KeyError as error:
            raise HistoryError(f"{self.path}: has no {name}") from error

    def about(self, name: str) -> dict[str, str]:
        """Returns the unit ("units") and description ("long_name") of a
        dataset."""
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
        """Returns a dataset, or its rows from `first` to before `last`.

        Raises HistoryError if it is missing or damaged."""
        with self._reading(name):
            dataset = self._dataset(name)
            # A live file changes, but recorded values in the file do not.
            dataset.refresh()
            values = dataset[slice(first, last) if dataset.shape else ...]
            # As in the program, any byte except 0 is true; numpy expects 0 or
            # 1.
            return values.view("i1") != 0 if values.dtype == bool else values

    def texts(self, name: str) -> tuple[str, ...]:
        """Returns a dataset of strings."""
        return tuple(text(entry) for entry in self.read(name).ravel())

    def attribute_bytes(self, name: str) -> bytes:
        """Returns the raw bytes of a root attribute."""
        with self._reading(f"attribute {name}"):
            attribute = h5py.h5a.open(self._file.id, name.encode())
            value = np.empty(attribute.shape, attribute.dtype)
            attribute.read(value)
            return value.tobytes()

    def _read_axes(self, group: str) -> dict[str, tuple[str, ...]]:
        def address(dataset: h5py.Dataset) -> int:
            return h5py.h5o.get_info(dataset.id).addr

        with self._reading(f"dimensions of /{group}"):
            datasets = dict(self._file[group])
            scales = {address(d): n for n, d in datasets.items() if d.is_scale}
            dimensions: dict[str, tuple[str, ...]] = {}
            for name, dataset in datasets.items():
                dimensions[name] = (
                    (name,)
                    if dataset.is_scale
                    else tuple(
                        scales.get(address(axis[0]), "") if len(axis) else ""
                        for axis in dataset.dims
                    )
                )
                # HDF5 has no checksums of references to scales.
                sizes = [
                    len(datasets[a]) if a else -1 for a in dimensions[name]
                ]
                if sizes != [*dataset.shape] or len({*dimensions[name]}) < len(
                    sizes
                ):
                    raise HistoryError(
                        f"{self.path}: dimensions of /{group}/{name} have no "
                        "scales, or not theirs"
                    )
        return dimensions

    def _dataset(self, name: str) -> h5py.Dataset:
        if name not in self._open:
            dataset = self._file[name]
            if not isinstance(dataset, h5py.Dataset):
                raise HistoryError(f"{self.path}: has no {name}")
            self._open[name] = dataset
        return self._open[name]

    @contextmanager
    def _reading(self, name: str) -> Iterator[None]:
        """Converts exceptions of h5py to HistoryError; for damaged files they
        may have any type."""
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
