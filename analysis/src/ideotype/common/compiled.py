# SPDX-License-Identifier: Apache-2.0
"""The compiled module, or an error that says that it is missing."""

from ..errors import NotCompiled

try:
    import ideotype._core as _core
except ModuleNotFoundError as error:
    if error.name != "ideotype._core":
        raise
    raise NotCompiled(
        "this needs the compiled module, which the installation lacks (it can "
        "only read and report); install a wheel of this system, or build it "
        "with pip install and without IDEOTYPE_PURE_PYTHON"
    ) from error

__all__ = ["_core"]
