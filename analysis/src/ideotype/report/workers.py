# SPDX-License-Identifier: Apache-2.0
"""Distributes work over all cores."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import Any

_TOGETHER = 8
"""The number of arguments that a process gets at once, which may share data
such as an open history; a process gets fewer if other processes would be
idle."""

Map = Callable[[Callable[[Any], Any], Iterable[Any]], Iterable[Any]]


@contextmanager
def start_workers(count: int) -> Iterator[Map]:
    """Returns a map() by the given number of processes, with results in the
    order of arguments; for one process the function returns map() itself.

    Raises OSError if a process is killed."""
    if count < 2:
        yield map
        return
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["ideotype.report.report"])
    pool = ProcessPoolExecutor(count, mp_context=context)

    def run(work: Callable[[Any], Any], arguments: Iterable[Any]) -> Any:
        every = list(arguments)
        together = min(_TOGETHER, len(every) // (4 * count))
        return pool.map(work, every, chunksize=max(together, 1))

    try:
        yield run
    except BrokenProcessPool as error:
        raise OSError(
            "a process that draws figures was killed (out of memory?); try "
            "with fewer, --jobs 1"
        ) from error
    finally:
        pool.shutdown(cancel_futures=True)
