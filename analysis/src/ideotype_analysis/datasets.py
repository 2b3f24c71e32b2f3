"""Reading from the open file, always what it holds at that moment."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
from numpy.typing import NDArray

from .file import HistoryError, open_file, text


class Datasets:
    """The datasets and root attributes of a history by their names."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)
        self._file = open_file(path)

    def __reduce__(self) -> tuple[type[Datasets], tuple[Path]]:
        """Another process opens the file for itself."""
        return Datasets, (self.path,)

    def close(self) -> None:
        """Lets go of the file."""
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

    def read(
        self, name: str, first: int = 0, last: int | None = None
    ) -> NDArray:
        """A dataset or some of its rows.

        Raises HistoryError."""
        try:
            dataset = self._file[name]
            if not isinstance(dataset, h5py.Dataset):
                raise KeyError(name)
            # A live file moves on, what was seen of it does not.
            dataset.refresh()
            return dataset[first:last] if dataset.shape else dataset[()]
        except KeyError as error:
            raise HistoryError(f"{self.path}: has no {name}") from error
        except (OSError, RuntimeError) as error:
            raise HistoryError(
                f"{self.path}: {name} can't be read ({error})"
            ) from error

    def texts(self, name: str) -> tuple[str, ...]:
        """A dataset of strings."""
        return tuple(text(entry) for entry in self.read(name))
