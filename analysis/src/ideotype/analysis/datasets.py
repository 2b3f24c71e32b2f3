# SPDX-License-Identifier: Apache-2.0
"""Reading from the open file, always what it holds at that moment."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
from numpy.typing import NDArray

from .file import HistoryError, open_file, text


class Datasets:
    """Datasets and root attributes of a history by their names, as format
    2.0 has them."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        self._file = open_file(path)
        self._axes: dict[str, dict[str, tuple[str, ...]]] = {}

    def __reduce__(self) -> tuple[type[Datasets], tuple[Path]]:
        """Another process opens the file for itself."""
        return type(self), (self.path,)

    def close(self) -> None:
        """Closes the file."""
        self._file.close()

    def attributes(self) -> dict[str, str | int | float]:
        """Root attributes: texts and single numbers."""
        found: dict[str, str | int | float] = {}
        for name, value in self._file.attrs.items():
            if isinstance(value, (bytes, str)):
                found[name] = text(value)
            elif isinstance(value, np.generic):
                found[name] = value.item()
        return found

    def names(self, group: str) -> list[str]:
        """The datasets of a group, its scales included."""
        return list(self._file[group])

    def axes(self, name: str) -> tuple[str, ...]:
        """Names of a dataset's dimensions, which are those of the scales
        beside it; of a scale its own."""
        group, _, dataset = name.rpartition("/")
        if group not in self._axes:
            # They never change, and to look them up takes a while.
            self._axes[group] = self._axes_of(group)
        try:
            return self._axes[group][dataset]
        except KeyError as error:
            raise HistoryError(f"{self.path}: has no {name}") from error

    def units(self, name: str) -> str:
        """The unit of a dataset."""
        return text(self._dataset(name).attrs.get("units", ""))

    def meaning(self, name: str) -> str:
        """What a dataset is, in words; "" if the file does not say."""
        return text(self._dataset(name).attrs.get("long_name", ""))

    def read(
        self,
        name: str,
        first: int = 0,
        last: int | None = None,
        columns: slice = slice(None),
    ) -> NDArray:
        """A dataset, or some of its rows and columns.

        Raises HistoryError."""
        dataset = self._dataset(name)
        try:
            # A live file changes, what was seen of it does not.
            dataset.refresh()
            if not dataset.shape:
                return dataset[...]
            return dataset[first:last, *[columns] * (dataset.ndim > 1)]
        except (OSError, RuntimeError) as error:
            raise HistoryError(
                f"{self.path}: {name} can't be read ({error})"
            ) from error

    def texts(self, name: str) -> tuple[str, ...]:
        """A dataset of strings."""
        return tuple(text(entry) for entry in self.read(name).ravel())

    def attribute_bytes(self, name: str) -> bytes:
        """The value of a root attribute as it stands in the file."""
        attribute = h5py.h5a.open(self._file.id, name.encode())
        value = np.empty(attribute.shape, attribute.dtype)
        attribute.read(value)
        return value.tobytes()

    def _axes_of(self, group: str) -> dict[str, tuple[str, ...]]:
        def address(dataset: h5py.Dataset) -> int:
            return h5py.h5o.get_info(dataset.id).addr

        try:
            datasets = dict(self._file[group])
            scales = {address(d): n for n, d in datasets.items() if d.is_scale}
            return {
                name: (name,)
                if dataset.is_scale
                else tuple(scales[address(axis[0])] for axis in dataset.dims)
                for name, dataset in datasets.items()
            }
        except (IndexError, KeyError, OSError, RuntimeError) as error:
            raise HistoryError(
                f"{self.path}: dimensions of /{group} have no scales ({error})"
            ) from error

    def _dataset(self, name: str) -> h5py.Dataset:
        try:
            found = self._file[name]
        except KeyError as error:
            raise HistoryError(f"{self.path}: has no {name}") from error
        if not isinstance(found, h5py.Dataset):
            raise HistoryError(f"{self.path}: has no {name}")
        return found
