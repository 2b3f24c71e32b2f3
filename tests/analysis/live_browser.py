# SPDX-License-Identifier: Apache-2.0
"""Operates live pages in a browser like a user."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path
from typing import Any

from live_page import Served
from phone import HEIGHT, Phone, phone_with

WIDTHS = (1280, 390)


@contextlib.contextmanager
def shown(
    page: Served | str, folder: Path, width: int = 1280
) -> Iterator[Phone]:
    """Opens a live page and waits for its first numbers; scripts must not
    fail."""
    address = page if isinstance(page, str) else page.address
    height = 800 if width > 1000 else HEIGHT
    with phone_with(address, folder, width, height) as phone:
        settle(phone)
        yield phone
        assert not phone.errors, phone.errors


def settle(phone: Phone) -> None:
    """Waits until all requests are answered and numbers are refined."""
    phone.wait(
        "document.body.dataset.cases || (typeof page !== 'undefined' && "
        "page.number > 0 && document.body.dataset.final === 'true' && "
        "Number(document.body.dataset.number) === page.number)",
        120,
    )


def move(phone: Phone, slider: str, part: float) -> None:
    """Drags a slider to a fraction of its range, from 0 to 1."""
    phone.value(
        f"""(() => {{
          const s = byId("s-{slider}");
          const [low, high] = [Number(s.min), Number(s.max)];
          s.dispatchEvent(new PointerEvent("pointerdown"));
          s.value = low + {part} * (high - low);
          s.dispatchEvent(new Event("input"));
        }})()"""
    )
    settle(phone)


def click(phone: Phone, selector: str) -> None:
    """Clicks the element that matches a selector; a hidden element cannot be
    clicked."""
    found = f"document.querySelector({json.dumps(selector)})"
    assert phone.value(f"{found}.getClientRects().length > 0"), selector
    phone.value(f"{found}.click()")


def text(phone: Phone, selector: str) -> str:
    """Returns the visible text of an element."""
    found = f"document.querySelector({json.dumps(selector)})"
    return str(phone.value(f"{found}.innerText"))


def number(phone: Phone, name: str) -> list[float]:
    """Returns a number of the page and its standard error."""
    found = phone.value(f"field.numbers.numbers[{json.dumps(name)}]")
    assert isinstance(found, list)
    return found


def view(phone: Phone) -> str:
    """Returns the picture of the plants after the page has drawn it."""
    phone.value("new Promise((done) => requestAnimationFrame(() => "
                "requestAnimationFrame(done)))")  # fmt: skip
    return str(phone.value("byId('view').toDataURL()"))


def bare(phone: Phone) -> float:
    """Returns the fraction of the picture that has the colour of its
    corner."""
    return float(
        phone.value(
            """(() => {
              const view = byId("view");
              const { data } = view.getContext("2d")
                .getImageData(0, 0, view.width, view.height);
              let same = 0;
              for (let i = 0; i < data.length; i += 4)
                same += [0, 1, 2].every((k) => data[i + k] === data[k]);
              return same * 4 / data.length;
            })()"""
        )
    )


def fits(phone: Phone) -> bool:
    """Returns whether no element is wider than the screen."""
    return bool(
        phone.value("document.documentElement.scrollWidth <= innerWidth")
    )


def serious_findings(phone: Phone) -> list[dict[str, Any]]:
    """Returns the serious and critical findings of axe, with rules and
    elements."""
    script = files("axe_core_python").joinpath("axe.min.js").read_text("utf-8")
    phone.value(f"{script}; undefined")
    found = phone.value(
        """axe.run().then(({ violations, passes }) => ({ passes: passes.length,
          found: violations
            .filter((v) => ["serious", "critical"].includes(v.impact))
            .map((v) => ({ rule: v.id, nodes: v.nodes.map((n) =>
              n.html.slice(0, 120) + " " + n.failureSummary) })) }))"""
    )
    assert found["passes"] > 10, "axe has looked at nothing"
    return list(found["found"])


def memory(phone: Phone) -> dict[str, float]:
    """Returns the memory use of the page after garbage collection: the heap of
    scripts [bytes], the number of elements and of event listeners."""
    phone.ask("Performance.enable")
    phone.ask("HeapProfiler.collectGarbage")
    metrics = phone.ask("Performance.getMetrics")["metrics"]
    found = {each["name"]: each["value"] for each in metrics}
    return {
        name: found[name]
        for name in ("JSHeapUsedSize", "Nodes", "JSEventListeners")
    }
