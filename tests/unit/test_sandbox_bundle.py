"""The fork server's code on its way into the container."""

from __future__ import annotations

import importlib.machinery
import marshal

import pytest

from judge.sandbox import bundle


class Hook:
    """Like pytest's, which rewrites the asserts of a package that brings a plug-in: it hands out no code."""


@pytest.fixture(autouse=True)
def unpacked_once():
    bundle._modules.cache_clear()
    yield
    bundle._modules.cache_clear()


def test_the_code_is_that_of_the_files_whoever_imported_them(monkeypatch):
    plain, config, source = marshal.loads(bundle.pack({"a": 1}, b"pass"))
    assert (config, source) == ({"a": 1}, b"pass")
    assert plain[-1][0] == "judge.sandbox.inside.server"

    real = bundle.find_spec

    def hooked(name):
        spec = real(name)
        return importlib.machinery.ModuleSpec(name, Hook(), origin=spec.origin)

    monkeypatch.setattr(bundle, "find_spec", hooked)
    bundle._modules.cache_clear()
    assert marshal.loads(bundle.pack({}, b""))[0] == plain


def test_a_module_without_code_is_told(monkeypatch):
    monkeypatch.setattr(bundle, "find_spec", lambda name: None)
    with pytest.raises(ImportError, match=r"no code for judge\.sandbox"):
        bundle.pack({}, b"")
