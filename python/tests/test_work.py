"""Long work: progress, Ctrl-C, other threads."""

import os
import signal
import threading
import time

import numpy as np
import pytest

import grazing


def interrupted_after(seconds, work):
    """Sends SIGINT to this process; how long after it the work ended."""
    sent = []

    def send():
        time.sleep(seconds)
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=send)
    thread.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            work()
    finally:
        thread.join()
    return time.monotonic() - sent[0]


LONG = {
    "parameters": {"mu": 0.003},
    "system": {"damping": 0.1, "stiffness": 0.05, "forcing": [{"cos": 1}]},
    "walls": [{"side": "upper", "offset": 1, "restitution": 0.8}],
    "tasks": [
        {"name": "short", "kind": "simulate", "start": {"q": 0}, "periods": 2},
        {"name": "long", "kind": "simulate", "start": {"q": 0}, "periods": 2, "transient": 1_000_000_000},
    ],
}


@pytest.mark.parametrize(
    "work",
    [
        lambda: grazing.verify("20000..=60000"),
        lambda: grazing.intervals("3..=100000"),
        lambda: grazing.classify_many(r=np.full(10**7, 0.99), s=np.full(10**7, 0.21), max_n=30, floats="binary"),
        lambda: grazing.boundary("3..=5000", digits=50),
        lambda: grazing.fuzz(10**9),
        lambda: grazing.Scene(LONG).simulate(np.zeros((2000, 2)), 10**9, every=10**9),
    ],
)
def test_ctrl_c_ends_the_work_promptly(work):
    # A loaded machine is slow to let go; without the check for signals it would take minutes.
    assert interrupted_after(0.5, work) < 30


def test_ctrl_c_keeps_the_reports_of_the_tasks_that_were_done():
    kept = []

    def work():
        try:
            grazing.Scene(LONG).run()
        except KeyboardInterrupt as interrupt:
            kept.extend(interrupt.reports)
            raise

    interrupted_after(1.0, work)
    assert [report.task for report in kept] == ["short"]


def test_progress_is_told_and_may_end_the_work():
    told = []
    grazing.verify("3..=60", progress=lambda *state: told.append(state))
    assert told[-1] == (58, 58, "periods")
    assert all(one[0] <= two[0] for one, two in zip(told, told[1:]))

    class Enough(Exception):
        pass

    def enough(done, total, unit):
        raise Enough(unit)

    with pytest.raises(Enough, match="periods"):
        grazing.verify("3..=20000", progress=enough)
    with pytest.raises(TypeError, match="progress"):
        grazing.verify(5, progress="yes")


def test_a_bar_is_drawn_and_closed(capsys):
    from grazing._progress import Bar

    bar = Bar()
    bar(1, 4, "periods")
    assert capsys.readouterr().err == ""
    bar.start -= 1
    bar(1, 4, "periods")
    bar(4, 4, "periods")
    bar.close()
    shown = capsys.readouterr().err
    assert "1 of 4 periods" in shown and "█" * 20 in shown and shown.endswith("\n")


def test_the_line_of_a_bar_is_ended_however_the_work_ends(capsys):
    from grazing._progress import shown

    with pytest.raises(KeyboardInterrupt):
        with shown(True) as bar:
            bar.start -= 1
            bar(1, 4, "periods")
            raise KeyboardInterrupt
    assert capsys.readouterr().err.endswith(" s\n")


def test_other_threads_run_meanwhile():
    counted = [0]
    over = threading.Event()

    def count():
        while not over.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    start = time.monotonic()
    grazing.verify("3..=1200")
    seconds = time.monotonic() - start
    over.set()
    thread.join()
    # With the lock held the other thread would not have counted at all.
    assert seconds < 0.05 or counted[0] - before >= 3


def test_work_from_a_thread_and_from_several_at_once():
    found = []
    work = lambda: found.append(grazing.verify("3..=80").details.orbit_intervals)  # noqa: E731
    threads = [threading.Thread(target=work) for _ in range(4)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert found == [len(grazing.intervals("3..=80"))] * 4
