"""The notebooks run as they stand, and show what they say: each cell's text is compared with the one kept.

A small runner instead of jupyter's: what a cell prints and the value of its last expression. Pictures are
drawn, not compared.
"""

import ast
import contextlib
import io
import json
import re
from pathlib import Path

import pytest

NOTEBOOKS = sorted((Path(__file__).resolve().parents[1] / "notebooks").glob("*.ipynb"))


def test_there_are_five():
    assert [path.stem for path in NOTEBOOKS] == ["accuracy", "fuzzing", "intervals", "my-machine", "tolerances"]


def kept(cell):
    """The text that a cell's outputs show."""
    text = ""
    for output in cell["outputs"]:
        assert output["output_type"] != "error", output
        if output["output_type"] == "stream" and output["name"] == "stdout":
            text += "".join(output["text"])
        elif output["output_type"] == "execute_result":
            text += "".join(output["data"]["text/plain"]) + "\n"
    return text


def run(source, names):
    """What the code shows."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    shown = io.StringIO()
    with contextlib.redirect_stdout(shown):
        exec(compile(tree, "cell", "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
            if value is not None:
                print(repr(value))
    return shown.getvalue()


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_and_shows_what_it_keeps(path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    names = {"__name__": "__main__"}
    cells = [cell for cell in json.loads(path.read_text())["cells"] if cell["cell_type"] == "code"]
    assert cells
    for cell in cells:
        shown = run("".join(cell["source"]), names)
        # A frame's width depends on pandas; a picture's name on matplotlib.
        same = lambda text: re.sub(r"\s+", " ", text).strip()  # noqa: E731
        assert same(shown) == same(kept(cell)), "".join(cell["source"])
    import matplotlib.pyplot as plt

    plt.close("all")
