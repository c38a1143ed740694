"""The person's folders are those that platformdirs names, whichever way they are found."""

from __future__ import annotations

import sys

import platformdirs
import pytest

from judge.folders import cache_folder, user_data

SETTINGS = [
    {},
    {"HOME": "/home/ann"},
    {"HOME": "/home/ann/"},
    {"HOME": "relative"},
    {"HOME": ""},
    {"HOME": "/home/ann", "XDG_CACHE_HOME": "/var/c", "XDG_DATA_HOME": "/var/d"},
    {"HOME": "/home/ann", "XDG_CACHE_HOME": "c", "XDG_DATA_HOME": "~/d"},
    {"HOME": "/home/ann", "XDG_CACHE_HOME": "", "XDG_DATA_HOME": " "},
    {"XDG_CACHE_HOME": "/c", "XDG_DATA_HOME": "/d//e/"},
]


@pytest.fixture(params=SETTINGS, ids=str)
def _settings(request, monkeypatch):
    for name in ("JUDGE_CACHE", "HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"):
        monkeypatch.delenv(name, raising=False)
    for name, value in request.param.items():
        monkeypatch.setenv(name, value)


@pytest.mark.usefixtures("_settings")
@pytest.mark.parametrize("system", [sys.platform, "darwin"])
def test_they_are_as_platformdirs_has_them(system, monkeypatch):
    monkeypatch.setattr("judge.folders.sys.platform", system)
    assert cache_folder() == platformdirs.user_cache_path("circle-line-judge", appauthor=False)
    assert user_data() == platformdirs.user_data_path("circle-line-judge", appauthor=False)
