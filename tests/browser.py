"""A real headless Chromium, for tests of what a person sees."""

import shutil
import subprocess

import pytest

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
needs_chromium = pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")


def open_page(url, folder, *arguments):
    """Open a page; gives its DOM after scripts ran, and what Chromium logged (console messages included)."""
    assert CHROMIUM is not None
    command = [
        CHROMIUM,
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--enable-logging=stderr",
        f"--user-data-dir={folder / 'profile'}",
        *arguments,
        url,
    ]
    result = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    console = [line for line in result.stderr.splitlines() if "CONSOLE" in line]
    return result.stdout, console


def screenshot(url, folder, name, *, width=1000, height=1400):
    """A picture of a page as PNG."""
    target = folder / f"{name}.png"
    open_page(url, folder, f"--screenshot={target}", f"--window-size={width},{height}", "--hide-scrollbars")
    return target
