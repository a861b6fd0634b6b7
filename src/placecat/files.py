"""Read and write result files. Writes are atomic, and the same content always produces the same bytes.

NumPy and pandas are imported late, because commands that only write settings must start quickly.
"""

import hashlib
import io
import json
import os
import secrets
import shutil
import zipfile
from collections.abc import Collection, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from placecat.errors import PlacecatError, is_refusal, refusal

if TYPE_CHECKING:
    import numpy as np
    import pandas as pd


@contextmanager
def replacing(target: Path) -> Iterator[Path]:
    """Yield a temporary path next to `target`; rename it to `target` if the block succeeds, else delete it.

    The block creates a file or a folder at that path. Either may replace a file at `target`, but only a
    folder may replace a folder. Raises PlacecatError if :func:`check_target` does, if a file would replace a
    folder, or if writing fails, for example because the disk is full.
    """
    target = Path(target)
    check_target(target)
    target.parent.mkdir(parents=True, exist_ok=True)
    temporary = _temporary(target)
    try:
        yield temporary
        if temporary.is_dir():
            _remove(target)
        else:
            check_file(target)
        temporary.replace(target)
    except BaseException as error:
        _remove(temporary)
        if isinstance(error, OSError) and is_refusal(error):
            # An error while writing to an open file does not name the file.
            of = temporary if error.filename is None else Path(os.fsdecode(error.filename))
            if of.is_relative_to(temporary):
                raise PlacecatError(f"cannot write {refusal(error, target)}") from error
        raise


def check_target(target: Path) -> None:
    """Raise PlacecatError if a path is or contains the current folder, or has no name (``.``, ``..``)."""
    if target.name in ("", ".", "..") or Path.cwd().is_relative_to(target.resolve()):
        raise PlacecatError(f"{target} is or contains a folder that is in use: choose another name")


def check_file(target: Path) -> None:
    """Raise PlacecatError if a path is a folder, device or pipe, or if :func:`check_target` rejects it."""
    check_target(target)
    if target.is_dir():
        raise PlacecatError(f"{target} is a folder: specify a file name")
    if target.exists() and not target.is_file():
        raise PlacecatError(f"{target} is not a regular file: choose another name")


def check_writable(target: Path) -> None:
    """Check in advance that a file can be written; raise PlacecatError if it cannot."""
    check_file(target)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        temporary = _temporary(target)
        temporary.touch()
        temporary.unlink()
    except OSError as error:
        raise PlacecatError(f"cannot write {refusal(error, target)}") from None


def _temporary(target: Path) -> Path:
    # The suffix stays last, since NumPy and pandas use it to choose the format. The name is unique.
    # placecat.runs.mend removes such files if a process was killed.
    return target.with_name(f".{target.stem}.{secrets.token_hex(4)}.partial{target.suffix}")


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def existing(path: Path) -> Path:
    """Return the path of a stage output; raise PlacecatError if the stage has not run."""
    if not path.exists():
        raise PlacecatError(f"{path} is missing: run `dvc repro` to create it")
    return path


def checksum(path: Path) -> str:
    """Return the SHA-256 checksum of a file in hexadecimal."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def write_array(path: Path, array: "np.ndarray") -> None:
    """Write one array as ``.npy``, never with pickle."""
    import numpy as np

    with replacing(path) as temporary:
        np.save(temporary, np.ascontiguousarray(array), allow_pickle=False)


def read_array(path: Path, *, memory_map: bool = True) -> "np.ndarray":
    """Read one ``.npy`` array, memory-mapped by default, never with pickle."""
    import numpy as np

    return np.load(path, mmap_mode="r" if memory_map else None, allow_pickle=False)


def write_arrays(path: Path, arrays: Mapping[str, "np.ndarray"]) -> None:
    """Write named arrays as one ``.npz``, never with pickle."""
    import numpy as np

    for name, array in arrays.items():
        if np.asarray(array).dtype.hasobject:
            raise TypeError(f"array {name!r} contains Python objects, which need pickle")
    # Avoid numpy.savez: its headers depend on the Python version.
    with replacing(path) as temporary, zipfile.ZipFile(temporary, "w") as archive:
        for name, array in arrays.items():
            content = io.BytesIO()
            np.lib.format.write_array(content, np.asarray(array), allow_pickle=False)
            archive.writestr(zipfile.ZipInfo(f"{name}.npy"), content.getvalue())


def read_arrays(path: Path) -> "dict[str, np.ndarray]":
    """Read all arrays of one ``.npz``, never with pickle."""
    import numpy as np

    with np.load(path, allow_pickle=False) as archive:
        return {name: archive[name] for name in archive.files}


def write_json(path: Path, content: Any) -> None:
    """Write sorted, indented JSON with a final newline."""
    with replacing(path) as temporary:
        temporary.write_text(json.dumps(content, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def read_json(path: Path) -> Any:
    """Read a JSON file written by this project."""
    return json.loads(Path(path).read_text(encoding="utf-8"))


def write_csv(path: Path, table: "pd.DataFrame") -> None:
    """Write a table as a CSV file without an index, with the same line endings on every system."""
    with replacing(path) as temporary:
        table.to_csv(temporary, index=False, lineterminator="\n")


def read_table(path: Path, text: Collection[str] = ()) -> "pd.DataFrame":
    """Read a CSV file of numbers and text.

    Cells in the columns `text` are kept as they are, for example "NA"; empty cells in other columns are NaN.
    """
    import pandas as pd

    if not path.is_file():
        raise PlacecatError(f"{path} is missing: run `dvc repro` to create it, or restore it from git")
    numbers = [name for name in pd.read_csv(path, nrows=0) if name not in text]
    empty = {str(name): [""] for name in numbers}
    return pd.read_csv(path, dtype=dict.fromkeys(text, str), keep_default_na=False, na_values=empty)


def read_cells(path: Path) -> "pd.DataFrame":
    """Read a CSV file and keep every cell as text, since home names can look like numbers."""
    import pandas as pd

    return pd.read_csv(existing(path), dtype=str, keep_default_na=False)


def write_text(path: Path, text: str) -> None:
    """Write UTF-8 text."""
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")
