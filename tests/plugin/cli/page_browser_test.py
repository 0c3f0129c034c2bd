# SPDX-License-Identifier: LGPL-2.1-or-later
"""A page in a browser: it draws, tells what is clicked, and complains of nothing.

Speaks the browser's debugging protocol through pipes, without any package. BLOSSOM_PROGRAM is the
program, BLOSSOM_BROWSER the browser; BLOSSOM_SHOT, if it is there, gets a picture of the page.
"""

import base64
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM, BROWSER = os.environ["BLOSSOM_PROGRAM"], os.environ["BLOSSOM_BROWSER"]
FLAGS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--enable-unsafe-swiftshader", "--window-size=1200,900", "--remote-debugging-pipe"]


class Browser:
    """One tab of a browser without a window."""

    def __init__(self, profile):
        to_read, self.to = os.pipe()
        self.at, to_write = os.pipe()

        def pipes():  # the browser reads from 3 and writes to 4
            low, high = os.dup(to_read), os.dup(to_write)
            os.dup2(low, 3)
            os.dup2(high, 4)

        self.process = subprocess.Popen(
            [BROWSER, *FLAGS, f"--user-data-dir={profile}"], preexec_fn=pipes, close_fds=False,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self.rest, self.number, self.events, self.session = b"", 0, [], None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")

    def message(self):
        while b"\0" not in self.rest:
            more = os.read(self.at, 1 << 20)
            if not more:
                raise RuntimeError("the browser has ended")
            self.rest += more
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.to, json.dumps(request).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def open(self, file):
        self.events.clear()
        self.call("Page.navigate", url=pathlib.Path(file).as_uri())
        while not any(event.get("method") == "Page.loadEventFired" for event in self.events):
            self.events.append(self.message())
        self.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def value(self, expression):
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def drag(self, x, y, to_x, to_y, button="left"):
        self.call("Input.dispatchMouseEvent", type="mousePressed", x=x, y=y, button=button,
                  clickCount=1)
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=to_x, y=to_y, button=button)
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=to_x, y=to_y, button=button,
                  clickCount=1)

    def complaints(self):
        """What the console shows, but for how fast the machine's graphics are."""
        methods = ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded")
        return [event for event in self.events
                if event.get("method") in methods and "GL Driver Message (OpenGL, Performance" not in
                event["params"].get("entry", {}).get("text", "")]

    def requests(self):
        return [event["params"]["request"]["url"] for event in self.events
                if event.get("method") == "Network.requestWillBeSent"]

    def picture(self):
        return base64.b64decode(self.call("Page.captureScreenshot")["data"])

    def close(self):
        try:
            self.call("Browser.close")
        except (RuntimeError, OSError):
            pass
        self.process.wait(timeout=30)
        os.close(self.to)
        os.close(self.at)


class Pages(unittest.TestCase):
    """The sample's parts, a browser, and no complaints of it."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        subprocess.run([os.environ["BLOSSOM_MAKE_PARTS"], cls.folder.name], check=True)
        cls.browser = Browser(os.path.join(cls.folder.name, "profile"))

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.folder.cleanup()

    @classmethod
    def made(cls, *command):
        """A page that a command writes."""
        page = os.path.join(cls.folder.name, "page.html")
        subprocess.run([PROGRAM, *command, "--html", page, "--quiet"], check=True, cwd=cls.folder.name)
        return page

    def tearDown(self):
        self.assertEqual(self.browser.complaints(), [])

    def picked(self, box="picked"):
        return self.browser.value(f"document.getElementById('{box}').textContent")


class PagesOfCommands(Pages):
    def click_the_middle_of(self, *command):
        self.browser.open(self.made(*command))
        self.browser.click(*self.browser.value("[canvas.clientWidth / 2, canvas.clientHeight / 2]"))

    def test_what_is_seen_through_a_clicked_part_is_told_too(self):
        self.click_the_middle_of("clash", "block.step", "drill.step")
        self.assertEqual(self.picked(), "Block")
        self.assertRegex(self.picked("behind"), r"^seen through it: .*Block and Drill, volume 4021\.24 mm³$")

    def test_nothing_is_seen_through_what_is_opaque(self):
        self.click_the_middle_of("info", "block.step")
        self.assertRegex(self.picked(), "^face 6")
        self.assertEqual(self.picked("behind"), "")

    def test_meshes_are_shown_by_their_groups(self):
        subprocess.run([PROGRAM, "convert", "block.step", "-o", "block.obj", "--quiet"], check=True,
                       cwd=self.folder.name)
        self.click_the_middle_of("info", "block.obj")
        self.assertEqual(self.picked(), "Block/Face6\n2 triangles")
        self.assertEqual(self.browser.value("document.body.dataset.triangles"), "12")


class PageInBrowser(Pages):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.page = cls.made("intersect", "hull.step", "cutters.step")

    def setUp(self):
        self.browser.open(self.page)

    def place_on_curve(self):
        return self.browser.value("blossomPage.placeOf(blossomPage.layers.indexOf('crossing'), 0, 0.5)")

    def test_is_drawn(self):
        self.assertGreater(int(self.browser.value("document.body.dataset.triangles")), 100)
        shot = self.browser.picture()
        if "BLOSSOM_SHOT" in os.environ:
            pathlib.Path(os.environ["BLOSSOM_SHOT"]).write_bytes(shot)
        hidden = self.browser.value("document.querySelectorAll('#switches input').forEach("
                                    "box => box.click()), 0")
        self.browser.value("new Promise(done => requestAnimationFrame(() => setTimeout(done, 50)))")
        self.assertEqual(hidden, 0)
        self.assertGreater(len(shot), 1.2 * len(self.browser.picture()))

    def test_click_on_a_curve_tells_its_numbers_and_parts(self):
        x, y = self.place_on_curve()
        self.browser.click(x, y)
        text = self.picked()
        for words in ("Hull x Deck", "face 1 x face 1", "length 12572", "degree", "poles",
                      "deviation", "proven"):
            self.assertIn(words, text)

    def test_click_on_a_face_tells_its_part(self):
        x, y = self.place_on_curve()
        self.browser.click(x, y + 30)
        self.assertRegex(self.picked(), r"^face 1 \((Hull|Deck)\)$")

    def test_click_beside_everything_says_so(self):
        self.browser.click(4, 4)
        self.assertEqual(self.picked(), "Nothing there.")

    def test_shows_the_certificate(self):
        self.assertIn("proven", self.browser.value("document.getElementById('facts').textContent"))

    def test_turns_and_zooms(self):
        before = self.place_on_curve()
        self.browser.drag(200, 200, 300, 240)
        turned = self.place_on_curve()
        self.assertGreater(abs(turned[0] - before[0]) + abs(turned[1] - before[1]), 5)
        self.browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=100, y=100, deltaX=0,
                          deltaY=-400)
        zoomed = self.place_on_curve()
        self.assertGreater(abs(zoomed[0] - turned[0]) + abs(zoomed[1] - turned[1]), 5)

    def test_what_is_below_the_mouse_stays_there_when_the_wheel_zooms(self):
        x, y = self.place_on_curve()
        self.browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0,
                          deltaY=-400)
        for before, after in zip((x, y), self.place_on_curve()):
            self.assertAlmostEqual(before, after, delta=1)  # the mouse is at whole pixels

    def test_slides_by_the_right_button(self):
        x, y = self.place_on_curve()
        self.browser.drag(200, 200, 230, 240, button="right")
        for before, after, way in zip((x, y), self.place_on_curve(), (30, 40)):
            self.assertAlmostEqual(after - before, way, delta=0.1)

    def test_shows_all_in_a_window_that_gets_another_size(self):
        for width, height in ((1200, 500), (1200, 1000), (700, 1000)):
            self.browser.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                              deviceScaleFactor=1, mobile=False)
            if height == 500:
                self.browser.open(self.page)
            self.browser.value("new Promise(done => setTimeout(done, 100))")
            ends = self.browser.value("[0, 1].map(share => blossomPage.placeOf("
                                      "blossomPage.layers.indexOf('crossing'), 0, share))")
            room = self.browser.value("[canvas.clientWidth, canvas.clientHeight]")
            for end in ends:
                for at, length in zip(end, room):
                    self.assertTrue(0 < at < length, (width, height, ends, room))
        self.browser.call("Emulation.clearDeviceMetricsOverride")

    def test_asks_for_nothing_but_itself(self):
        self.assertEqual(self.browser.requests(), [pathlib.Path(self.page).as_uri()])

    def test_policy_stops_foreign_scripts(self):
        self.browser.value("(() => { const s = document.createElement('script');"
                           "s.textContent = 'window.foreign = 1'; document.body.append(s); })()")
        self.assertIsNone(self.browser.value("window.foreign"))
        self.browser.events.clear()  # the policy's own complaint


if __name__ == "__main__":
    unittest.main()
