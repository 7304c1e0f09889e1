"""The package: stubs, docstrings, optional packages."""

import doctest
import importlib.resources
import inspect
import re
import runpy
import sys

import pytest

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
