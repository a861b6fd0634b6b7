"""Find the code named in a setting: a module in a package, and the definitions in the module.

Settings use module names, so new files need no registration. Signatures are read from the source, because
importing packages such as scikit-learn takes seconds, and composing the settings must be quick.
"""

import ast
import builtins
import importlib
import importlib.util
import pkgutil
import sys
import typing
from collections import abc
from collections.abc import Collection, Iterator
from functools import lru_cache
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

import annotated_types

from placecat import ranges
from placecat.errors import PlacecatError, did_you_mean


class _Definition(NamedTuple):
    """A function or class in the source of a module."""

    module: str
    node: ast.FunctionDef | ast.ClassDef


def names(package: str, *defining: str) -> list[str]:
    """List the modules in a package that define all of `defining`; raise PlacecatError for invalid Python."""
    found = sorted(module.name for module in pkgutil.iter_modules(_locations(package)))
    return [name for name in found if _defines(package, name, defining)]


def require(package: str, name: object, what: str, *defining: str) -> str:
    """Return `name` if that module exists.

    If not, raises a PlacecatError that suggests the nearest name and lists all names. In this message, `what`
    describes `name`, for example as ``classifier.model``. `package` and `defining` are the same as for
    `names`.
    """
    # Try this module first, since listing all of them takes time.
    if not _defines(package, name, defining):
        valid = names(package, *defining)
        question = did_you_mean(name, valid)
        raise PlacecatError(f"{what} {name!r} does not exist{question}: use one of {', '.join(valid)}")
    return str(name)


def module(package: str, name: object, what: str, *defining: str) -> ModuleType:
    """Import a module; the parameters are the same as for `require`.

    Raises PlacecatError if `require` does, or if the import fails.
    """
    # Look in sys.modules first, since this is called for every frame.
    there = sys.modules.get(f"{package}.{name}")
    if there is not None and all(hasattr(there, one) for one in defining):
        return there
    require(package, name, what, *defining)
    try:
        return importlib.import_module(f"{package}.{name}")
    except ImportError as error:
        raise PlacecatError(f"{what} {name!r} cannot be imported: {' '.join(str(error).split())}") from None


def estimator(package: str, name: object, what: str) -> str:
    """Return the name of the only estimator in a module.

    Raises PlacecatError if `require` does, or if the module does not define exactly one estimator.
    """
    full = f"{package}.{require(package, name, what)}"
    classes = [node for node in _statements(full).values() if isinstance(node, ast.ClassDef)]
    public = [
        node.name
        for node in classes
        if not node.name.startswith("_") and not _is_abstract(node) and _is_estimator(full, node.name)
    ]
    if len(public) != 1:
        raise PlacecatError(
            f"{what} {name!r} is not an estimator: {full} must define one subclass "
            "of scikit-learn's BaseEstimator"
        )
    return public[0]


def parameters(package: str, name: str, definition: str) -> dict[str, tuple[bool, Any]]:
    """List the settings of a function or class without importing it.

    The settings of a function are its keyword-only parameters; those of a class are all parameters of
    ``__init__``. Maps each setting, in source order, to a pair: whether the setting is required, and its
    type. The result is empty if the module lacks `definition`. A type includes its range, if any
    (:mod:`placecat.ranges`). It is Any if the annotation uses anything but built-in types, :mod:`typing`, the
    ranges, and names defined in modules of placecat.
    """
    found = _taking(package, name, definition)
    if found is None:
        return {}
    return {
        argument.arg: (needed, _type(found.module, argument.annotation))
        for argument, needed in _settings(found)
    }


def entries(package: str, dictionary: str) -> dict[str, tuple[str, str]]:
    """List the entries of a dictionary such as ``FIGURES`` in all modules.

    Only entries whose value is a tuple that ends with a function are listed. Maps each key to the names of
    its module and its function. A lambda has no settings and gets the name "".
    """
    listed = {}
    for name in names(package, dictionary):
        for key, value in _literal(package, name, dictionary).items():
            if isinstance(value, ast.Tuple):
                last = value.elts[-1]
                listed[key] = (name, last.id if isinstance(last, ast.Name) else "")
    return listed


def keys(package: str, name: str, dictionary: str) -> list[str]:
    """List the keys of a dictionary literal in a module, without importing it."""
    return list(_literal(package, name, dictionary))


@lru_cache
def _locations(package: str) -> list[str]:
    # This imports the parent packages, but not the package itself.
    spec = importlib.util.find_spec(package)
    return list(spec.submodule_search_locations or []) if spec is not None else []


def _defines(package: str, name: object, definitions: Collection[str]) -> bool:
    """Return whether a package has a module of this name with these definitions."""
    file = _file(package, name)
    return file is not None and (
        not definitions or set(definitions) <= set(_parsed(file, file.stat().st_mtime_ns))
    )


def _file(package: str, name: object) -> Path | None:
    if not isinstance(name, str) or not name.isidentifier() or name.startswith("__"):
        return None
    ends = (f"{name}.py", f"{name}/__init__.py")
    files = (Path(folder, end) for folder in _locations(package) for end in ends)
    return next((file for file in files if file.is_file()), None)


def _statements(full_name: str) -> dict[str, ast.stmt]:
    """Map names to the top-level definitions, assignments and imports in a module."""
    package, _, name = full_name.rpartition(".")
    file = _file(package, name)
    return _parsed(file, file.stat().st_mtime_ns) if file is not None else {}


@lru_cache(maxsize=512)
def _parsed(file: Path, changed: int) -> dict[str, ast.stmt]:
    try:
        tree = ast.parse(file.read_bytes())
    except SyntaxError as error:
        raise PlacecatError(f"{file}, line {error.lineno}, is not Python: {error.msg}") from None
    found: dict[str, ast.stmt] = {}
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found[node.name] = node
        elif isinstance(node, ast.ImportFrom):
            found |= {alias.asname or alias.name: node for alias in node.names}
        elif isinstance(node, ast.Assign):
            found |= {target.id: node for target in node.targets if isinstance(target, ast.Name)}
    return found


def _literal(package: str, name: str, dictionary: str) -> dict[str, ast.expr]:
    node = _statements(f"{package}.{name}")[dictionary]
    if not isinstance(node, ast.Assign) or not isinstance(node.value, ast.Dict):
        return {}
    pairs = zip(node.value.keys, node.value.values, strict=True)
    return {str(key.value): value for key, value in pairs if isinstance(key, ast.Constant)}


def _resolve(full_name: str, name: str) -> _Definition | None:
    """Return a definition and its module, following imports; None if this package does not define it."""
    node = _statements(full_name).get(name)
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return _Definition(full_name, node)
    if isinstance(node, ast.ImportFrom) and node.module is not None and node.module.startswith("placecat"):
        original = next(alias.name for alias in node.names if (alias.asname or alias.name) == name)
        return _resolve(node.module, original)
    return None


def _ancestors(found: _Definition) -> Iterator[_Definition]:
    """Yield a definition and, for a class, its base classes in this package, nearest first."""
    yield found
    if isinstance(found.node, ast.ClassDef):
        for base in found.node.bases:
            above = _resolve(found.module, base.id) if isinstance(base, ast.Name) else None
            if above is not None:
                yield from _ancestors(above)


def _is_estimator(full_name: str, name: str) -> bool:
    found = _resolve(full_name, name)
    return found is not None and any(
        isinstance(base, ast.Name) and base.id == "BaseEstimator"
        for one in _ancestors(found)
        if isinstance(one.node, ast.ClassDef)
        for base in one.node.bases
    )


def _is_abstract(node: ast.ClassDef) -> bool:
    # Do not walk the entire class, since this is called for every model that is built.
    decorators = [one for item in node.body for one in getattr(item, "decorator_list", ())]
    return any(isinstance(one, ast.Name) and one.id == "abstractmethod" for one in decorators)


def _taking(package: str, name: str, definition: str) -> _Definition | None:
    """Return the function whose parameters are the settings, which is ``__init__`` for a class."""
    found = _resolve(f"{package}.{name}", definition)
    if found is None or isinstance(found.node, ast.FunctionDef):
        return found
    for one in _ancestors(found):
        for node in one.node.body:
            if isinstance(node, ast.FunctionDef) and node.name == "__init__":
                return _Definition(one.module, node)
    return None


def _settings(found: _Definition) -> Iterator[tuple[ast.arg, bool]]:
    """Yield each parameter that is a setting, and whether it is required."""
    node = found.node
    assert isinstance(node, ast.FunctionDef)
    if node.name == "__init__":
        positional = node.args.args[1:]
        given = len(positional) - len(node.args.defaults)
        yield from ((argument, index < given) for index, argument in enumerate(positional))
    for argument, default in zip(node.args.kwonlyargs, node.args.kw_defaults, strict=True):
        yield argument, default is None


class _Names(dict[str, Any]):
    """Maps names in annotations to types, ranges and constants of placecat."""

    def __init__(self, module: str) -> None:
        super().__init__(vars(typing) | vars(abc) | vars(builtins) | vars(annotated_types) | vars(ranges))
        self.module = module

    def __missing__(self, name: str) -> Any:
        node = _statements(self.module).get(name)
        if isinstance(node, ast.Assign):
            # The keys of a dictionary are names; its values may be anything.
            if isinstance(node.value, ast.Dict):
                return [_value(key, self) for key in node.value.keys]
            return _value(node.value, self)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("placecat"):
            original = next(alias.name for alias in node.names if (alias.asname or alias.name) == name)
            return _Names(str(node.module))[original]
        raise KeyError(name)


def _type(module: str, annotation: ast.expr | None) -> Any:
    if annotation is None:
        return Any
    try:
        return _value(annotation, _Names(module))
    except (AttributeError, KeyError, NameError, TypeError):
        return Any


def _value(node: ast.expr | None, names: _Names) -> Any:
    # This is safe, since the source is part of this program.
    assert node is not None
    return eval(compile(ast.Expression(node), "<annotation>", "eval"), {"__builtins__": {}}, names)
