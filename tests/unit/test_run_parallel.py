"""Several things at once: each item once, results in order, measuring alone."""

from __future__ import annotations

import threading

import pytest

from judge.run.parallel import Turnstile, in_order, share


@pytest.mark.parametrize("workers", [1, 2, 5, 40])
def test_results_come_in_the_order_of_the_items(workers):
    assert list(in_order(range(30), workers, lambda item: item * item)) == [n * n for n in range(30)]


def test_several_are_really_under_way_at_once():
    together = threading.Barrier(3, timeout=10)
    assert list(in_order([1, 2, 3], 3, lambda item: together.wait() is not None and item)) == [1, 2, 3]


@pytest.mark.parametrize("workers", [1, 3])
def test_an_exception_comes_in_place_of_its_result(workers):
    def work(item):
        if item == 2:
            raise ValueError("two")
        return item

    results = in_order([0, 1, 2, 3], workers, work)
    assert [next(results), next(results)] == [0, 1]
    with pytest.raises(ValueError, match="two"):
        next(results)


@pytest.mark.parametrize("workers", [1, 2, 8])
def test_workers_share_the_items_each_once(workers):
    seen = []
    share("abcdef", workers, seen.extend)
    assert sorted(seen) == list(enumerate("abcdef"))


def test_a_workers_exception_reaches_the_caller():
    here = threading.current_thread()
    started = threading.Event()

    def work(queue):
        for _ in queue:
            if threading.current_thread() is not here:
                started.set()
                raise ValueError("in a thread")
            started.wait(10)

    with pytest.raises(ValueError, match="in a thread"):
        share(range(4), 2, work)


def test_who_measures_is_alone():
    turnstile = Turnstile()
    seen = []

    def work(name):
        for _ in range(20):
            if name == "measure":
                with turnstile.measuring():
                    seen.append((turnstile._judging, turnstile._measuring))
            else:
                with turnstile.judging():
                    seen.append((turnstile._judging > 0, turnstile._measuring))

    threads = [
        threading.Thread(target=work, args=(name,)) for name in ("measure", "judge", "judge", "measure")
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(20)
    assert len(seen) == 80
    assert set(seen) == {(0, True), (True, False)}


@pytest.mark.parametrize("count", [0, 1, 3])
def test_where_threads_are_few_they_do_all_of_it(monkeypatch, count):
    real, started = threading.Thread.start, []

    def start(thread):
        if len(started) == count:
            raise RuntimeError("can't start new thread")
        started.append(thread)
        real(thread)

    monkeypatch.setattr(threading.Thread, "start", start)
    assert list(in_order(range(20), 8, lambda item: item * item)) == [n * n for n in range(20)]
    assert len(started) == count
    started.clear()
    seen = []
    share("abcdef", 8, seen.extend)
    assert sorted(seen) == list(enumerate("abcdef"))
