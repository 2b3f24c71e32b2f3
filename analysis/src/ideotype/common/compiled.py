# SPDX-License-Identifier: Apache-2.0
"""The compiled module. Raises NotCompiled if the installation lacks it."""

from ..errors import NotCompiled

try:
    import ideotype._core as _core
except ModuleNotFoundError as error:
    if error.name != "ideotype._core":
        raise
    raise NotCompiled(
        "this needs the compiled module, which the installation lacks (it can "
        "only read and report); install a wheel for this system, or build it "
        "by pip install without IDEOTYPE_PURE_PYTHON"
    ) from error

__all__ = ["_core"]
