"""A real browser without a window, for pages on disk."""

from selenium import webdriver
from selenium.webdriver.chrome import service
from selenium.webdriver.common import utils


class Service(service.Service):
    """
    The driver, reached by its address. Selenium uses the name localhost, which is unknown in a root without /etc/hosts.
    """

    HOST = "127.0.0.1"

    @property
    def service_url(self):
        return f"http://{self.HOST}:{self.port}"

    def is_connectable(self):
        return utils.is_connectable(self.port, self.HOST)


def open_browser(width=1280, height=1000, is_dark=False):
    """Chromium with a window of that size; what pages write to the console is kept."""
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"):
        options.add_argument(argument)
    # Without it the driver asks for the browser by the name localhost.
    options.add_argument("--remote-debugging-pipe")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))
    browser.execute_cdp_cmd(
        "Emulation.setDeviceMetricsOverride",
        {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False},
    )
    scheme = {"name": "prefers-color-scheme", "value": "dark" if is_dark else "light"}
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [scheme]})
    return browser


def open_page(browser, path):
    """Open a file with the network off."""
    browser.execute_cdp_cmd("Network.enable", {})
    browser.execute_cdp_cmd(
        "Network.emulateNetworkConditions",
        {"offline": True, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0},
    )
    browser.get(path.resolve().as_uri())


def whole_page_png(browser):
    """A picture of the whole page, base64."""
    return browser.execute_cdp_cmd(
        "Page.captureScreenshot", {"captureBeyondViewport": True, "format": "png"}
    )["data"]
