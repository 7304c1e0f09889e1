"""Processes: what is pickled comes back, and what a fork leaves behind is said."""

import errno
import multiprocessing
import os
import pickle
import subprocess
import sys
import textwrap
from fractions import Fraction

import numpy as np
import pytest
from conftest import MACHINE

import grazing


def again(thing):
    return pickle.loads(pickle.dumps(thing))


def test_a_scene_is_pickled_with_its_values(root):
    scene = grazing.Scene(MACHINE)
    changed = scene.with_parameters(F="4/5")
    for one in (scene, changed, grazing.Scene(root / "examples/machines/two-masses.toml")):
        two = again(one)
        assert two == one and hash(two) == hash(one) and two is not one
        assert (two.text, two.title, two.parameters, two.tasks) == (one.text, one.title, one.parameters, one.tasks)
    assert again(changed).parameters == {"F": Fraction(4, 5)}
    found = [one.simulate([0.0, 0.0], 20) for one in (changed, again(changed), scene)]
    assert found[0] == found[1] and found[0] != found[2]
    # An error still names the source.
    with pytest.raises(grazing.InputError, match="<dict>"):
        again(scene).run("nothing")


def test_scenes_are_equal_where_nothing_tells_them_apart():
    one, two = grazing.Scene(MACHINE), grazing.Scene(dict(MACHINE))
    assert one == two and hash(one) == hash(two) and len({one, two}) == 1
    assert one != one.with_parameters(F="1/3") and one == one.with_parameters(F="1/3").with_parameters(F="1/2")
    assert one != grazing.Scene({**MACHINE, "title": "another"})
    assert one != grazing.Scene(one.text)  # Whose errors name another source.
    assert one != MACHINE


def test_reports_and_tables_are_equal_by_what_they_hold():
    run, other = grazing.Scene(MACHINE).run(), grazing.Scene(MACHINE).run()
    assert run == other and hash(run) == hash(other) and again(run) == run
    assert run[1] == other[1] and run[1] != run[0] and len({run[1], other[1]}) == 1
    other[1].data.q[3] += 1
    assert run[1] != other[1] and run != other
    table = grazing.intervals("3..=9")
    assert table == again(table) == grazing.intervals("3..=9") != grazing.intervals("3..=10")
    assert table[:4] == grazing.intervals("3..=9")[:4] != table[1:5]
    motions = grazing.Scene(MACHINE).simulate([[0.0, 0.0], [2.0, 0.0]], 3)
    assert np.isnan(motions.points).any() and motions == again(motions)
    for unhashable in (table, motions):
        with pytest.raises(TypeError, match="unhashable"):
            hash(unhashable)
    words = [grazing.word(r="0.4633", s="0.16327") for _ in range(2)]
    assert words[0] == words[1] and hash(words[0]) == hash(words[1])
    here = [grazing.classify(r=1, s="1/7") for _ in range(2)]
    assert here[0] == here[1] and hash(here[0]) == hash(here[1]) and here[0] != grazing.classify(r=1, s="1/8")


def test_outcomes_are_equal_by_kind_statement_and_details():
    one, two = (grazing.verify("3..=5") for _ in range(2))
    assert one == two and hash(one) == hash(two)
    assert one != grazing.verify("3..=6") and grazing.Done("x") != grazing.Proved("x")
    assert grazing.Refuted("x", witness="a") != grazing.Refuted("x", witness="b")
    failed = [grazing.Failed("x", error=grazing.InputError(text)) for text in ("a", "a", "b")]
    assert failed[0] == failed[1] == again(failed[0]) and hash(failed[0]) == hash(failed[1])
    assert failed[0] != failed[2] and failed[0] != grazing.Failed("x", error=grazing.FileError("a"))


def test_errors_are_pickled_with_all_their_parts(tmp_path):
    with pytest.raises(grazing.FileError) as raised:
        grazing.check(tmp_path / "none.txt")
    error = again(raised.value)
    assert type(error) is grazing.FileError and str(error) == str(raised.value)
    assert error.errno == errno.ENOENT and error.file == error.filename == str(tmp_path / "none.txt")
    with pytest.raises(grazing.InputError) as raised:
        grazing.Scene({**MACHINE, "dampng": 1})
    error = again(raised.value)
    assert {**vars(error)} == {**vars(raised.value)} and error.fix == raised.value.fix and error.line


needs_fork = pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork here")


def alone(code):
    """What a Python of its own prints, which must end by itself."""
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", textwrap.dedent(code)], capture_output=True, text=True,
                          timeout=120)
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


@needs_fork
def test_after_a_fork_work_for_threads_is_an_error():
    # Each of these would wait for ever for threads that are not there.
    shown = alone("""
        import multiprocessing, grazing
        grazing.verify(5)

        def child(work):
            try:
                WORK[work]()
                return work + ":done"
            except grazing.ForkedError as error:
                assert isinstance(error, RuntimeError) and "spawn" in str(error)
                return work + ":forked"

        WORK = {
            "verify": lambda: grazing.verify(5),
            "many": lambda: grazing.classify_many(r=1, s=["1/5"]),
            "scene": lambda: grazing.Scene({"system": {"damping": 1}}),
            "one": lambda: grazing.classify(r=1, s="1/5"),
        }
        with multiprocessing.get_context("fork").Pool(1) as pool:
            print(*pool.map(child, WORK))
        print(type(grazing.verify(5)).__name__)
    """)
    # A point of usual size needs no thread.
    assert shown == ["verify:forked", "many:forked", "scene:forked", "one:done", "Proved"]


@needs_fork
def test_a_fork_before_the_first_work_has_threads_of_its_own():
    shown = alone("""
        import multiprocessing, grazing
        grazing.classify(r=1, s="1/5")

        def child(n):
            return grazing.verify(n).details.orbit_intervals

        with multiprocessing.get_context("fork").Pool(2) as pool:
            print(*pool.map(child, [5, 6, 7]))
    """)
    assert shown == [str(len(grazing.intervals(n))) for n in (5, 6, 7)]


@needs_fork
def test_a_callback_that_forks_leaves_no_child_that_waits():
    shown = alone("""
        import os, sys, grazing
        parent, done = os.getpid(), []

        def fork(*state):
            if not done:
                done.append(os.fork())

        try:
            grazing.verify("3..=3000", progress=fork)
        except grazing.ForkedError:
            assert os.getpid() != parent
            os._exit(7)
        assert os.getpid() == parent
        print(os.waitstatus_to_exitcode(os.waitpid(done[0], 0)[1]))
    """)
    assert shown == ["7"]


def test_spawned_processes_share_the_work():
    # From a file, as spawned processes read it again.
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        scenes = [grazing.Scene(MACHINE).with_parameters(F=value) for value in ("1/2", "4/5")]
        assert pool.map(impacts, scenes) == [impacts(scene) for scene in scenes]
        with pytest.raises(grazing.FileError) as raised:
            pool.apply(grazing.check, ("none.txt",))
    assert raised.value.errno == errno.ENOENT and os.path.basename(raised.value.filename) == "none.txt"


def impacts(scene):
    return scene.simulate([0.0, 0.0], 30).impacts.tolist()
