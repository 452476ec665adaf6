"""Headless Chromium, driven through its debugging protocol over two pipes: no port, no driver, no wheel."""

import base64
import io
import json
import os
import select
import shutil
import subprocess
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.patience import PATIENCE

CHROMIUM = next(
    filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None
)
FLAGS = (
    *("--headless=new", "--no-sandbox", "--disable-gpu", "--use-gl=angle", "--use-angle=swiftshader"),
    *("--enable-unsafe-swiftshader", "--no-first-run", "--disable-dev-shm-usage", "--remote-debugging-pipe"),
)  # fmt: skip
AXE = Path(__file__).parents[2] / "docs" / "_build" / "node_modules" / "axe-core" / "axe.min.js"


def axe_core() -> str:
    """Return axe-core, which looks for what keeps people out of pages; skip where it is not installed."""
    if not AXE.is_file():
        pytest.skip("needs axe-core (scripts/install_judges.sh)")
    return AXE.read_text(encoding="utf-8")


class Browser:
    """One browser with one page; what it says on the console and asks of the network is kept."""

    def __init__(self, profile: Path, *flags: str, size: tuple[int, int] = (800, 600)) -> None:
        assert CHROMIUM
        commands, self._out = os.pipe()
        self._in, answers = os.pipe()

        def pipes() -> None:
            spare = os.dup(answers)  # either end may be where the other has to go
            os.dup2(os.dup(commands), 3)
            os.dup2(spare, 4)

        command = [CHROMIUM, *FLAGS, *flags, f"--user-data-dir={profile}"]
        command += [f"--window-size={size[0]},{size[1]}", "about:blank"]
        self.process = subprocess.Popen(
            command,
            preexec_fn=pipes,
            close_fds=False,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(commands)
        os.close(answers)
        self._buffer = b""
        self._number = 0
        self.complaints: list[str] = []
        self.requests: list[str] = []
        targets = self.send("Target.getTargets")["targetInfos"]
        page = next(t["targetId"] for t in targets if t["type"] == "page")
        self.session = None
        attached = self.send("Target.attachToTarget", targetId=page, flatten=True)
        self.session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.send(f"{domain}.enable")
        width, height = size
        self.send(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )

    session: str | None = None

    def send(self, method: str, **params: Any) -> Any:
        """Send a command and return its result."""
        self._number += 1
        message = {"id": self._number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self._out, json.dumps(message).encode() + b"\0")
        number = self._number
        deadline = time.monotonic() + PATIENCE
        while True:
            answer = self._receive(method, deadline)
            if answer.get("id") == number:
                assert "error" not in answer, (method, answer["error"])
                return answer["result"]

    def _receive(self, method: str, deadline: float) -> dict[str, Any]:
        """Return the next thing that the browser says while it is to answer ``method``."""
        while b"\0" not in self._buffer:
            left = max(0.0, deadline - time.monotonic())
            if not select.select([self._in], [], [], left)[0]:  # a read would wait for ever
                raise TimeoutError(f"no answer to {method} in {PATIENCE:g} s: the browser hangs")
            part = os.read(self._in, 1 << 20)
            assert part, f"the browser has gone before it answered {method}"
            self._buffer += part
        text, _, self._buffer = self._buffer.partition(b"\0")
        event: dict[str, Any] = json.loads(text)
        self._note(event.get("method", ""), event.get("params", {}))
        return event

    def _note(self, method: str, params: dict[str, Any]) -> None:
        if method == "Runtime.consoleAPICalled" and params["type"] in (
            "error",
            "warning",
            "assert",
        ):
            self.complaints.append(str(params["args"]))
        elif method == "Runtime.exceptionThrown":
            self.complaints.append(str(params["exceptionDetails"]))
        elif method == "Log.entryAdded" and params["entry"]["level"] == "error":
            self.complaints.append(str(params["entry"]))
        elif method == "Network.requestWillBeSent":
            self.requests.append(params["request"]["url"])

    def open(self, path: Path) -> None:
        """Open a file, and wait until its scripts have run and a frame was drawn."""
        self.send("Page.navigate", url=path.as_uri())
        self.wait("document.readyState === 'complete' && location.protocol === 'file:'")
        self.evaluate(
            "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
        )

    def evaluate(self, expression: str) -> Any:
        """Return the value of an expression of JavaScript, awaited."""
        result = self.send(
            "Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True
        )
        assert "exceptionDetails" not in result, result
        return result["result"].get("value")

    def wait(self, condition: str) -> None:
        """Wait until an expression is true."""
        deadline = time.monotonic() + PATIENCE
        while not self.evaluate(condition):
            if time.monotonic() > deadline:
                raise TimeoutError(f"not true in {PATIENCE:g} s: {condition}")
            time.sleep(0.02)

    def picture(self) -> NDArray[np.int64]:
        """Return what the page shows, (height, width, 3)."""
        from PIL import Image

        data = self.send("Page.captureScreenshot", format="png")["data"]
        with Image.open(io.BytesIO(base64.b64decode(data))) as image:
            return np.asarray(image.convert("RGB")).astype(int)

    def mouse(self, kind: str, x: float, y: float, **more: Any) -> None:
        """Send an event of the mouse: Pressed, Moved, Released or Wheel."""
        self.send("Input.dispatchMouseEvent", type=f"mouse{kind}", x=x, y=y, **more)

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Press, move in four steps, release."""
        self.mouse("Pressed", *start, button="left", buttons=1, clickCount=1)
        for n in range(1, 5):
            x, y = (s + (e - s) * n / 4 for s, e in zip(start, end, strict=True))
            self.mouse("Moved", x, y, button="left", buttons=1)
        self.mouse("Released", *end, button="left", clickCount=1)

    def key(self, key: str, shift: bool = False) -> None:
        """Press and release a key."""
        for kind in ("keyDown", "keyUp"):
            self.send("Input.dispatchKeyEvent", type=kind, key=key, modifiers=8 if shift else 0)

    def close(self) -> None:
        """End the browser."""
        self.session = None
        try:
            self.send("Browser.close")
        finally:
            os.close(self._out)
            self.process.wait(PATIENCE)
            os.close(self._in)
