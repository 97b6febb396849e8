"""The inspector's server: its token, its end, and what it says of bad input."""

import asyncio
import contextlib
import io
import signal
import unittest
import urllib.error
import urllib.request

from inspector_page import MODEL, Process, open_browser, started
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait
from trame.app.core import AVAILABLE_SERVERS

from vitrine.inspector import inspect
from vitrine.inspector._session import Session


class Revisions(unittest.TestCase):
    def test_of_the_tree_are_of_the_looks_that_it_tells(self):
        session = Session(str(MODEL), (64, 64), 0.0)
        self.addCleanup(session.close)
        path = session.inspection.parts.paths[0]
        session.inspection.hide([path])
        session.inspection.select([path])
        told = session.tree()
        self.assertEqual((told["revision"], told["looks"], told["selected"]), (1, [], []))
        session.note_change()
        told = session.tree(known=1)
        self.assertEqual((told["revision"], told["looks"], told["selected"]), (2, [[0, {"visible": False}]], [0]))


class Token(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = started(cls, MODEL)

    def status(self, path, **headers):
        request = urllib.request.Request(self.server.base + path, headers=headers)
        try:
            return urllib.request.urlopen(request, timeout=10).status
        except urllib.error.HTTPError as error:
            error.close()
            return error.code

    def test_is_needed_for_all(self):
        for path in ("", "index.html", "ws", "vitrine/tools.js", "?token=", "?token=guessed", "%2e%2e/etc/passwd"):
            with self.subTest(path):
                self.assertEqual(self.status(path), 401)
        self.assertEqual(self.status("index.html", Cookie="vitrine_1=x"), 401)

    def test_is_not_known_by_bytes_that_are_no_text(self):
        port = self.server.base.rsplit(":", 1)[1].strip("/")
        self.assertEqual(self.status("index.html", Cookie=f"vitrine_{port}=\xff"), 401)
        self.assertEqual(self.status("?token=%ff"), 401)

    def test_opens_the_page_once_known(self):
        opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
        with opener.open(self.server.address, timeout=10) as page:
            self.assertEqual(page.status, 200)
            self.assertNotIn("token", page.url)
        with opener.open(self.server.base + "vitrine/tools.js", timeout=10) as script:
            self.assertEqual(script.headers["Referrer-Policy"], "no-referrer")

    def test_is_of_no_use_to_other_pages(self):
        path = self.server.address[len(self.server.base) :]
        self.assertEqual(self.status(path, Origin="http://example.com"), 403)


class End(unittest.TestCase):
    def test_comes_by_ctrl_c(self):
        server = Process(MODEL)
        self.assertRegex(server.address, r"^http://127\.0\.0\.1:\d+/\?token=[\w-]{40,}$")
        server.process.send_signal(signal.SIGINT)
        self.assertEqual(server.wait(), (0, ""))

    def test_comes_by_quit_in_the_page(self):
        server = Process(MODEL)
        self.addCleanup(server.end)
        browser = open_browser(1000, 700)
        self.addCleanup(browser.quit)
        browser.get(server.address)
        button = WebDriverWait(browser, 30, 0.02).until(lambda b: b.find_elements(By.ID, "vi-quit"))[0]
        browser.execute_script("arguments[0].click()", button)
        self.assertEqual(server.wait(), (0, ""))


class BadInput(unittest.TestCase):
    def test_is_told_in_one_line(self):
        for arguments, expected in (
            (["/nowhere.glb"], "there is no such file"),
            ([__file__], "is not of a kind that can be read"),
            ([MODEL, "state.json"], "state.json: a state names its files, so it is opened alone"),
            ([MODEL, "--port", "70000"], "a port is a number from 0 to 65535"),
            ([MODEL, "--host", "198.51.100.1"], "address"),
        ):
            with self.subTest(expected):
                server = Process(*arguments)
                status, errors = server.wait()
                self.assertEqual((status, server.address), (2, ""))
                self.assertIn(expected, errors.strip().splitlines()[-1])


class Notebook(unittest.TestCase):
    def test_is_told_of_a_bad_file_and_leaves_no_server(self):
        async def opened():
            inspect("/nowhere.glb")
            while asyncio.all_tasks() - {asyncio.current_task()}:
                await asyncio.wait(asyncio.all_tasks() - {asyncio.current_task()})

        with contextlib.redirect_stderr(io.StringIO()) as told:
            asyncio.run(opened())
        self.assertIn("the inspector has ended: ", told.getvalue())
        self.assertIn("there is no such file", told.getvalue())
        self.assertEqual([name for name in AVAILABLE_SERVERS if name.startswith("vitrine-")], [])


if __name__ == "__main__":
    unittest.main()
