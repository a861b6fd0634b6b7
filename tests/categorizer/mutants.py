"""Randomly damaged model files and their outcomes, for tests and for larger fuzzing campaigns."""

import io
import json
import zipfile

import numpy as np

from placecat.categorizer import Categorizer, archive
from placecat.errors import PlacecatError

ODD = [
    None,
    True,
    -1,
    0,
    3,
    10**9,
    10**400,
    -0.5,
    1e308,
    "",
    "x",
    "../..",
    [],
    {},
    [[[]]],
    "kernel",
    {"$": "array"},
]


def damaged(content, rng):
    """Damage bytes as a disk or network might: flip a bit, truncate them, or zero, drop or repeat a part."""
    data = bytearray(content)
    at, length = int(rng.integers(len(data))), int(rng.integers(1, 2000))
    kind = rng.integers(5)
    if kind == 0:
        data[at] ^= 1 << int(rng.integers(8))
    elif kind == 1:
        del data[at:]
    elif kind == 2:
        data[at : at + length] = bytes(len(data[at : at + length]))
    elif kind == 3:
        del data[at : at + length]
    else:
        data[at:at] = data[at : at + length]
    return bytes(data)


def forged(path, rng):
    """Rewrite a model file with one change and a correct checksum, as an attacker could."""
    with zipfile.ZipFile(path) as file:
        members = {name: file.read(name) for name in file.namelist()}
    texts = ["card.json", "system.json"]
    arrays = [name for name in members if name.endswith(".npy")]
    kind = rng.integers(4)
    if kind == 0:
        name = str(rng.choice(list(members)))
        members[name] = damaged(members[name], rng)
    elif kind == 1:
        name = str(rng.choice(texts))
        members[name] = json.dumps(_other_leaf(json.loads(members[name]), rng)).encode()
    elif kind == 2:
        name = str(rng.choice(arrays))
        members[name] = _other_array(np.load(io.BytesIO(members[name])), rng)
    else:
        one, other = rng.choice(list(members), 2)
        members[str(one)] = members[str(other)]
    archive.write(path, members)


def _other_leaf(content, rng):
    """Change, remove or add one value somewhere in the JSON content."""
    places = []

    def collect(here):
        items = here.items() if isinstance(here, dict) else enumerate(here) if isinstance(here, list) else ()
        for key, value in items:
            places.append((here, key))
            collect(value)

    collect(content)
    here, key = places[rng.integers(len(places))]
    kind = rng.integers(4)
    if kind == 0:
        del here[key]
    elif kind == 1 and isinstance(here, dict):
        here["another"] = here[key]
    elif kind == 2 and isinstance(here[key], int | float) and not isinstance(here[key], bool):
        here[key] = here[key] * float(rng.choice([-1, 2, 0.5])) if rng.integers(2) else here[key] + 1
    else:
        here[key] = ODD[rng.integers(len(ODD))]
    return content


def _other_array(array, rng):
    kind = rng.integers(5)
    if kind == 0 and array.size and array.dtype.kind == "f":
        array.flat[rng.integers(array.size)] = rng.choice([np.nan, np.inf, -1e30])
    elif kind == 1 and array.size and array.dtype.kind in "iu":
        array.flat[rng.integers(array.size)] = rng.choice([0, 1, 99, np.iinfo(array.dtype).max])
    elif kind == 2 and array.ndim:
        array = array[: rng.integers(len(array) + 1)]
    elif kind == 3:
        array = array.astype(rng.choice(["f2", "f8", "i2", "U5", "?"]))
    else:
        array = array[None] if rng.integers(2) else np.concatenate([array.ravel()] * 2)
    return archive.array_content(array)


def decisions(path, frames):
    categorizer = Categorizer.load(path)
    return np.stack([categorizer.update(frame).proba for frame in frames])


def outcome(path, frames, expected, *, is_forged):
    """Return the outcome of a changed file: ``refused``, ``same``, ``other``, or a description of the error.

    A rejection must have a clear one-line message. A forged file may be another valid model, so only its
    distributions are checked.
    """
    try:
        found = decisions(path, frames)
    except PlacecatError as error:
        said = str(error)
        # A forged file may be for frames of another size.
        is_clear = (str(path) in said or said.startswith("a frame is")) and "\n" not in said
        return "refused" if is_clear else f"unclear: {said}"
    except Exception as error:
        return f"traceback: {error!r}"
    if np.array_equal(found, expected):
        return "same"
    proper = np.isfinite(found).all() and found.min() >= 0 and np.allclose(found.sum(axis=1), 1)
    return "other" if is_forged and proper else "wrong"
