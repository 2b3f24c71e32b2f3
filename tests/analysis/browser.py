# SPDX-License-Identifier: Apache-2.0
"""Shows a page in a real browser: Chromium, without a window or a network."""

from __future__ import annotations

import html
import json
import os
import re
import shutil
import signal
import subprocess
from pathlib import Path
from typing import Any

import pytest

_TIMEOUT = 120
NAMES = ("chromium", "chromium-browser", "google-chrome")
OPTIONS = [
    *("--headless", "--no-sandbox", "--disable-gpu", "--no-first-run"),
    *("--disable-dev-shm-usage", "--disable-background-networking"),
    *(
        "--disable-component-update",
        "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1",
    ),
]
"""Options for Chromium without a window, and without a network beyond this
machine."""

_EARLY = """<script>
const failures = [];
addEventListener("error", (event) => failures.push(event.message));
addEventListener("securitypolicyviolation",
  (event) => failures.push(event.violatedDirective + event.blockedURI));
</script>"""

_LATE = """<script>
addEventListener("load", () => {
  const result = (() => { %s })();
  document.body.dataset.result = JSON.stringify({ failures, result });
});
</script>"""


def run_in_browser(
    page: Path, script: str, folder: Path, width: int = 1000
) -> tuple[Any, list]:
    """Runs a script, the body of a function, in the loaded page. Returns its
    result, and all errors of scripts, of the console, and of refused
    requests."""
    name = next(filter(shutil.which, NAMES), None)
    if name is None:
        pytest.fail(
            f"no browser: install one of {', '.join(NAMES)} "
            "(./test.sh does, with apt-get)"
        )
    text = page.read_text(encoding="utf-8")
    assert text.count("<head>") == text.count("</body>") == 1
    text = text.replace("<head>", "<head>" + _EARLY)
    text = text.replace("</body>", _LATE % script + "</body>")
    copy = folder / "page.html"
    copy.write_text(text, encoding="utf-8")
    options = [
        *OPTIONS,
        f"--window-size={width},800",
        f"--user-data-dir={folder / 'profile'}",
        "--virtual-time-budget=5000",
        *("--enable-logging=stderr", "--dump-dom"),
    ]
    output, log = _run([name, *options, copy.as_uri()])
    found = re.search(r'data-result="([^"]*)"', output)
    assert found, f"the page did not finish:\n{log[-2000:]}"
    answer = json.loads(html.unescape(found[1]))
    console = [line for line in log.split("\n") if "CONSOLE" in line]
    return answer["result"], answer["failures"] + console


def _run(command: list[str]) -> tuple[str, str]:
    """Returns the output and the log. All processes of the browser are
    ended."""
    process = subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    try:
        return process.communicate(timeout=_TIMEOUT)
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
