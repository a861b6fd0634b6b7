"""A real headless Chromium, for testing what a person sees."""

import html
import json
import re
import shutil
import subprocess

import pytest

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
OPTIONS = """--headless --no-sandbox --disable-gpu --disable-quic --no-first-run
--disable-background-networking --disable-component-update --disable-sync --enable-logging=stderr"""
# Minimum width of a Chromium window in pixels; only screenshots can be narrower.
_NARROWEST = 500


def needs_chromium(test):
    """Mark a test that opens a page in Chromium."""
    return pytest.mark.slow(pytest.mark.skipif(CHROMIUM is None, reason="chromium is not installed")(test))


def open_page(url, folder, *arguments):
    """Open a page; return its DOM after all scripts, and its console messages."""
    assert CHROMIUM is not None
    command = [CHROMIUM, *OPTIONS.split(), f"--user-data-dir={folder / 'profile'}", *arguments, url]
    result = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    console = [line for line in result.stderr.splitlines() if "CONSOLE" in line]
    return result.stdout, console


def evaluate(page, folder, body, *, width=1200, height=900):
    """Load a copy of a page and run a script in it; return the result and the console messages.

    `body` is the body of an async function, such as ``return document.title``; its value must be valid in
    JSON. Timers in it take no time. It must not wait for anything else, such as the decoding of an image.
    """
    (value,), console = evaluate_all(page, folder, [(body, width)], height=height)
    return value, console


def evaluate_all(page, folder, scripts, *, height=900):
    """Like `evaluate`, but for pairs of a body and a width. Each has its own page, all in one browser."""
    text, parts = page.read_text(encoding="utf-8"), []
    for number, (body, width) in enumerate(scripts):
        own = text.replace("</body>", f"{_script(number, body)}</body>")
        # A frame can be narrower than a window.
        frame = f'<iframe width="{width}" height="{height}" frameborder="0" srcdoc="{html.escape(own)}">'
        parts.append(f"{frame}</iframe>")
    if len(scripts) == 1 and width >= _NARROWEST:
        text = own
    else:
        text = f'<!DOCTYPE html><link rel="icon" href="data:,"><body>{"".join(parts)}</body>'
    folder.mkdir(parents=True, exist_ok=True)
    copy = folder / "copy.html"
    copy.write_text(text, encoding="utf-8")
    dom, console = open_page(
        copy.as_uri(),
        folder,
        "--dump-dom",
        "--virtual-time-budget=20000",
        f"--window-size={max(_NARROWEST, *(width for _, width in scripts))},{height}",
    )
    values = dict(re.findall(r'<pre id="returned-(\d+)">(.*?)</pre>', dom, re.DOTALL))
    return [json.loads(html.unescape(values[str(number)])) for number in range(len(scripts))], console


def _script(number, body):
    return f"""<script>addEventListener("load", async () => {{
        let value;
        try {{ value = await (async () => {{ {body} }})(); }} catch (error) {{ value = String(error); }}
        const shown = parent.document.createElement("pre");
        shown.id = "returned-{number}";
        shown.textContent = JSON.stringify(value);
        parent.document.body.append(shown);
    }});</script>"""


def screenshot(url, folder, name, *, width=1000, height=1400):
    """Take a screenshot of a page as PNG."""
    target = folder / f"{name}.png"
    open_page(url, folder, f"--screenshot={target}", f"--window-size={width},{height}", "--hide-scrollbars")
    return target
