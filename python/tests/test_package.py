"""The package: stubs, docstrings, optional packages."""

import dataclasses
import doctest
import importlib.resources
import inspect
import re
import runpy
import sys
from fractions import Fraction

import numpy as np
import pytest
from conftest import MACHINE

import grazing
from grazing import _arrays, _grazing


def test_every_public_name_is_documented():
    for name in grazing.__all__:
        thing = getattr(grazing, name)
        if inspect.isclass(thing) or callable(thing):
            assert inspect.getdoc(thing), name
    for cls in (grazing.Scene, grazing.Run, grazing.TaskReport, grazing.Intervals, grazing.Fractions, grazing.Shares,
                grazing.Classification, grazing.WordReport, grazing.WordCase, grazing.Motions):
        for name, member in inspect.getmembers(cls, inspect.isfunction):
            if not name.startswith("_"):
                assert inspect.getdoc(member), f"{cls.__name__}.{name}"


def test_the_stubs_have_the_signatures_of_the_compiled_part():
    text = importlib.resources.files("grazing").joinpath("_grazing.pyi").read_text()
    stubs = {}
    for name, arguments in re.findall(r"^(?:    )?def (\w+)\(\s*(.*?),?\s*\) ->", text, re.S | re.M):
        parts = re.split(r",\s*(?![^\[\]]*\])", arguments)
        stubs[name] = [part.split(":")[0].strip() for part in parts if part.strip()]
    seen = set()
    for scope in (_grazing, _grazing.Scene):
        for name in dir(scope):
            member = inspect.getattr_static(scope, name)
            if name.startswith("_") or inspect.isclass(getattr(scope, name)):
                continue
            assert name in stubs, f"{name} has no stub"
            seen.add(name)
            if inspect.isgetsetdescriptor(member):
                continue
            assert stubs[name] == list(inspect.signature(getattr(scope, name)).parameters), name
    assert seen == set(stubs)


def test_the_package_is_typed_and_has_its_style():
    files = importlib.resources.files("grazing")
    assert files.joinpath("py.typed").is_file()
    assert "axes.prop_cycle" in open(grazing.STYLE).read()
    matplotlib = pytest.importorskip("matplotlib")
    assert matplotlib.rc_params_from_file(grazing.STYLE, use_default_template=False)["image.origin"] == "lower"


def test_examples_of_docstrings():
    for module in (grazing, _arrays):
        found = doctest.testmod(module)
        assert found.failed == 0 and found.attempted > 0, module


def test_without_pandas_a_frame_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(grazing.MissingPackageError, match="pip install"):
        grazing.intervals(5).to_frame()
    assert issubclass(grazing.MissingPackageError, ImportError)


def test_frames_have_exact_numbers():
    pandas = pytest.importorskip("pandas")
    table = grazing.intervals("3..=5").to_frame()
    assert isinstance(table, pandas.DataFrame)
    assert list(table.columns) == ["n", "m", "sign_emu", "sign_gamma", "left", "right", "deciding"]
    assert table.left.iloc[1] == grazing.intervals("3..=5")[1].left
    assert len(grazing.classify(r=1, s="1/5").to_frame()) == 15


def test_frames_of_lists_keep_whole_numbers_and_fractions():
    pytest.importorskip("pandas")
    edges = grazing.boundary("5..=6")
    table = grazing.frame(edges)
    assert list(table.columns) == ["n", "m", "case", "deciding", "kind", "s", "r"]
    assert str(table.deciding.dtype) == "Int64" and table.deciding.isna().tolist() == [e.deciding is None for e in edges]
    assert table.r.tolist() == [edge.r for edge in edges] and isinstance(table.r[1][0], Fraction)
    floats = grazing.frame(edges, floats=True)
    assert floats.r.tolist() == [tuple(map(float, edge.r)) for edge in edges]
    values = grazing.frame(grazing.evaluate(5, r=1, s="1/7"))
    assert values.k.tolist()[:-1] == [1, 2, 3, 4] and values.k.isna().tolist()[-1]
    shares = grazing.frame(grazing.shares(r="0.97", s=("1/5", "21/100"), cells=40))
    assert shares.lower.dtype == object and all(isinstance(share, Fraction) for share in shares.lower)
    assert (grazing.frame(grazing.intervals(5), floats=True).left == [0.0, 0.1, 0.2, 1 / 3, 0.4]).all()
    report = grazing.word(r="0.97", s="0.31")
    words = report.to_frame()
    for (_, row), case in zip(words.iterrows(), [case for word in report.words for case in word.cases]):
        assert (row.sign_emu, row.sign_gamma, row.loops) == (*case.case, case.loops)
        assert case.entropy is None or (row.entropy_lower, row.entropy_upper) == case.entropy
    assert len(grazing.frame([])) == 0


def test_motions_are_frames_and_datasets():
    pytest.importorskip("pandas")
    motions = grazing.Scene(MACHINE).simulate([0.0, 0.5], 6, every=3, parameters={"F": [0.25, 0.75]})
    table = motions.to_frame()
    assert list(table.columns) == ["motion", "period", "F", "q", "u"]
    assert table.motion.tolist() == [0, 0, 0, 1, 1, 1] and table.period.tolist() == [0, 3, 6] * 2
    assert table.F.tolist() == [0.25] * 3 + [0.75] * 3 and (table.u == motions.u.ravel()).all()
    pytest.importorskip("xarray")
    labelled = motions.to_xarray()
    assert labelled.q.dims == ("motion", "period") and (labelled.u.sel(period=3) == motions.u[:, 1]).all()
    assert labelled.F.values.tolist() == [0.25, 0.75] and (labelled.impacts == motions.impacts).all()


def test_grids_are_datasets(root):
    xarray = pytest.importorskip("xarray")
    basins, map_, orbit = grazing.Scene(root / "tests/data/kinds.toml").run(["basins", "map", "orbit"])
    # Each cell tells itself from the others.
    cells = np.arange(9).reshape(3, 3)
    grid = dataclasses.replace(basins, data=grazing.Record({**basins.data, "cells": cells})).to_xarray()
    assert isinstance(grid, xarray.Dataset)
    for j, u in enumerate(basins.data.u):
        for i, q in enumerate(basins.data.q):
            assert grid.cells.sel(u=u, q=q).item() == cells[j, i]
    grid = map_.to_xarray()
    assert set(grid.data_vars) == {"period", "impacts", "exponent"} and grid.period.shape == (2, 3)
    assert (grid.first == map_.data.first).all()
    with pytest.raises(grazing.InputError, match="no arrays on a grid; those of kind basins, map have"):
        orbit.to_xarray()


def test_without_xarray_a_dataset_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "xarray", None)
    motions = grazing.Scene(MACHINE).simulate([0.0, 0.0], 1)
    with pytest.raises(grazing.MissingPackageError, match="pip install 'grazing\\[labels\\]'"):
        motions.to_xarray()


def test_a_record_is_read_by_name():
    record = grazing.Record({"a": 1, "b": {"c": [1, {"d": 2}]}})
    assert record.b.c[1].d == 2 and record["a"] == 1 and list(record) == ["a", "b"]
    with pytest.raises(AttributeError, match="there is a, b"):
        record.x
    with pytest.raises(AttributeError):
        record.a = 2


def test_version():
    assert re.fullmatch(r"\d+\.\d+\.\d+", grazing.__version__)


def test_every_mutant_is_a_change_of_the_sources_and_names_a_test(root):
    # The list of python/mutants.py keeps up with what it changes; python/mutants.sh runs it.
    names = runpy.run_path(str(root / "python/mutants.py"))
    mutants = names["MUTANTS"]
    assert len({mutant.name for mutant in mutants}) == len(mutants) >= 25
    for mutant in mutants:
        text = (root / "python" / mutant.file).read_text()
        assert text.count(mutant.old) == 1 and mutant.old != mutant.new, mutant.name
        file, test = mutant.test.split("::")
        assert f"def {test}(" in (root / "python/tests" / file).read_text(), mutant.name
