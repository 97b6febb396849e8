"""A display without a screen, and a window in it that is used as people do. Needs xvfb and xdotool.

As a program, it runs a command on such a display, and ends with the command's status.
"""

import os
import select
import subprocess
import sys

TIMEOUT = 60  # seconds; for hangs only


class Desktop:
    """A display of Xvfb."""

    def __init__(self):
        reading, writing = os.pipe()
        self._server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", "800x600x24", "-nolisten", "tcp"],
            pass_fds=[writing],
            stdin=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        os.close(writing)
        with os.fdopen(reading) as name:
            self.display = ":" + name.readline().strip()  # comes when the display is there

    def close(self):
        self._server.terminate()
        self._server.wait(TIMEOUT)


class View:
    """The window of `vitrine view`, at the upper left of a desktop. Pixels are from its lower left."""

    def __init__(self, desktop, *arguments, size, folder):
        self._environment = dict(os.environ, DISPLAY=desktop.display)
        self._height = size[1]
        self._stderr = (folder / "stderr").open("w+b")
        self.program = subprocess.Popen(
            [os.environ["VITRINE_PROGRAM"], "view", *arguments, "--size", "{}x{}".format(*size)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=self._stderr,
            cwd=folder,
            env=self._environment,
        )

    def begin(self):
        """Wait for the window, and have the cursor enter it, so that it gets keys. Returns what the window says."""
        said = self.says()
        self._use("mousemove", 799, 599, "mousemove", 1, 1)
        return said

    def says(self):
        """The next line that the window says, which it does after each gesture."""
        if not select.select([self.program.stdout], [], [], TIMEOUT)[0]:
            raise AssertionError("the window says nothing")
        return self.program.stdout.readline().decode().rstrip("\n")

    def _use(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self._environment, timeout=TIMEOUT, check=True)

    def press(self, key):
        self._use("key", key)
        return self.says()

    def click(self, x, y, *, key=None, button=1):
        held = [("keydown", key), ("keyup", key)] if key else [(), ()]
        self._use("mousemove", x, self._height - 1 - y, *held[0], "click", button, *held[1])
        return self.says()

    def drag(self, start, end, *, key=None, button=1):
        (x, y), (right, top) = start, end
        held = [("keydown", key), ("keyup", key)] if key else [(), ()]
        self._use("mousemove", x, self._height - 1 - y, *held[0], "mousedown", button)
        self._use("mousemove", right, self._height - 1 - top, "mouseup", button, *held[1])
        return self.says()

    def end(self):
        """Close the window by its key. Returns the exit status, and what the program wrote on stderr."""
        self._use("key", "q")
        status = self.program.wait(TIMEOUT)
        self._stderr.seek(0)
        return status, self._stderr.read().decode(errors="replace")

    def kill(self):
        self.program.kill()
        self.program.wait()
        self.program.stdout.close()
        self._stderr.close()


if __name__ == "__main__":
    DESKTOP = Desktop()
    try:
        sys.exit(subprocess.run(sys.argv[1:], env=dict(os.environ, DISPLAY=DESKTOP.display), check=False).returncode)
    finally:
        DESKTOP.close()
