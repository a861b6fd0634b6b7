"""Zip archives that end with a checksum of their content. Each member is checked before it is read."""

import hashlib
import io
import math
import os
import re
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from placecat import files
from placecat.errors import PlacecatError

# The checksum is the zip comment at the end of the file, so other programs can still open the archive.
_MARK = b"placecat sha256 "
_DIGITS = 2 * hashlib.sha256().digest_size
# Accept only the exact header that `array_content` writes, because NumPy's reader evaluates any header.
_HEADER = re.compile(
    rb"\x93NUMPY\x01\x00..\{'descr': '([<|][biufU][0-9]{1,6})', 'fortran_order': False, "
    rb"'shape': \(((?:[0-9]{1,15}(?:,|, )?){0,8})\), \} *\n",
    re.DOTALL,
)
TRAIN_AGAIN = "train it again with `placecat train`"


def write(path: Path, members: Mapping[str, bytes]) -> None:
    """Write an archive. Identical members produce identical bytes."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        archive.comment = _MARK + b"0" * _DIGITS
        for name, content in members.items():
            archive.writestr(zipfile.ZipInfo(name), content)
    sealed = buffer.getvalue()[:-_DIGITS]
    with files.replacing(path) as temporary:
        temporary.write_bytes(sealed + hashlib.sha256(sealed).hexdigest().encode())


@contextmanager
def opened(path: Path) -> Iterator["Archive"]:
    """Open an archive.

    Raises PlacecatError if it cannot be opened, is not an archive, or has been modified.
    """
    try:
        if not path.is_file():
            raise PlacecatError(
                f"the model {path} is missing: create one with `make repro` or `placecat train`"
            )
        with path.open("rb") as file:
            _check_seal(path, file)
            try:
                archive = zipfile.ZipFile(file)
            # zipfile raises these errors for invalid numbers in headers.
            except (zipfile.BadZipFile, NotImplementedError, OSError, ValueError) as error:
                raise PlacecatError(f"{path} is not a placecat model, or is damaged: {error}") from None
            with archive:
                yield Archive(path, archive)
    except OSError as error:
        raise PlacecatError(f"the model {path} cannot be read: {error.strerror or error}") from None


class Archive:
    """The members of an archive.

    Raises PlacecatError if a member is compressed or encrypted, if two members have the same name, or if the
    declared sizes of the members add up to more than the file size.
    """

    def __init__(self, path: Path, archive: zipfile.ZipFile) -> None:
        self._path = path
        self._archive = archive
        infos = archive.infolist()
        self.names = [info.filename for info in infos]
        # This rules out zip bombs: members are not compressed, and no byte is read twice.
        for info in infos:
            if info.compress_type != zipfile.ZIP_STORED or info.flag_bits & 1:
                raise self.damaged(f"its member {info.filename!r} is compressed or encrypted")
        if sum(max(info.file_size, info.compress_size) for info in infos) > path.stat().st_size:
            raise self.damaged("the declared sizes of its members exceed the file size")
        if len(set(self.names)) < len(self.names):
            raise self.damaged("two of its members share a name")

    def damaged(self, why: object) -> PlacecatError:
        """Return the error for a damaged file. The reason, `why`, may itself be such an error."""
        start = f"{self._path} is damaged, or is not a placecat model: "
        said = " ".join(str(why).split()).removeprefix(start)
        return PlacecatError(start + said[:300])

    def content(self, name: str) -> bytes:
        """Read a member. Raises PlacecatError if it is missing or its checksum is wrong."""
        if name not in self.names:
            raise self.damaged(f"it has no member {name}")
        try:
            return self._archive.read(name)
        # RuntimeError includes NotImplementedError.
        except (zipfile.BadZipFile, EOFError, OSError, ValueError, RuntimeError) as error:
            raise self.damaged(f"its member {name} cannot be read ({error})") from None

    def array(self, name: str) -> NDArray[np.generic]:
        """Read an array of numbers, booleans or text from an ``.npy`` member, without using pickle.

        Raises PlacecatError if the member is not such an array, or if its header does not match its size.
        """
        content = self.content(name)
        header = _HEADER.match(content)
        if header is None:
            raise self.damaged(f"{name} has no array header")
        data = content[header.end() :]
        try:
            kind, shape = np.dtype(header[1].decode()), tuple(map(int, re.findall(rb"[0-9]+", header[2])))
            # Check the size before allocating memory.
            size = math.prod(shape) * kind.itemsize
            if size != len(data) or not kind.itemsize:
                raise ValueError(f"it declares {size} bytes but contains {len(data)}")
            return np.frombuffer(data, kind).reshape(shape).copy() if size else np.zeros(shape, kind)
        except (ValueError, TypeError) as error:
            raise self.damaged(f"the header of {name} is invalid ({error})") from None


def array_content(array: NDArray[np.generic]) -> bytes:
    """Encode an array for :meth:`Archive.array`."""
    buffer = io.BytesIO()
    # ascontiguousarray makes a scalar one-dimensional, and reshape undoes this.
    plain = np.ascontiguousarray(array).reshape(array.shape)
    np.lib.format.write_array(buffer, plain, version=(1, 0), allow_pickle=False)
    return buffer.getvalue()


def _check_seal(path: Path, file: BinaryIO) -> None:
    size = os.fstat(file.fileno()).st_size
    file.seek(max(0, size - len(_MARK) - _DIGITS))
    end = file.read()
    if not end.startswith(_MARK):
        if zipfile.is_zipfile(file):
            raise PlacecatError(
                f"{path} does not end with its checksum, so it was either modified or written by an earlier "
                f"version: {TRAIN_AGAIN}"
            )
        raise PlacecatError(f"{path} is not a placecat model, or is truncated: {TRAIN_AGAIN}")
    file.seek(0)
    digest, left = hashlib.sha256(), size - _DIGITS
    while left and (part := file.read(min(left, 1 << 20))):
        digest.update(part)
        left -= len(part)
    if digest.hexdigest().encode() != end[len(_MARK) :]:
        raise PlacecatError(
            f"{path} is damaged: its checksum does not match its contents; restore the file, or {TRAIN_AGAIN}"
        )
