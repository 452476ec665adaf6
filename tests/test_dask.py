"""Work on a Dask cluster: a real scheduler with two worker processes on loopback, one of them killed."""

import json
import os
import signal
import threading
import time

import pytest

from hfield import surveys
from hfield.cli import main
from hfield.core.executors import InProcess
from hfield.ledger.registry import claims
from hfield.ledger.run import decide_rows
from hfield.ledger.selection import rows_to_decide

pytestmark = pytest.mark.slow

TENS = 100


def test_the_ledger_goes_in_tens_of_pieces():
    """Each piece pays for its journey: no executor is sent 3199 of them."""
    pieces = rows_to_decide(claims(), [], strict=False)
    sent = []

    class Counting(InProcess):
        def submit(self, fn, /, *args, **kwargs):
            sent.append(args[0])
            return super().submit(lambda: [(None, None)] * len(args[0]))

    rows = decide_rows(pieces, Counting())
    assert [(row.claim, row.field) for row in rows] == pieces
    assert len(pieces) > 3000
    assert 10 <= len(sent) < TENS


@pytest.fixture(scope="module")
def cluster():
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        processes=True,
        host="127.0.0.1",
        dashboard_address=None,
        silence_logs=50,
    ) as found:
        yield found


def done_by(cluster):
    """The keys of the tasks that were finished."""
    return {entry[0] for entry in cluster.scheduler.transition_log if entry[2] == "memory"}


def test_verify_on_a_cluster(cluster, capsys):
    words = ["verify", "--section", "1.1", "--field", "QQ,GF(3)", "--format", "json"]
    here = main(words), json.loads(capsys.readouterr().out)
    before = done_by(cluster)
    there = main([*words, "--dask", cluster.scheduler_address]), json.loads(capsys.readouterr().out)
    assert here == there
    rows = len(here[1]["results"])
    assert 1 <= len(done_by(cluster) - before) < rows / 4


def test_a_survey_outlives_a_worker(cluster, tmp_path):
    """One of two workers is killed in the middle: nothing is lost, and nothing comes twice."""
    path = tmp_path / "rows.jsonl"
    pairs = surveys.definite_pairs(range(2, 250), range(1, 4))
    with cluster.get_client() as client:
        victim = next(iter(client.run(os.getpid).values()))
    killed = []

    def kill_when_under_way():
        for _ in range(120_000):
            if path.exists() and path.read_bytes().count(b"\n") >= 16:
                os.kill(victim, signal.SIGKILL)
                killed.append(path.read_bytes().count(b"\n"))
                return
            time.sleep(0.005)

    killer = threading.Thread(target=kill_when_under_way)
    killer.start()
    words = ["survey", "2..249", "--levels", "1..3", "-o", str(path)]
    assert main([*words, "--dask", cluster.scheduler_address]) == 0
    killer.join()
    assert killed
    assert killed[0] < len(pairs)  # it was in the middle
    rows = [json.loads(line) for line in path.read_text().splitlines()]
    assert sorted((row["discriminant"], row["level"]) for row in rows) == sorted(pairs)


def test_a_cluster_that_is_not_there(capsys, monkeypatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr("hfield.core.executors.SCHEDULER_ANSWERS_WITHIN", "1s")
    assert main(["survey", "2..9", "--dask", "tcp://127.0.0.1:1"]) == 2
    assert "no Dask scheduler answers" in capsys.readouterr().err
