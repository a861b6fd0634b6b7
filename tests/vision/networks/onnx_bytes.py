"""Small ONNX files written by hand, because nothing else needs the package onnx."""

from collections.abc import Sequence

# Wire types of protocol buffers.
VARINT, BYTES = 0, 2
FLOAT = 1


def varint(value: int) -> bytes:
    out = bytearray()
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    return bytes([*out, value])


def field(number: int, value: int | str | bytes) -> bytes:
    if isinstance(value, int):
        return varint(number << 3 | VARINT) + varint(value)
    content = value.encode() if isinstance(value, str) else value
    return varint(number << 3 | BYTES) + varint(len(content)) + content


def node(kind: str, inputs: Sequence[str], output: str, *attributes: bytes) -> bytes:
    own = b"".join(field(1, one) for one in inputs) + field(2, output) + field(4, kind)
    return own + b"".join(field(5, one) for one in attributes)


def subgraph(name: str, *nodes: bytes) -> bytes:
    """Return an attribute that contains a graph."""
    return field(1, name) + field(6, b"".join(field(1, one) for one in nodes)) + field(20, 5)


def stored_elsewhere(name: str, length: int, location: str) -> bytes:
    """Return a tensor whose numbers are stored in another file."""
    entries = [field(1, "location") + field(2, location), field(1, "length") + field(2, str(4 * length))]
    return (
        field(1, length)
        + field(2, FLOAT)
        + field(8, name)
        + b"".join(field(13, one) for one in entries)
        + field(14, 1)
    )


def value(name: str, shape: Sequence[int | str], kind: int = FLOAT) -> bytes:
    """Return a named tensor description. Dimensions of variable size have names instead of numbers."""
    sides = b"".join(field(1, field(1 if isinstance(side, int) else 2, side)) for side in shape)
    return field(1, name) + field(2, field(1, field(1, kind) + field(2, sides)))


def model(
    nodes: Sequence[bytes], inputs: Sequence[bytes], outputs: Sequence[bytes], weights: Sequence[bytes] = ()
) -> bytes:
    graph = b"".join(field(1, one) for one in nodes) + field(2, "graph")
    graph += b"".join(field(5, one) for one in weights)
    graph += b"".join(field(11, one) for one in inputs) + b"".join(field(12, one) for one in outputs)
    return field(1, 8) + field(7, graph) + field(8, field(1, "") + field(2, 13))


def mean_color(height: int | str = "height", width: int | str = "width") -> bytes:
    """Return a model with two outputs: ``vector``, the (1, 3) channel means, and ``places``, the image."""
    return model(
        [
            node("Identity", ["image"], "places"),
            node("GlobalAveragePool", ["image"], "pooled"),
            node("Flatten", ["pooled"], "vector"),
        ],
        [value("image", [1, 3, height, width])],
        [value("vector", [1, 3]), value("places", [1, 3, height, width])],
    )


def scaled_mean_color(location: str, *nodes: bytes) -> bytes:
    """Return a model that multiplies the (1, 3) channel means by three weights in another file."""
    return model(
        [
            node("GlobalAveragePool", ["image"], "pooled"),
            node("Flatten", ["pooled"], "means"),
            node("Mul", ["means", "weights"], "vector"),
            *nodes,
        ],
        [value("image", [1, 3, "height", "width"])],
        [value("vector", [1, 3])],
        [stored_elsewhere("weights", 3, location)],
    )
