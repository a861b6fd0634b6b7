"""User text is shown literally in every medium, and is never executed."""

import csv
import io
import re
from html import unescape

import pandas as pd
import pytest
from matplotlib.figure import Figure

from placecat.drawing.lettering import mask
from placecat.drawing.palette import place_title, written
from placecat.drawing.style import house_style, save
from placecat.errors import PlacecatError, printable
from placecat.mlflow_log.store import key
from placecat.report.formats import latex, markdown
from placecat.templates import environment
from placecat.terminal import Terminal

HOSTILE = {
    "mathematics": "cost $5$ and $x^$ {_",
    "format": "100% %s %d {0} {{ 7*7 }} {% raw %}",
    "markup": "<script>alert(1)</script> &lt; <b>",
    "link": "[click](javascript:alert(1)) ![x](y) |a|b| `c` *d*",
    "latex": r"\input{/etc/passwd} \write18{ls} ~^_#&$%{}",
    "formula": '=HYPERLINK("http://x","y"),+1,-1,@A1',
    "lines": "one\ntwo\r\nthree\ttab",
    "escape": "\x1b[2J\x1b]0;title\x07 and \x9b31m \x00 \x7f",
    "half a character": "caf\udce9 \ud800",
    "turned": "\u202egnp.exe\u2066 \u2028",
    "long": "x" * 248,
    "very long": "y" * 100_000,
    "marks": "a" + "\u0301" * 200,
    "emoji": "\U0001f600 \U0001f468\u200d\U0001f469",
}


# Fonts lack some of these characters.
pytestmark = pytest.mark.filterwarnings("ignore:.*(Glyph|constrained_layout):UserWarning")


@pytest.fixture(params=HOSTILE)
def text(request):
    return HOSTILE[request.param]


def test_a_figure_shows_the_text(text, tmp_path):
    def draw():
        figure = Figure(figsize=(3, 1.5))
        axes = figure.subplots()
        axes.set_title(written(text))
        axes.set_yticks([0.5], [place_title(text)])
        return figure

    with house_style():
        figure = draw()
        save(figure, tmp_path / "figure.png")
        assert not any(
            one.get_parse_math() for one in figure.findobj(lambda one: hasattr(one, "get_parse_math"))
        )
    assert (tmp_path / "figure.png").stat().st_size > 1000


def test_a_picture_shows_the_text(text):
    drawn = mask(text, 12)
    assert drawn.ndim == 2
    assert 0 < drawn.shape[1] < 4000


def test_terminal_output_is_escaped(text):
    for coding in ("utf-8", "ascii"):
        target = io.TextIOWrapper(io.BytesIO(), encoding=coding)
        terminal = Terminal(target)
        print(text, file=terminal)
        print(PlacecatError(text), file=terminal)
        terminal.flush()
        shown = target.buffer.getvalue().decode(coding)
        assert all(one.isprintable() or one in "\n\t" for one in shown)
    assert printable("H\u00e4user $1 <b>") == "H\u00e4user $1 <b>"


def test_a_terminal_can_be_flushed_after_its_stream_is_closed():
    """Python flushes an object of this kind when it frees it, and 3.13 reports errors."""
    target = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
    terminal = Terminal(target)
    target.close()
    terminal.flush()


def test_the_page_shows_the_text(text):
    shown = (
        environment("placecat.report").from_string('<p title="{{ text }}">{{ text }}</p>').render(text=text)
    )
    assert (shown.count("<"), shown.count(">"), shown.count('"')) == (2, 2, 2)
    assert unescape(shown) == f'<p title="{text}">{text}</p>'


def test_latex_prints_the_text(text):
    shown = latex(text)
    for escaped in (*(f"\\{one}" for one in "&%$#_{}"), r"\textbackslash{}", "{[}"):
        shown = shown.replace(escaped, "")
    shown = re.sub(r"\\text[a-z]+\{\}", "", shown)
    assert not set("\\&%$#_{}~^\n") & set(shown)


def test_markdown_shows_the_text(text):
    shown = markdown(text)
    assert "\n" not in shown
    for character in "|`<[*$":
        assert f"\\{character}" in shown or character not in text


def test_mlflow_accepts_the_text_as_a_key(text):
    from mlflow.utils.validation import _validate_metric_name

    name = key("accuracy", text)
    _validate_metric_name(name)
    assert len(name) <= 250


@pytest.mark.parametrize("parts", [("a", ".."), ("..", "b"), ("a//b", "/"), (".", "a"), ("a", "/b/")])
def test_mlflow_accepts_keys_that_look_like_paths(parts):
    from mlflow.utils.validation import _validate_metric_name

    _validate_metric_name(key("accuracy", *parts))


def test_csv_files_preserve_the_text(text, tmp_path):
    """The table is for data, not for spreadsheets, so text that begins with = is unchanged."""
    if not text.isascii() or "\x00" in text:
        return
    path = tmp_path / "table.csv"
    pd.DataFrame({"label": [text], text: ["x"]}).to_csv(path, index=False, lineterminator="\n")
    with path.open(newline="") as file:
        head, row = csv.reader(file)
    assert (head[1], row[0]) == (text, text)
