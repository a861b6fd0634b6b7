"""Types for names and other text in the settings: file names, labels and titles."""

import re
from collections.abc import Hashable
from pathlib import Path
from typing import Annotated, TypeVar

from pydantic import AfterValidator

_Item = TypeVar("_Item", bound=Hashable)
# A file name can be at most 255 bytes long; some of these are reserved for a prefix and a suffix.
_LONGEST_NAME, _LONGEST_TEXT = 200, 4000
_KEY = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_-]*")
# Values of `protocol.test_homes` that are not home names.
_RESERVED = ("all",)


def _text(text: str) -> str:
    if not text.strip():
        raise ValueError("it is empty")
    if not text.isprintable():
        raise ValueError("it contains a character that cannot be printed: remove it")
    if len(text.encode()) > _LONGEST_TEXT:
        raise ValueError(f"it is longer than {_LONGEST_TEXT} bytes")
    return text


def _folder(text: str) -> str:
    _text(text)
    if "://" in text:
        raise ValueError("it is an address: copy the data into a folder, and write its path")
    if text.startswith("~"):
        raise ValueError("~ is not expanded here: write the full path")
    # DVC rejects a data folder that a stage writes to.
    if Path("data").resolve().is_relative_to(Path(text).resolve()):
        raise ValueError("the stages write into this folder: put the homes in another folder")
    return text


def _short(text: str) -> str:
    if len(_text(text).encode()) > _LONGEST_NAME:
        raise ValueError(f"it is longer than {_LONGEST_NAME} bytes: use a shorter name")
    if text != text.strip():
        raise ValueError("it begins or ends with a space")
    return text


def _file_name(text: str) -> str:
    _short(text)
    if "/" in text or "\\" in text:
        raise ValueError("it names a file or folder: do not use / or \\")
    if text.startswith((".", "-")):
        raise ValueError("it names a file or folder: do not begin with . or -")
    if text in _RESERVED:
        raise ValueError(f"{text!r} has a special meaning: choose another name")
    return text


def _key(text: str) -> str:
    if not _KEY.fullmatch(text):
        raise ValueError("it is used in dotted names: use only the letters a-z and A-Z, digits, _ and -")
    return _file_name(text)


def _distinct(items: list[_Item]) -> list[_Item]:
    for number, item in enumerate(items):
        if item in items[:number]:
            raise ValueError(f"it contains {item!r} twice: remove one")
    return items


Text = Annotated[str, AfterValidator(_text)]
"""Any text, such as an address."""
Folder = Annotated[str, AfterValidator(_folder)]
"""The path of a data folder that a stage depends on."""
Label = Annotated[str, AfterValidator(_short)]
"""The name of a place or camera, or a title, as shown in tables and figures."""
FileName = Annotated[str, AfterValidator(_file_name)]
"""The name of a home or sequence, which is used for files and folders."""
Key = Annotated[str, AfterValidator(_key)]
"""The name of a cue, codebook or system, which is used for files and in dotted names."""
Distinct = Annotated[list[_Item], AfterValidator(_distinct)]
"""A list without duplicates."""
