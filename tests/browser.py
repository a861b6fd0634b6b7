"""A real headless Chromium, to test what a person sees."""

import html
import json
import re
import shutil
import subprocess

import pytest

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
OPTIONS = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run
--disable-background-networking --disable-component-update --disable-sync --enable-logging=stderr"""
# Pixels; Chromium makes no narrower window, except for a picture.
_NARROWEST = 500


def needs_chromium(test):
    """Mark a test that opens a page."""
    return pytest.mark.slow(pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")(test))


def open_page(url, folder, *arguments):
    """Open a page; returns its DOM after the scripts, and the log of Chromium with console messages."""
    assert CHROMIUM is not None
    command = [CHROMIUM, *OPTIONS.split(), f"--user-data-dir={folder / 'profile'}", *arguments, url]
    result = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    console = [line for line in result.stderr.splitlines() if "CONSOLE" in line]
    return result.stdout, console


def evaluate(page, folder, body, *, width=1200, height=900):
    """Load a copy of a page and run a script in it; returns its result, and the console.

    `body` is the body of an async function, e.g. ``return document.title``; its value goes through JSON.
    Its timers take no time. It must not wait for anything else, such as the decoding of an image.
    """
    script = f"""<script>addEventListener("load", async () => {{
        let value;
        try {{ value = await (async () => {{ {body} }})(); }} catch (error) {{ value = String(error); }}
        const shown = parent.document.createElement("pre");
        shown.id = "returned";
        shown.textContent = JSON.stringify(value);
        parent.document.body.append(shown);
    }});</script>"""
    text = page.read_text(encoding="utf-8").replace("</body>", f"{script}</body>")
    if width < _NARROWEST:
        # A frame can be narrower than a window.
        frame = f'<iframe width="{width}" height="{height}" frameborder="0" srcdoc="{html.escape(text)}">'
        text = f'<!DOCTYPE html><link rel="icon" href="data:,"><body>{frame}</iframe></body>'
    folder.mkdir(parents=True, exist_ok=True)
    copy = folder / "copy.html"
    copy.write_text(text, encoding="utf-8")
    dom, console = open_page(
        copy.as_uri(),
        folder,
        "--dump-dom",
        "--virtual-time-budget=20000",
        f"--window-size={max(width, _NARROWEST)},{height}",
    )
    return json.loads(html.unescape(re.search(r'<pre id="returned">(.*?)</pre>', dom, re.DOTALL)[1])), console


def screenshot(url, folder, name, *, width=1000, height=1400):
    """A picture of a page as PNG."""
    target = folder / f"{name}.png"
    open_page(url, folder, f"--screenshot={target}", f"--window-size={width},{height}", "--hide-scrollbars")
    return target
