"""A headless Chromium for tests of pages.

Needs Chromium, its driver and Selenium (section test of packages.txt); where one is missing the test says so and is skipped.
"""
import json
import os
import shutil
import sys

SKIPPED = 77
PATIENCE = 1200  # seconds, a guard: software draws slowly where the machine is busy


def skip(why):
    print(f"skipped: {why}; the packages of section test in packages.txt bring it")
    sys.exit(SKIPPED)


def start_browser(folder, webgl=False):
    """A browser whose profile is in `folder`. With `webgl` three dimensions are drawn, by software; else not at all."""
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    driver = shutil.which("chromedriver")
    if chromium is None or driver is None:
        skip("Chromium or its driver is not installed")
    try:
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
    except ImportError:
        skip("Selenium for Python is not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    drawing = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
    # As root Chromium runs without its sandbox only; containers have little shared memory.
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--no-first-run",
                     "--disable-background-networking", "--hide-scrollbars",
                     f"--user-data-dir={folder / ('profile' + str(webgl))}",
                     *(drawing if webgl else ["--disable-gpu", "--disable-3d-apis"])):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    os.environ["HOME"] = str(folder)
    browser = webdriver.Chrome(options=options, service=Service(executable_path=driver))
    browser.set_page_load_timeout(PATIENCE)
    browser.set_script_timeout(PATIENCE)
    return browser


def console_faults(browser):
    """What pages wrote to the console, and what they requested from elsewhere."""
    for entry in browser.get_log("browser"):
        # Software pictures are read back by tests themselves, which the driver finds slow.
        if "GPU stall due to ReadPixels" not in entry["message"]:
            yield f"console: {entry['level']} {entry['message']}"
    for entry in browser.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            address = message["params"]["request"]["url"]
            # The browser's own first tab is made of chrome: pages.
            if not address.startswith(("file:", "data:", "about:", "chrome:", "blob:")):
                yield f"requested {address}"


def outcome(found):
    """Prints faults; the exit status of a test that found them."""
    for line in found:
        print(line)
    print(f"{len(found)} faults")
    return 1 if found else 0
