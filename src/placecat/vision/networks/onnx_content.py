"""Check the operators and weight files of an ONNX file before running it.

This module parses the file itself, because protocol buffers are just numbered fields, and nothing else would
need the onnx package.
"""

import hashlib
import mmap
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

from placecat.errors import PlacecatError
from placecat.files import checksum

# Fields of ModelProto, FunctionProto, GraphProto, NodeProto, AttributeProto and TensorProto.
_GRAPH, _FUNCTIONS = 7, 25
_FUNCTION_NODE = 7
_NODE, _INITIALIZER, _SPARSE = 1, 5, 15
_INPUT, _OPERATOR, _ATTRIBUTE = 1, 4, 5
_TENSOR, _SUBGRAPH, _TENSORS, _SUBGRAPHS, _SPARSE_TENSOR, _SPARSE_TENSORS = 5, 6, 10, 11, 22, 23
_VALUES, _INDICES = 1, 2
_EXTERNAL = 13
_KEY, _VALUE = 1, 2

# Maps each kind of message to the fields that contain other messages, and each of these fields to the kind of
# message that it contains.
_INSIDE = {
    "model": {_GRAPH: "graph", _FUNCTIONS: "function"},
    "function": {_FUNCTION_NODE: "node"},
    "graph": {_NODE: "node", _INITIALIZER: "tensor", _SPARSE: "sparse"},
    "node": {_ATTRIBUTE: "attribute"},
    "attribute": {
        _TENSOR: "tensor",
        _TENSORS: "tensor",
        _SUBGRAPH: "graph",
        _SUBGRAPHS: "graph",
        _SPARSE_TENSOR: "sparse",
        _SPARSE_TENSORS: "sparse",
    },
    "sparse": {_VALUES: "tensor", _INDICES: "tensor"},
    "tensor": {_EXTERNAL: "entry"},
    "entry": {},
}

_TEXTS = {"node": (_INPUT, _OPERATOR), "entry": (_KEY, _VALUE)}

# Operators whose output differs between runs.
_RANDOM = ("Random", "Multinomial", "Bernoulli", "Sampling")
# Operators that may loop forever.
_ENDLESS = ("Loop", "BeamSearch", "GreedySearch", "WhisperBeamSearch")
# A third input switches Dropout to training mode, in which it is random.
_DROPOUT, _TRAINING = "Dropout", 2


def check(path: Path, sha256: str | None) -> None:
    """Reject a network that is random, may never terminate, or differs from the expected file.

    `sha256` is the expected :func:`fingerprint`, or None to accept any. Raises PlacecatError if the file
    cannot be read or is not an ONNX file, if it has an operator that is random or may loop forever, if its
    checksum is wrong, or if its weight files are missing or outside its folder.
    """
    try:
        operators, weights = _content(path)
        for name, inputs in operators:
            is_training = name == _DROPOUT and len(inputs) > _TRAINING and inputs[_TRAINING] != ""
            if name.startswith(_RANDOM) or is_training:
                raise PlacecatError(
                    f"{path} uses the operator {name}, which is random: export the network for inference"
                )
            if name in _ENDLESS:
                raise PlacecatError(
                    f"{path} uses the operator {name}, which may never terminate: export the network "
                    "without it"
                )
        files = [_weights(path, name) for name in weights]
        if sha256 is not None and (found := fingerprint(path, files)) != sha256:
            raise PlacecatError(f"{path} has the SHA-256 {found}, not {sha256}: it is not the expected file")
    except OSError as error:
        raise PlacecatError(f"{path} cannot be read: {error.strerror or error}") from None


def fingerprint(path: Path, weights: list[Path]) -> str:
    """Return a network's SHA-256 in hexadecimal, computed over all its files.

    If there are several files, this is the SHA-256 of the output of ``sha256sum NETWORK WEIGHTS...``, run in
    their folder with the weight files sorted by name.
    """
    if not weights:
        return checksum(path)
    names = [path.name, *(file.relative_to(path.parent).as_posix() for file in weights)]
    lines = [f"{checksum(path.parent / name)}  {name}\n" for name in names]
    return hashlib.sha256("".join(lines).encode()).hexdigest()


def _weights(path: Path, name: str) -> Path:
    """Return the path of a weight file, which must be in the network's folder."""
    relative, folder = PurePosixPath(name), path.parent
    file = folder / relative
    if not relative.parts or relative.is_absolute() or ".." in relative.parts or "\\" in name or "\0" in name:
        raise PlacecatError(f"{path} has weights in {name!r}, outside its folder: move them into its folder")
    if not file.is_file():
        raise PlacecatError(f"{file}, which holds the weights of {path.name}, is missing: add it")
    if not file.resolve().is_relative_to(folder.resolve()):
        raise PlacecatError(
            f"{file}, which holds weights of {path.name}, links to a file outside the folder: replace it "
            "with a copy"
        )
    return file


def _content(path: Path) -> tuple[list[tuple[str, list[str]]], list[str]]:
    """Return the operators with their inputs, and the sorted names of the weight files."""
    operators: list[tuple[str, list[str]]] = []
    weights: set[str] = set()
    has_graph = False
    with path.open("rb") as file:
        if not file.seek(0, 2):
            raise PlacecatError(f"{path} is not an ONNX file: it is empty")
        with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
            # Visit nested messages at any depth without recursion.
            waiting = [("model", 0, len(content))]
            try:
                while waiting:
                    kind, start, end = waiting.pop()
                    texts: dict[int, list[str]] = {}
                    for number, first, last in _fields(content, start, end):
                        inner = _INSIDE[kind].get(number)
                        if inner is not None:
                            waiting.append((inner, first, last))
                        elif number in _TEXTS.get(kind, ()):
                            texts.setdefault(number, []).append(content[first:last].decode())
                    has_graph = has_graph or kind == "graph"
                    if kind == "node":
                        operators.append((texts.get(_OPERATOR, [""])[-1], texts.get(_INPUT, [])))
                    elif kind == "entry" and texts.get(_KEY, [""])[-1] == "location":
                        weights.add(texts.get(_VALUE, [""])[-1])
            except ValueError as error:
                raise PlacecatError(f"{path} is not an ONNX file or is damaged: {error}") from None
    if not has_graph:
        raise PlacecatError(f"{path} is not an ONNX file: it contains no network")
    return operators, sorted(weights)


def _fields(content: mmap.mmap, at: int, end: int) -> Iterator[tuple[int, int, int]]:
    """Yield the number, start and end of each length-delimited field.

    Raises ValueError if the file is damaged.
    """
    while at < end:
        key, at = _varint(content, at, end)
        number, kind = key >> 3, key & 7
        if kind == 0:
            _, at = _varint(content, at, end)
        elif kind == 1:
            at += 8
        elif kind == 5:
            at += 4
        elif kind == 2:
            length, at = _varint(content, at, end)
            if length > end - at:
                raise ValueError("it is truncated")
            yield number, at, at + length
            at += length
        else:
            raise ValueError(f"it has a field of unknown kind {kind}")
    if at > end:
        raise ValueError("it is truncated")


def _varint(content: mmap.mmap, at: int, end: int) -> tuple[int, int]:
    value = 0
    for shift in range(0, 70, 7):
        if at >= end:
            raise ValueError("it is truncated")
        byte = content[at]
        at += 1
        value |= (byte & 127) << shift
        if byte < 128:
            return value, at
    raise ValueError("it has a number with too many bytes")
