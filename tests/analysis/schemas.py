# SPDX-License-Identifier: Apache-2.0
"""Checks JSON documents of the program against their schemas."""

from __future__ import annotations

import json
from importlib import resources
from typing import Any

from jsonschema import Draft202012Validator


def validator(name: str) -> Draft202012Validator:
    """Returns the validator of NAME.schema.json in the package."""
    path = resources.files("ideotype") / "schemas" / f"{name}.schema.json"
    schema: dict[str, Any] = json.loads(path.read_text())
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema)


def assert_needs_all(name: str, document: dict[str, Any]) -> None:
    """Asserts that the document is valid, and that it becomes invalid if any
    member is missing, of another type, or unknown."""
    checked = validator(name)
    checked.validate(document)
    for key in document:
        rest = {k: v for k, v in document.items() if k != key}
        assert not checked.is_valid(rest), key
        # A client may choose any value for `id`.
        changed = {**document, key: object()}
        assert key == "id" or not checked.is_valid(changed), key
    assert not checked.is_valid({**document, "other": 1})
