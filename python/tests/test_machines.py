"""Machines followed by the thousand: each motion is its task's, to the bit, and the other engine's."""

import numpy as np
import pytest

import grazing


def system(path, *tasks):
    """A scene's system with other tasks."""
    text = path.read_text()
    return text[: text.index("[[tasks]]")] + "\n".join(tasks)


def task(start, phase, transient, periods):
    half = len(start) // 2
    q, u = (f"[{', '.join(map(repr, part))}]" for part in (start[:half], start[half:]))
    return (f'[[tasks]]\nname = "one"\nkind = "simulate"\nstart = {{ phase = {phase}, q = {q}, u = {u} }}\n'
            f"transient = {transient}\nperiods = {periods}\nsamples = 1\n")


#: Scene, parameter that is varied, and starts: rigid stops, soft ones, modes seen at a point, formulas.
MACHINES = {
    "two-masses": ("F0", [[0.0, 0.0, 0.0, 0.0], [0.001, 0.002, -0.1, 0.05], [0.0, 0.3, 0.0, 2.0]]),
    "bilinear": (None, [[0.0, 0.0], [0.5, -0.25]]),
    "cantilever": ("F0", [[0.0, 0.0]]),
    "energy-sink": (None, [[0.0, 0.0, 0.0, 0.0], [0.001, -0.002, 0.0, 0.125]]),
}


@pytest.mark.parametrize("name", MACHINES)
def test_each_motion_of_a_machine_is_that_of_its_task(root, name):
    path = root / f"examples/machines/{name}.toml"
    starts = np.array(MACHINES[name][1])
    motions = grazing.Scene(system(path)).simulate(starts, 6, transient=20, every=2, phase=0.25)
    coordinates = starts.shape[1] // 2
    assert motions.points.shape == (len(starts), 4, 2 * coordinates) and motions.coordinates == coordinates
    assert motions.periods.tolist() == [20, 22, 24, 26]
    for index, start in enumerate(starts.tolist()):
        (one,) = grazing.Scene(system(path, task(start, '"1/4"', 20, 6))).run()
        assert (motions.q[index] == one.data.q[::2]).all() and (motions.u[index] == one.data.u[::2]).all()
        assert motions.impacts[index] == one.findings.impacts
        assert motions.ends[index] == grazing.End.REACHED
    assert len({tuple(row) for row in motions.points[:, -1].tolist()}) == len(starts)


def test_a_motion_has_the_depth_that_its_own_start_asks_for():
    # How many bounces of a ball are counted until it rests follows from the depth, and that from how high it begins.
    ball = """
format = "grazing-scene 3"
title = "a ball"
engine = "many"
[system]
period = 4
force = -16
mass = 2
[[stops]]
name = "table"
row = [1]
offset = 0
restitution = 0.5
"""
    starts = [[1.0, 0.0], [1000.0, 0.0], [0.0, 50.0]]
    motions = grazing.Scene(ball).simulate(starts, 40)
    for index, start in enumerate(starts):
        (one,) = grazing.Scene(ball + task(start, 0, 0, 40)).run()
        assert motions.impacts[index] == one.findings.impacts > 10
        assert (motions.q[index] == one.data.q).all()
    assert len(set(motions.impacts.tolist())) > 1


@pytest.mark.parametrize("name", ["two-masses", "cantilever"])
def test_a_machine_is_followed_over_a_parameter(root, name):
    path, (parameter, (start, *_)) = root / f"examples/machines/{name}.toml", MACHINES[name]
    scene = grazing.Scene(system(path))
    values = float(scene.parameters[parameter]) * np.array([0.5, 1.0, 2.0])
    motions = scene.simulate(start, 3, transient=30, parameters={parameter: values})
    assert motions.parameters[parameter].tolist() == values.tolist()
    assert len(set(motions.impacts.tolist())) > 1
    for index, value in enumerate(values):
        (one,) = grazing.Scene(system(path, task(start, 0, 30, 3))).run(set={parameter: str(value)})
        assert np.allclose(motions.q[index], one.data.q, rtol=1e-9, atol=1e-15)
        assert motions.impacts[index] == one.findings.impacts
    alone = scene.simulate(start, 3, transient=30, parameters={parameter: values[1]})
    assert (alone.points[0] == motions.points[1]).all()


def test_both_engines_follow_an_oscillator_alike():
    text = """
format = "grazing-scene 3"
title = "a driven mass and a stop"
engine = "{engine}"
[system]
damping = "1/10"
stiffness = "3/10"
forcing = [{{ cos = "4/5" }}]
[[stops]]
side = "upper"
offset = 1
restitution = 0.8
"""
    starts = np.column_stack([np.linspace(-2, 1, 40), np.linspace(-1, 1, 40)])
    one, many = (grazing.Scene(text.format(engine=engine)) for engine in ("auto", "many"))
    assert "oscillator" in repr(one) and "machine" in repr(many)
    by_one, by_many = (scene.simulate(starts, 4, transient=3, phase=0.125) for scene in (one, many))
    assert by_one.points.shape == by_many.points.shape == (40, 5, 2)
    assert (by_one.impacts == by_many.impacts).all() and by_one.impacts.sum() > 40
    assert np.allclose(by_one.points, by_many.points, rtol=0, atol=1e-8)


def test_a_start_behind_a_stop_has_no_motion(root):
    scene = grazing.Scene(system(root / "examples/machines/two-masses.toml"))
    # The second mass hits the first where they come nearer than 4 mm; the first the ground 12 mm below.
    motions = scene.simulate([[0.0] * 4, [0.0, -0.005, 0.0, 0.0], [-0.013, 0.0, 0.0, 0.0]], 2)
    assert [grazing.End(end).name for end in motions.ends] == ["REACHED", "BEHIND_A_WALL", "BEHIND_A_WALL"]
    assert np.isnan(motions.points[1:]).all() and not np.isnan(motions.points[0]).any()
    # A soft stop can be pushed in.
    soft = grazing.Scene(system(root / "examples/machines/bilinear.toml"))
    assert soft.simulate([[-100.0, 0.0], [100.0, 0.0]], 1).ends.tolist() == [0, 0]


def test_starts_of_a_machine_have_all_coordinates(root):
    scene = grazing.Scene(system(root / "examples/machines/two-masses.toml"))
    with pytest.raises(grazing.InputError, match=r"\(N, 4\), 2 displacements, then 2 velocities"):
        scene.simulate([0.0, 0.0], 1)
    with pytest.raises(grazing.InputError, match="motion 1: the start"):
        scene.simulate([[0.0] * 4, [0.0, 0.0, np.inf, 0.0]], 1)
    with pytest.raises(grazing.InputError, match='no parameter "G"'):
        scene.simulate([0.0] * 4, 1, parameters={"G": 1.0})
    assert scene.simulate(np.empty((0, 4)), 2).points.shape == (0, 3, 4)
    # Ten modes are seen at one point: the point does not tell them.
    beam = grazing.Scene(system(root / "examples/machines/cantilever.toml"))
    with pytest.raises(grazing.InputError, match="motion 0: the shapes"):
        beam.simulate([0.001, 0.0], 1)


def test_views_of_machines_and_oscillators(root):
    two = grazing.Scene(system(root / "examples/machines/two-masses.toml"))
    motions = two.simulate([0.0] * 4, 3, transient=50, parameters={"F0": [6.0, 12.0]})
    assert (motions.q == motions.points[..., :2]).all() and (motions.u == motions.points[..., 2:]).all()
    assert motions.q.shape == (2, 4, 2) and np.shares_memory(motions.q, motions.points)
    again = two.simulate([0.0] * 4, 3, transient=50, parameters={"F0": [6.0, 12.0]})
    assert motions == again and motions != two.simulate([0.0] * 4, 3, transient=50, parameters={"F0": [6.0, 13.0]})
    one = grazing.Scene(system(root / "examples/machines/bilinear.toml")).simulate([[0.0, 0.0]], 2)
    assert one.q.shape == one.u.shape == (1, 3) and (one.u == one.points[..., 1]).all()


def test_a_block_on_a_belt_sticks_and_slips(root):
    path = root / "examples/machines/belt.toml"
    squeal = grazing.Scene(path).run("squeal")[0]
    (row,) = squeal.findings.friction
    kinds = [grazing.EVENT_KINDS[kind] for kind in squeal.data.event_kind]
    # There is no stop: the belt is the first place.
    assert set(kinds) == {"stick", "release"} and set(squeal.data.event_place) == {0}
    assert kinds.count("stick") == row.sticks == 25 and row.at_end == "sticks"
    # Against 2 N.
    assert row.dissipated == pytest.approx(2 * row.path, rel=1e-12)
    # Many starts at once, on the belt at rest: within its hold of 4 N over 100 N/m they stay where they are.
    still = grazing.Scene(path).with_parameters(v=0)
    found = still.simulate([[q, 0.0] for q in (-0.05, -0.039, 0.0, 0.039, 0.05)], 3)
    ends = np.asarray(found.q)[:, -1].ravel()
    assert ends[1:4] == pytest.approx([-0.039, 0.0, 0.039], abs=1e-15)
    assert ends[0] > -0.05 + 1e-3 and ends[4] < 0.05 - 1e-3
