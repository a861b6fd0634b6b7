"""Every piece of furniture and every texture is valid and reproducible."""

import importlib
import inspect
import pkgutil

import numpy as np
import pytest

from placecat_homes import furniture, textures
from placecat_homes.materials import Material, Texture
from placecat_homes.mesh import Mesh
from placecat_homes.style import Style


def makers():
    """All functions that return a mesh and require only (rng, style)."""
    for module in pkgutil.iter_modules(furniture.__path__):
        found = importlib.import_module(f"{furniture.__name__}.{module.name}")
        for name, function in vars(found).items():
            own = inspect.isfunction(function) and function.__module__ == found.__name__
            if name.startswith("_") or not own:
                continue
            parameters = list(inspect.signature(function).parameters.values())
            needed = [p.name for p in parameters if p.default is p.empty]
            if needed == ["rng", "style"] and inspect.signature(function).return_annotation is Mesh:
                yield pytest.param(function, id=f"{module.name}.{name}")


def make(function, seed):
    return function(np.random.default_rng(seed), Style.draw(np.random.default_rng(100 + seed)))


@pytest.mark.slow
@pytest.mark.parametrize("function", list(makers()))
def test_furniture(function):
    pieces = [make(function, seed) for seed in range(4)]
    for mesh in pieces:
        assert 0 < len(mesh.triangles) < 20_000
        for values in (mesh.vertices, mesh.normals, mesh.uv):
            assert np.isfinite(values).all()
        assert mesh.triangles.min() >= 0 and mesh.triangles.max() < len(mesh.vertices)
        assert mesh.material.max() < len(mesh.materials)
        assert (mesh.size < 6).all()
        # The piece stands or hangs around its origin.
        assert mesh.high[0] > -0.05 and mesh.low[0] < 0.05
    again = make(function, 0)
    assert np.array_equal(again.vertices, pieces[0].vertices)
    assert again.materials == pieces[0].materials


KINDS = [module.name for module in pkgutil.iter_modules(textures.__path__) if not module.name.startswith("_")]


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_textures(kind):
    colours = ((0.8, 0.3, 0.2), (0.2, 0.5, 0.7), (0.9, 0.9, 0.4), (0.3, 0.3, 0.3))
    picture = textures.draw(Texture(kind, colours, (1, 1), 3), 64)
    assert picture.shape == (64, 64, 3) and picture.dtype == np.uint8
    assert np.array_equal(picture, textures.draw(Texture(kind, colours, (1, 1), 3), 64))
    assert picture.std() > 0


def test_materials_are_compared_and_hashed_by_value():
    assert Material((1, 0, 0)) == Material((1, 0, 0))
    assert len({Material((1, 0, 0)), Material((1, 0, 0)), Material((0, 1, 0))}) == 2
