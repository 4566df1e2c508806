"""A headless Chromium, driven through its debugging pipe: no package, no port, no network."""

from __future__ import annotations

import itertools
import json
import os
import select
import shutil
import subprocess
import time
from pathlib import Path

import pytest

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
_FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking")


class Browser:
    """One page of a browser; what it says on the console and asks of the network is kept.

    errors : exceptions and error messages; requests : every address asked for.
    """

    def __init__(self, profile: Path, patience: float = 60.0):
        self.errors: list[str] = []
        self.requests: list[str] = []
        self._patience, self._numbers, self._rest = patience, itertools.count(1), b""
        to_browser, self._write = os.pipe()
        self._read, from_browser = os.pipe()
        # Chromium reads the descriptor 3 and writes the descriptor 4
        command = f'exec "$@" 3<&{to_browser} 4>&{from_browser}'
        arguments = [CHROMIUM, *_FLAGS, f"--user-data-dir={profile}", "--remote-debugging-pipe", "about:blank"]
        self._process = subprocess.Popen(
            ["bash", "-c", command, "bash", *arguments],
            pass_fds=(to_browser, from_browser),
            stderr=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
        )
        os.close(to_browser)
        os.close(from_browser)
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self._session = None
        self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")

    _session: str | None = None

    def call(self, method: str, **parameters):
        """Return the answer of the browser to a command of its protocol."""
        number = next(self._numbers)
        message = {"id": number, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._next()
            if answer.get("id") == number:
                assert "error" not in answer, answer
                return answer["result"]

    def run(self, script: str):
        """Return the value of a JavaScript expression on the page."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in answer, answer
        return answer["result"].get("value")

    def open(self, address: str, width: int, height: int) -> None:
        """Open an address in a window of this size and wait until it is loaded."""
        self.call(
            "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600
        )
        self.call(
            "Page.navigate", url="about:blank"
        )  # an address that differs in its last part only is not loaded anew
        self.call("Page.navigate", url=address)
        while self.run("document.readyState + location.protocol + innerWidth") != f"completefile:{width}":
            time.sleep(0.05)
        self.run("new Promise((painted) => requestAnimationFrame(() => requestAnimationFrame(painted)))")

    def click(self, x: float, y: float) -> None:
        """Press and let go of the mouse at a place of the window."""
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)

    def press(self, key: str) -> None:
        """Press and let go of a key that writes nothing."""
        for kind in ("rawKeyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key)

    def close(self) -> None:
        """End the browser."""
        self._process.kill()
        self._process.wait()
        for descriptor in (self._read, self._write):
            os.close(descriptor)

    def _next(self):
        while b"\0" not in self._rest:
            ready, _, _ = select.select([self._read], [], [], self._patience)
            assert ready, f"the browser said nothing for {self._patience:g} s"
            piece = os.read(self._read, 1 << 20)
            assert piece, "the browser ended"
            self._rest += piece
        text, _, self._rest = self._rest.partition(b"\0")
        answer = json.loads(text)
        said, method = answer.get("params", {}), answer.get("method")
        if method == "Network.requestWillBeSent":
            self.requests.append(said["request"]["url"])
        elif method == "Runtime.exceptionThrown":
            self.errors.append(
                said["exceptionDetails"].get("exception", said["exceptionDetails"]).get("description", "")
            )
        elif (method == "Runtime.consoleAPICalled" and said["type"] == "error") or (
            method == "Log.entryAdded" and said["entry"]["level"] == "error"
        ):
            self.errors.append(json.dumps(said))
        return answer


@pytest.fixture(scope="session")
def browser(tmp_path_factory):
    """A browser, or a reason why there is none."""
    if CHROMIUM is None:
        pytest.skip("no Chromium on this machine")
    driven = Browser(tmp_path_factory.mktemp("profile"))
    yield driven
    driven.close()
