"""Scenes: read, changed, run, followed by the thousand."""

import json
import subprocess
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from conftest import MACHINE

import grazing


def test_a_dict_means_what_the_file_means():
    text = """
format = "grazing-scene 1"
title = "a driven mass and a stop"
[parameters]
F = 0.5
[system]
damping = "1/10"
stiffness = "3/10"
forcing = [{ cos = "F" }]
[[walls]]
side = "upper"
offset = 1
restitution = 0.8
[[tasks]]
name = "first-touch"
kind = "grazing"
parameter = "F"
[[tasks]]
name = "after"
kind = "simulate"
group = "motion"
set = { F = 0.8 }
start = { q = 0 }
periods = 40
"""
    one, two = grazing.Scene(text), grazing.Scene(MACHINE)
    for scene in (one, two):
        assert scene.parameters == {"F": Fraction(1, 2)}
        assert [task.name for task in scene.tasks] == ["first-touch", "after"]
        assert scene.tasks[1].set == {"F": Fraction(4, 5)}
        assert "F = 1/2" in repr(scene)
    a, b = one.run("after")["after"], two.run("after")["after"]
    assert a.findings == b.findings
    assert (a.data.q == b.data.q).all() and len(a.data.q) > 40
    exact = grazing.Scene({**MACHINE, "parameters": {"F": Decimal("0.50")}})
    assert exact.parameters == {"F": Fraction(1, 2)}
    assert grazing.Scene(two.text).parameters == two.parameters


def test_a_run_gives_typed_reports():
    run = grazing.Scene(MACHINE).run()
    assert len(run) == 2 and "first-touch (grazing): Done" in repr(run)
    touch = run["first-touch"]
    assert isinstance(touch.outcome, grazing.Done)
    assert isinstance(run.outcome, grazing.Done)
    assert "first-touch" in str(touch)
    motion = run["after"]
    assert motion.parameters == {"F": Fraction(4, 5)}
    impacts = motion.data.event_kind == grazing.EVENT_KINDS.index("impact")
    assert impacts.sum() == motion.findings.impacts > 0
    # The scene's one stop.
    assert (motion.data.event_place[impacts] == 0).all()
    assert (np.diff(motion.data.event_time) > 0).all()
    assert motion.data.q.max() <= 1 + 1e-9
    assert motion.effects["impacts"] if "impacts" in motion.effects else motion.effects
    with pytest.raises(KeyError, match="first-touch"):
        run["nothing"]
    with pytest.raises(grazing.InputError, match="first-touch, after"):
        grazing.Scene(MACHINE).run("nothing")
    assert [report.task for report in grazing.Scene(MACHINE).run("motion")] == ["after"]


def test_values_are_changed_exactly():
    scene = grazing.Scene(MACHINE).with_parameters(F="2/3")
    assert scene.parameters == {"F": Fraction(2, 3)}
    report = grazing.Scene(MACHINE).run("first-touch", set={"F": Fraction(2, 3)})[0]
    assert report.parameters == {"F": Fraction(2, 3)}
    with pytest.raises(grazing.InputError, match='no parameter "G"'):
        grazing.Scene(MACHINE).with_parameters(G=1)


def test_errors_have_file_line_key_value_and_fix(tmp_path):
    path = tmp_path / "machine.toml"
    good = grazing.Scene(MACHINE).text
    path.write_text(good.replace('"3/10"', '"3/10x"'))
    with pytest.raises(grazing.InputError) as raised:
        grazing.Scene(path)
    error = raised.value
    line = 1 + path.read_text()[: path.read_text().index("3/10x")].count("\n")
    assert (error.file, error.line, error.key, error.value) == (str(path), line, "system.stiffness", '"3/10x"')
    assert isinstance(error, ValueError) and str(error).startswith(f"{path}:{line}: ")
    path.write_text(good.replace("damping", "dampng"))
    with pytest.raises(grazing.InputError) as raised:
        grazing.Scene(path)
    assert raised.value.fix == 'the nearest known key is "damping"'
    with pytest.raises(grazing.FileError) as raised:
        grazing.Scene(tmp_path / "none.toml")
    assert raised.value.errno == 2 and raised.value.file == str(tmp_path / "none.toml")
    for value in [float("nan"), float("inf"), object(), {1: 2}]:
        with pytest.raises(grazing.InputError):
            grazing.Scene({**MACHINE, "parameters": {"F": value}})


def test_a_task_that_finds_nothing_does_not_end_the_rest():
    tasks = [
        {"name": "none", "kind": "orbit", "set": {"F": 0.001}, "orbit": {"pattern": [1], "starts": 20}},
        MACHINE["tasks"][1],
    ]
    run = grazing.Scene({**MACHINE, "tasks": tasks}).run()
    assert isinstance(run[0].outcome, grazing.NothingFound) and run[0].outcome.reason
    assert isinstance(run[1].outcome, grazing.Done)
    assert isinstance(run.outcome, grazing.NothingFound)


def test_proofs_of_a_scene_come_with_certificates(root):
    scene = grazing.Scene(root / "examples/scenes/nordmark-2001.toml")
    (report,) = scene.run("period-4")
    assert isinstance(report.outcome, grazing.Proved)
    assert report.certificates
    for text in report.certificates.values():
        assert isinstance(grazing.check(text), grazing.Proved)
    row = report.findings.proofs[0]
    assert row.verdict == "proved"


def test_a_batch_is_the_scalar_motion_bit_for_bit():
    scene = grazing.Scene(MACHINE).with_parameters(F="0.8")
    starts = np.column_stack([np.linspace(-2, 1, 37), np.linspace(-1, 1, 37)])
    motions = scene.simulate(starts, 30, transient=5, every=3)
    assert motions.points.shape == (37, 11, 2)
    assert motions.periods.tolist() == list(range(5, 36, 3))
    for index in (0, 11, 36):
        q, u = map(float, starts[index])
        task = {"name": "one", "kind": "simulate", "start": {"q": q, "u": u}, "transient": 5, "periods": 30,
                "samples": 1}
        tasks = [task]
        one = grazing.Scene({**MACHINE, "parameters": {"F": 0.8}, "tasks": tasks}).run()[0]
        assert (one.data.q[::3] == motions.points[index, :, 0]).all()
        assert (one.data.u[::3] == motions.points[index, :, 1]).all()
        assert one.findings.impacts == motions.impacts[index]


def test_a_batch_over_a_parameter():
    scene = grazing.Scene(MACHINE)
    values = np.linspace(0.1, 0.9, 300)
    motions = scene.simulate([0.0, 0.0], 3, transient=50, parameters={"F": values})
    assert motions.points.shape == (300, 4, 2)
    one = scene.simulate([[0.0, 0.0]], 3, transient=50, parameters={"F": values[299]})
    assert (one.points[0] == motions.points[299]).all()
    assert motions.impacts[0] == 0 and motions.impacts[-1] > 0


def test_ends_of_motions_and_bad_arrays():
    scene = grazing.Scene(MACHINE)
    motions = scene.simulate([[0.0, 0.0], [2.0, 0.0]], 2)
    assert [grazing.End(end).name for end in motions.ends] == ["REACHED", "BEHIND_A_WALL"]
    assert np.isnan(motions.points[1]).all() and "BEHIND_A_WALL" in repr(motions)
    assert scene.simulate(np.empty((0, 2)), 2).points.shape == (0, 3, 2)
    assert scene.simulate(np.empty((0, 2)), 2, parameters={"F": 0.5}).points.shape == (0, 3, 2)
    assert scene.simulate([0.0, 0.0], 2, parameters={"F": []}).points.shape == (0, 3, 2)
    assert scene.simulate([[0.0, 0.0]], 0).points.shape == (1, 1, 2)
    with pytest.raises(grazing.InputError, match="motion 1"):
        scene.simulate([[0.0, 0.0], [np.nan, 0.0]], 2)
    with pytest.raises(grazing.InputError, match="shape"):
        scene.simulate(np.zeros((3, 3)), 2)
    with pytest.raises(grazing.InputError, match="F has the shape"):
        scene.simulate(np.zeros((3, 2)), 2, parameters={"F": [1.0, 2.0]})
    with pytest.raises(grazing.InputError, match="starts has the shape"):
        scene.simulate(np.empty((0, 2)), 2, parameters={"F": [1.0, 2.0]})
    with pytest.raises(grazing.InputError, match='no parameter "G"'):
        scene.simulate([0, 0], 2, parameters={"G": 1.0})
    with pytest.raises(grazing.InputError, match="every"):
        scene.simulate([0, 0], 2, every=0)


def test_arrays_are_read_where_they_are():
    scene = grazing.Scene(MACHINE)
    starts = np.zeros((50, 2))
    starts.setflags(write=False)
    strided = np.zeros((100, 4))[::2, ::2]
    assert (scene.simulate(starts, 2).points == scene.simulate(strided, 2).points).all()
    data = scene.run("after")[0].data
    # What comes out belongs to NumPy: it can be changed, and is one block.
    data.q[0] = 7.0
    assert data.q[0] == 7.0 and data.q.flags["C_CONTIGUOUS"]


def test_json_of_the_command_line_has_the_same_findings(root, program, tmp_path):
    path = root / "examples/scenes/bouncing-ball.toml"
    done = subprocess.run([program, "run", path, "--format", "json", "-o", tmp_path, "-q"], capture_output=True)
    wanted = json.loads(done.stdout)["tasks"]
    found = list(grazing.Scene(path).run())
    assert [task["task"] for task in wanted] == [report.task for report in found]
    for task, report in zip(wanted, found):
        for name, value in report.findings.items():
            if not isinstance(value, (list, grazing.Record)):
                assert task[name] == value


def test_every_kind_of_task_gives_its_arrays(root):
    scene = grazing.Scene(root / "tests/data/kinds.toml")
    names = [task.name for task in scene.tasks if task.kind not in ("crisis", "chaos")]
    run = {report.kind: report for report in scene.run(names) if report.task not in ("none", "gap")}
    # A row for each end says how many starts lead there; the cells say which.
    basins = run["basins"]
    rows = basins.findings.basins
    assert basins.data.cells.shape == (len(basins.data.u), len(basins.data.q)) == (3, 3)
    assert [row.starts for row in rows] == np.bincount(basins.data.cells.ravel(), minlength=len(rows)).tolist()
    assert basins.data.q.tolist() == pytest.approx(np.linspace(-0.04, 3, 3).tolist(), abs=0)
    ends = run["map"].findings.ends
    periods = run["map"].data.period
    assert periods.shape == run["map"].data.exponent.shape == (2, 3)
    for row in ends:
        wanted = {"periodic": row.period, "not-periodic": 0}.get(row.end, -1)
        same = (periods == wanted) & ((run["map"].data.impacts == row.impacts) if row.impacts is not None else True)
        assert same.sum() == row.points
    section = run["section"]
    assert section.data.points.shape == (len(section.data.attractor), 2)
    assert set(section.data.attractor.tolist()) >= set(range(len(section.findings.attractors)))
    diagram = run["diagram"]
    assert diagram.data.points.shape == (len(diagram.data.value), 2)
    assert len(set(diagram.data.value.tolist())) == diagram.findings["values"] == 3
    response = run["response"]
    # Of three values the displacement and the gap; the drive is the stop's, and the displacement stands still.
    assert response.data.way.tolist() == [0] * 6 and response.data.coordinate.tolist() == [0, 1] * 3
    assert response.data.swing[0] == 0 and np.isnan(response.data.lag[0]) and response.data.period.tolist() == [1] * 6
    assert response.data.amplitude[1] == pytest.approx(0.95) and response.data.lag[1] == 0.5
    branch = run["branch"]
    assert len(branch.rows) == branch.findings.points > 10
    assert len(branch.frame()) == len(branch.rows)
    assert isinstance(run["validate"].outcome, grazing.Proved) and len(run["validate"].certificates) == 2
    frame = run["orbit"].frame("orbits")
    assert len(frame) == len(run["orbit"].findings.orbits)
    with pytest.raises(grazing.InputError, match="orbits"):
        run["orbit"].frame("nothing")


def test_machines_have_a_column_for_each_coordinate(root):
    scene = grazing.Scene(root / "tests/data/kinds-machine.toml")
    motion = scene.run("motion")[0]
    assert motion.data.q.shape == motion.data.u.shape == motion.data.time.shape
    two = grazing.Scene(root / "examples/machines/two-masses.toml").run("settled")[0]
    assert two.data.q.shape == two.data.u.shape == (len(two.data.time), 2)


#: The paper's oscillator without tasks.
def oscillator(root, *tasks):
    text = (root / "tests/data/kinds.toml").read_text()
    return grazing.Scene(text[: text.index("[[tasks]]")] + "\n".join(tasks))


def test_what_is_not_settled_has_no_period():
    # Nothing damps what resonates: it grows for ever, and the stop is out of reach.
    slow = {**MACHINE, "system": {**MACHINE["system"], "damping": 0, "stiffness": 1}, "walls": [
        {"side": "upper", "offset": 1000000, "restitution": 1}]}
    task = {"name": "diagram", "kind": "diagram", "parameter": "F", "range": [1, 2], "count": 3, "starts": [{"q": 0}]}
    (report,) = grazing.Scene({**slow, "tasks": [task]}).run()
    assert isinstance(report.outcome, grazing.Undecided) and "transient" in report.outcome.budget
    assert len(report.findings.not_settled) == 3 and set(report.data.period.tolist()) == {-2}


def test_proofs_beside_what_is_seen_come_with_certificates(root):
    touch = '[[tasks]]\nname = "touch"\nkind = "grazing"\nparameter = "mu"\nprove = true\nrange = true\n'
    seen = """[[tasks]]
name = "seen"
kind = "diagram"
parameter = "mu"
range = [-0.05, -0.04]
count = 2
starts = [{ q = 0 }, { q = 2 }]
points = 20
prove = true
"""
    for report in oscillator(root, touch, seen).run():
        findings = json.dumps(report.findings, default=dict)
        named = {part for part in findings.split('"') if part.endswith(".certificate")}
        assert named and set(report.certificates) == named
        assert set(report.claims) == named
        for file, text in report.certificates.items():
            proved = grazing.check(text)
            assert isinstance(proved, grazing.Proved)
            assert dict(report.claims[file].detail) == dict(proved.details.detail), file
        # What is seen is floating point, whatever is proved beside it.
        assert not isinstance(report.outcome, grazing.Proved)


def test_a_machine_in_a_line_has_the_answer_that_the_command_prints(program):
    words = "m = 2 kg, k = 800 N/m, c = 3 N s/m, f = 4 Hz, gap = 10 mm, e = 0.6"
    scene = grazing.machine(words)
    answer = scene.answer()
    printed = subprocess.run([program, words], capture_output=True, text=True, check=True).stdout
    assert printed == f"{scene.title}\n{answer}\n"
    assert {sentence.mark for sentence in answer.sentences} == {"proved", "located", "seen"}
    assert answer.touch.kind == "grazing" and answer.swing is not None and answer.swing.kind == "response"
    assert len(answer.swing.data.value) > 100 and "proved" in answer._repr_html_()
    assert grazing.Scene(scene.text).answer(set={"gap": "20 mm"}).sentences != answer.sentences
    with pytest.raises(grazing.InputError, match="k, c, f, gap: missing"):
        grazing.machine("m = 2 kg")
    bare = {"title": "t", "system": {"stiffness": 1}, "tasks": []}
    with pytest.raises(grazing.InputError, match="has no task of kind grazing"):
        grazing.Scene(bare).answer()


def test_a_motion_needs_no_scene(root):
    stops = [
        {"name": "between", "row": [-1, 1], "offset": -0.004, "restitution": 0.8},
        {"name": "ground", "row": [1, 0], "offset": -0.012, "restitution": 0.8},
    ]
    found = grazing.simulate(
        np.diag([2, 0.5]), [[12, -2], [-2, 2]], [[3200, -200], [-200, 200]], stops=stops, force=[12, 0], frequency=8,
        transient=100, periods=10,
    )
    scene = grazing.Scene(root / "examples/machines/two-masses.toml").run("settled")[0]
    assert found.data.q.shape[1] == 2 and (found.data.q == scene.data.q).all()
    assert (found.data.event_time == scene.data.event_time).all() and found.findings.impacts == scene.findings.impacts
    # By its formula: half of e^{it}, of a spring 2 without damping, a quarter of a turn ahead.
    late = grazing.simulate(K=2, force=0.5j, q=0, u=-0.5, periods=1)
    assert np.allclose(late.data.q, -0.5 * np.sin(2 * np.pi * late.data.time), atol=1e-9)
    for wrong, told in [
        ({"M": 0}, "system.mass"), ({"q": [1, 2]}, "each of 1 coordinates"), ({"K": float("nan")}, "is not finite"),
        ({"q": 2, "stops": [{"side": "upper", "offset": 1, "restitution": 0.8}]}, "behind the upper stop"),
    ]:
        with pytest.raises(grazing.InputError, match=told):
            grazing.simulate(**wrong)


def test_a_float_is_its_shortest_decimal():
    scene = grazing.Scene(MACHINE)
    assert scene.run("after", set={"F": 0.7})[0].parameters == {"F": Fraction(7, 10)}
    assert scene.with_parameters(F=np.float32(0.1)).parameters == {"F": Fraction(1, 10)}
    with pytest.raises(grazing.InputError, match="F = inf: is not finite"):
        scene.with_parameters(F=float("inf"))


def test_the_blocks_of_the_documentation_run(root, tmp_path, monkeypatch):
    pages = {name: (root / "docs" / name).read_text() for name in ("python.md", "my-machine.md")}
    (tmp_path / "machine.toml").write_text(pages["my-machine.md"].split("```toml\n")[1].split("```")[0])
    monkeypatch.chdir(tmp_path)
    blocks = [part.split("```")[0] for part in pages["python.md"].split("```python\n")[1:]]
    assert len(blocks) > 3
    known: dict = {}
    for block in blocks:
        exec(block, known)
