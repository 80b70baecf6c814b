# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Drives a headless Chromium over its debugging pipe, with the standard library alone.

Messages are JSON objects, each followed by a NUL, on the browser's file descriptors 3 and 4.
"""
import base64
import itertools
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time


class BrowserError(Exception):
    pass


def find():
    """The browser's path, or None."""
    for name in ("chromium", "chromium-browser", "google-chrome"):
        path = shutil.which(name)
        if path:
            return path
    return None


class Chromium:
    """One browser with one page, as a context manager: it is gone at the end, whatever happens."""

    def __init__(self, path, width=1440, height=1000, dark=False):
        self.path = path
        self.size = (width, height)
        self.dark = dark
        self.process = None
        self.numbers = itertools.count(1)
        self.events = []

    def __enter__(self):
        fault = None
        for patience_s in (10, 20):  # A loaded machine may need the second try.
            try:
                self._start(patience_s)
                return self
            except (BrowserError, OSError) as error:
                fault = error
                self.close()
        raise BrowserError(f"the browser did not start: {fault}")

    def __exit__(self, *_):
        self.close()

    def _start(self, patience_s):
        self.folder = tempfile.mkdtemp(prefix="setsquare-browser-")
        to_read, self.to_browser = os.pipe()
        self.from_browser, to_write = os.pipe()

        def as_3_and_4():
            # Over spare numbers first, for the pipe's own ends may be 3 or 4.
            reading, writing = os.dup(to_read), os.dup(to_write)
            os.dup2(reading, 3)
            os.dup2(writing, 4)

        self.process = subprocess.Popen(
            [self.path, "--headless=new", "--remote-debugging-pipe", "--no-sandbox",
             "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", "--mute-audio",
             "--disable-extensions", "--disable-background-networking", "--disable-sync",
             "--disable-component-update", "--disable-default-apps", "--no-default-browser-check",
             "--force-color-profile=srgb", "--hide-scrollbars", "--force-device-scale-factor=1",
             f"--user-data-dir={self.folder}", "about:blank"],
            preexec_fn=as_3_and_4, close_fds=False, start_new_session=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self.received = b""
        self.session = None
        deadline = time.monotonic() + patience_s
        targets = self.call("Target.getTargets", patience_s=patience_s)["targetInfos"]
        while not any(target["type"] == "page" for target in targets):
            if time.monotonic() > deadline:
                raise BrowserError("it shows no page")
            time.sleep(0.05)
            targets = self.call("Target.getTargets")["targetInfos"]
        page = next(target for target in targets if target["type"] == "page")
        answer = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)
        self.session = answer["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")
        self.set_size(*self.size)
        if self.dark:
            self.call("Emulation.setEmulatedMedia",
                      features=[{"name": "prefers-color-scheme", "value": "dark"}])

    def close(self):
        if self.process is not None:
            try:
                os.killpg(self.process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            self.process.wait()
            self.process = None
            os.close(self.to_browser)
            os.close(self.from_browser)
        shutil.rmtree(getattr(self, "folder", ""), ignore_errors=True)

    def _receive(self, deadline):
        """The next message; raises where none comes in time."""
        while b"\0" not in self.received:
            left_s = deadline - time.monotonic()
            if left_s <= 0 or not select.select([self.from_browser], [], [], left_s)[0]:
                raise BrowserError("no answer in time")
            piece = os.read(self.from_browser, 1 << 20)
            if not piece:
                raise BrowserError("it has ended")
            self.received += piece
        message, self.received = self.received.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, patience_s=20, **params):
        number = next(self.numbers)
        message = {"id": number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to_browser, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + patience_s
        while True:
            answer = self._receive(deadline)
            if answer.get("id") != number:
                self.events.append(answer)
            elif "error" in answer:
                raise BrowserError(f"{method}: {answer['error']}")
            else:
                return answer["result"]

    def set_size(self, width, height):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=False)

    def open(self, path, is_drawn="window.setsquare.map.image.isReady"):
        """Loads a file and waits until the page has drawn itself."""
        self.visit("file://" + os.path.abspath(path), is_drawn)

    def visit(self, url, is_drawn):
        """The same of any page."""
        self.events.clear()
        self.call("Page.navigate", url=url)
        self.wait_for("document.readyState === 'complete' && window.setsquare !== undefined && " + is_drawn)

    def evaluate(self, expression):
        """The value of a script's expression; a promise is waited for."""
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in answer:
            raise BrowserError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def wait_for(self, condition, patience_s=20):
        deadline = time.monotonic() + patience_s
        while True:
            try:
                if self.evaluate(condition):
                    break
            except BrowserError:  # The page may be changing under it.
                if self.process.poll() is not None:
                    raise
            if time.monotonic() > deadline:
                raise BrowserError(f"still not true: {condition}")
            time.sleep(0.03)
        self.settle()

    def settle(self):
        """Lets the page draw what it was asked to."""
        self.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() =>"
                      " setTimeout(done, 0))))")

    def screenshot(self, clip=None):
        """PNG bytes of the window, or of a part: (left, top, width, height) on the page."""
        params = {"format": "png"}
        if clip:
            params["clip"] = dict(zip(("x", "y", "width", "height"), clip), scale=1)
            params["captureBeyondViewport"] = True
        return base64.b64decode(self.call("Page.captureScreenshot", **params)["data"])

    def mouse(self, kind, column, row, **params):
        self.call("Input.dispatchMouseEvent", type=kind, x=column, y=row, **params)

    def click(self, column, row):
        self.mouse("mouseMoved", column, row)
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, column, row, button="left", clickCount=1)
        self.settle()

    def drag(self, start, end):
        self.mouse("mouseMoved", *start)
        self.mouse("mousePressed", *start, button="left", clickCount=1)
        for step in range(1, 6):
            place = [a + (b - a) * step / 5 for a, b in zip(start, end)]
            self.mouse("mouseMoved", *place, button="left", buttons=1)
        self.mouse("mouseReleased", *end, button="left", clickCount=1)
        self.settle()

    def wheel(self, column, row, pixels):
        self.mouse("mouseWheel", column, row, deltaX=0, deltaY=pixels)
        self.settle()

    def key(self, key):
        """A key that has the focus; one letter is typed, a longer name such as "ArrowDown" pressed."""
        text = {"text": key} if len(key) == 1 else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)
        self.settle()
