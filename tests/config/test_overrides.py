"""Overrides that Hydra cannot read are rejected, with the name of the setting and the necessary quotes."""

import re
import shlex
import subprocess

import pytest
from hydra.core.override_parser.overrides_parser import OverridesParser

from placecat.config import overrides
from placecat.errors import PlacecatError

UNREAD = [
    "H\u00e4user",
    "a(b",
    "a=b",
    "~/x",
    "o'hara",
    "R&D",
    "a,b",
    "{a",
    "a#b",
    'it\'s a "home"',
    "a'\\",
    "$(a)",
]


def read(override):
    return OverridesParser.create().parse_override(override).value()


def refused(*given):
    with pytest.raises(PlacecatError) as caught:
        overrides.check(given)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def shown(message):
    """Return the spellings of the override in the message, for a shell and for make."""
    return re.search(r"write (.*), and with make (SET=.*)$", message).groups()


@pytest.mark.parametrize(
    "override", ["a=1", "a=my homes", "a=[x,y z]", "~a", "+a.b=c", "a='\u00e4'", "dataset=x", "a="]
)
def test_readable_overrides_pass(override):
    overrides.check([override])


@pytest.mark.parametrize("value", [*UNREAD, "a!b"])
def test_values_are_quoted_for_shell_and_make(value, tmp_path):
    message = refused("verdict.level=0.9", f"dataset.root={value}")
    assert message.startswith(f"Hydra cannot read the value {value!r} of dataset.root")
    for_shell, for_make = shown(message)
    (argument,) = shlex.split(for_shell)
    assert read(argument) == value
    (tmp_path / "Makefile").write_text("SET ?=\nrepro:\n\t@printf '%s\\n' $(SET)\n")
    for line in (f"printf '%s\\n' {for_shell}", f"make -s repro {for_make}"):
        done = subprocess.run(["bash", "-c", line], cwd=tmp_path, capture_output=True, text=True, check=True)
        assert done.stdout == f"{argument}\n"


def test_only_items_that_need_quotes_get_them():
    for_shell, _ = shown(refused("dataset.homes=[home_1,H\u00e4user, R&D]"))
    assert for_shell == "\"dataset.homes=[home_1,'H\u00e4user','R&D']\""


def test_a_word_without_a_value_may_belong_to_the_previous_one():
    message = refused("dataset.root=my", "homes")
    assert message.startswith("the override 'homes' has no value: if it belongs to 'dataset.root=my', write")
    assert shown(message)[0] == "\"dataset.root='my homes'\""
    assert "write NAME=VALUE" in refused("homes")
    assert "is empty" in refused("")
