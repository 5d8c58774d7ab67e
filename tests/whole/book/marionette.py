"""Firefox with a window on a display without a screen, driven by its own protocol, Marionette: what two tests need of it. Headless
Firefox has no WebGL2 without a graphics card."""

import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

PREFERENCES = {"webgl.force-enabled": True, "webgl.disable-fail-if-major-performance-caveat": True, "app.update.auto": False,
               "browser.shell.checkDefaultBrowser": False, "datareporting.policy.dataSubmissionEnabled": False,
               "browser.aboutwelcome.enabled": False, "network.captive-portal-service.enabled": False}


class Firefox:
    def __init__(self, seconds=60):
        self._folder = tempfile.TemporaryDirectory(prefix="raysteps_firefox_")
        profile = Path(self._folder.name) / "profile"
        profile.mkdir()
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        lines = {**PREFERENCES, "marionette.port": port}
        (profile / "user.js").write_text("".join(f'user_pref("{name}", {json.dumps(value)});\n' for name, value in lines.items()))
        environment = {**os.environ, "HOME": self._folder.name, "LIBGL_ALWAYS_SOFTWARE": "1", "MOZ_DISABLE_CONTENT_SANDBOX": "1"}
        self._process = subprocess.Popen(
            ["xvfb-run", "-a", shutil.which("firefox-esr"), "--marionette", "--no-remote", "--profile", profile, "about:blank"],
            env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        self._number = 0
        self._connect(port, time.monotonic() + seconds)
        self.ask("WebDriver:NewSession")
        self.ask("WebDriver:SetTimeouts", script=280000, pageLoad=60000)

    def _connect(self, port, end):
        while True:
            try:
                self._socket = socket.create_connection(("127.0.0.1", port), timeout=300)
                self._read()  # it says what it is
                return
            except OSError:
                if time.monotonic() > end or self._process.poll() is not None:
                    self.quit()
                    raise
                time.sleep(0.1)

    def _read(self):
        length = b""
        while not length.endswith(b":"):
            byte = self._socket.recv(1)
            if not byte:
                raise ConnectionError("Firefox has closed the connection.")
            length += byte
        left, pieces = int(length[:-1]), []
        while left:
            pieces.append(self._socket.recv(left))
            left -= len(pieces[-1])
        return json.loads(b"".join(pieces))

    def ask(self, command, **parameters):
        self._number += 1
        message = json.dumps([0, self._number, command, parameters]).encode()
        self._socket.sendall(str(len(message)).encode() + b":" + message)
        _, _, error, result = self._read()
        if error:
            raise RuntimeError(f"{command}: {error['message']}")
        return result

    def get(self, address):
        self.ask("WebDriver:Navigate", url=address)

    def execute_script(self, script, *arguments):
        return self.ask("WebDriver:ExecuteScript", script=script, args=list(arguments))["value"]

    def execute_async_script(self, script, *arguments):
        return self.ask("WebDriver:ExecuteAsyncScript", script=script, args=list(arguments))["value"]

    def quit(self):
        if self._process.poll() is None:
            os.killpg(self._process.pid, signal.SIGTERM)
            self._process.wait()
        self._folder.cleanup()
