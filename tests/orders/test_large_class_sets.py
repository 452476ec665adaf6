"""Class sets and neighbour counts in blocks, by executors and from files, against those found row by row."""

import hashlib
import json
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from hfield import LatticeError, Order, QuaternionAlgebra, TooLargeError
from hfield.core.packed_integers import pack, unpack
from hfield.core.sparse_rows import SparseRows
from hfield.orders import brandt, classes, neighbour_blocks
from hfield.orders.class_file import ClassFile
from hfield.orders.lattice import ClassSet

SQRT3: Any = QuaternionAlgebra("QQ(sqrt(3))", -1, -1)
ORDERS = {
    "QQ": QuaternionAlgebra(389).maximal_order(),
    "level": QuaternionAlgebra(13).eichler_order(15),
    "three narrow classes": QuaternionAlgebra("QQ(sqrt(15))", -1, -1).maximal_order(),
}


@pytest.fixture(autouse=True)
def small_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let small class sets be enumerated as large ones are."""
    monkeypatch.setattr(neighbour_blocks, "ROWS_A_PIECE", 3)
    monkeypatch.setattr(neighbour_blocks, "ROWS_A_BLOCK", 12)
    monkeypatch.setattr(classes, "MIN_EXCHANGED_MASS", 1)


def prime(O: Order) -> Any:
    return 3 if O.algebra.ring.name == "QQ" else O.algebra.ring.primes_above(3)[0]


def same(C: ClassSet, D: ClassSet) -> bool:
    """Whether two class sets have the same representatives in the same order, and the same neighbours."""
    P = prime(C.order)
    return (
        [I.hnf for I in C] == [I.hnf for I in D]
        and C.units == D.units
        and C.neighbour_counts(P) == D.neighbour_counts(P)
    )


@pytest.mark.parametrize("name", ORDERS)
def test_rows_are_those_of_the_matrix(name: str) -> None:
    C = ORDERS[name].class_set()
    P = prime(C.order)
    rows, matrix = C.neighbour_counts(P), C.brandt_matrix(P)
    size = range(len(C))
    assert len(rows) == len(C)
    assert [[row.get(j, 0) for j in size] for row in rows] == matrix
    assert rows == [{j: matrix[i][j] for j in size if matrix[i][j]} for i in size]
    assert C.neighbours(P) == list(rows)
    assert [(i, j, d["weight"]) for i, j, d in C.edges(P)] == [
        (i, j, matrix[i][j]) for i in size for j in size if matrix[i][j]
    ]
    values = [k * k - 7 for k in size]
    product = [sum(x * y for x, y in zip(row, values, strict=True)) for row in matrix]
    assert rows.times(values) == C.hecke_operator(P, values) == product


@pytest.mark.parametrize("name", ORDERS)
def test_executors_find_the_same_classes_in_the_same_order(name: str) -> None:
    O = ORDERS[name]
    with ThreadPoolExecutor(2) as executor:
        D = O.class_set(executor=executor)
        D.neighbour_counts(prime(O), executor=executor)
    assert same(O.class_set(), D)


@pytest.mark.parametrize(
    "O",
    [
        ORDERS["QQ"],
        ORDERS["level"],
        QuaternionAlgebra(3).eichler_order(4 * 7),
        SQRT3.eichler_order([(SQRT3.ring.primes_above(11)[0], 1)]),
    ],
)
def test_rows_of_exchanged_classes(O: Order, monkeypatch: pytest.MonkeyPatch) -> None:
    """In large sets half of the rows are read off the others."""
    C = O.class_set()
    base = O.value.ambient.base
    for p in (2, 3, 5, 7, 13):
        for _, P in base.primes_above(p):
            rows = C._classes.neighbours(P)
            assert rows == [C._classes.neighbours_of(n, P) for n in range(len(C))], p
    assert C._classes.exchange_prime is not None
    monkeypatch.setattr(classes, "MIN_EXCHANGED_MASS", 10**9)
    D = O.class_set()
    assert D._classes.exchange_prime is None
    number = [D.index(I) for I in C]
    assert sorted(number) == list(range(len(D)))
    for P, _ in base.factorisation(O.value.ambient.base.integral_ideal(O.discriminant())):
        moved = D._classes.exchanged(P)
        assert [moved[n] for n in number] == [number[n] for n in C._classes.exchanged(P)]
        ideal = O.two_sided_prime(P)
        assert moved[:9] == [D.index(I * ideal) for I in D][:9]


class Interrupted(Executor):
    """Computes some pieces, then raises KeyboardInterrupt."""

    def __init__(self, pieces: int) -> None:
        self.left = pieces

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        if not self.left:
            raise KeyboardInterrupt
        self.left -= 1
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


@pytest.mark.parametrize("name", ORDERS)
def test_an_interrupted_run_goes_on(name: str, tmp_path: Path) -> None:
    O, path = ORDERS[name], tmp_path / "classes.jsonl"

    def run(executor: Executor) -> None:
        O.class_set(executor=executor, file=path).neighbour_counts(prime(O), executor=executor)

    for pieces in (4, 6, 8):
        with pytest.raises(KeyboardInterrupt):
            run(Interrupted(pieces))
        with path.open("ab") as file:
            file.write(b'{"prime": 2, "fir')  # a line that is torn
    before = path.read_text().splitlines()
    assert len(before) > 3
    C = O.class_set()
    assert same(C, O.class_set(file=path))
    assert path.read_text().splitlines()[: len(before) - 1] == before[:-1]
    # all is in the file: nothing is computed any more
    assert same(C, O.class_set(file=path, executor=Interrupted(0)))


def test_an_object_goes_on_after_an_interrupt(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Rows that were found before the interrupt, or were written twice, do not harm the file."""
    O, path = ORDERS["QQ"], tmp_path / "classes.jsonl"
    C = O.class_set(file=path)
    write = ClassFile.append

    def interrupted(*args: Any) -> None:
        if len(path.read_text().splitlines()) % 2:
            write(*args)
        raise KeyboardInterrupt

    for _ in range(2):
        with monkeypatch.context() as patch:
            patch.setattr(ClassFile, "append", interrupted)
            with pytest.raises(KeyboardInterrupt):
                C.neighbour_counts(5)
    rows = C.neighbour_counts(5)
    assert rows == [C.neighbours_of(n, 5) for n in range(len(C))]
    D = O.class_set(file=path)
    assert D.neighbour_counts(5) == rows
    assert D.neighbour_counts(5, executor=Interrupted(0)) == rows


def sealed(head: str, line: Any) -> str:
    """A line with the digest of what is in it now."""
    body = {key: value for key, value in line.items() if key != "digest"}
    whole = json.dumps([json.loads(head), body]).encode()
    return json.dumps({**body, "digest": hashlib.sha256(whole).hexdigest()[:16]})


def test_files_that_cannot_go_on(tmp_path: Path) -> None:
    O, path = ORDERS["QQ"], tmp_path / "classes.jsonl"
    O.class_set(file=path)
    with pytest.raises(LatticeError, match="another order"):
        QuaternionAlgebra(1013).maximal_order().class_set(file=path)
    lines = path.read_text().splitlines()
    line = json.loads(lines[1])
    line["rows"][0][1] += 1  # a row of another sum
    other, single = json.loads(lines[1]), json.loads(lines[1])
    other["classes"][0]["exchanged"] += 7
    del single["classes"][-1]
    for broken in (
        "[1]",
        '{"schema": "hfield-cert/2"}',
        "[" * 100_000,
        *(f"{lines[0]}\n{sealed(lines[0], some)}" for some in (line, other, single)),
    ):
        path.write_text(f"{broken}\n")
        with pytest.raises(LatticeError, match="not a file of classes"):
            O.class_set(file=path)


def test_lines_that_were_edited_are_refused(tmp_path: Path) -> None:
    """Where the sums of rows and the mass are right, too."""
    O, path = ORDERS["QQ"], tmp_path / "classes.jsonl"
    O.class_set(file=path)
    head, *lines = path.read_text().splitlines()
    edited = []
    for key in ("classes", "record", "keys", "rows", "digest"):
        line = json.loads(lines[0])
        first = line["classes"][0]
        if key in ("record", "keys"):
            numbers = first[key] if key == "record" else first[key][0]
            numbers[-1] += 1
        elif key == "classes":
            first["units"] += 1
        elif key == "rows":
            line["rows"][0] = [0, sum(line["rows"][0][1::2])]
        else:
            del line["digest"]
        edited.append(json.dumps(line))
    assert sealed(head, json.loads(lines[0])) == lines[0]
    for text in (*edited, "3", "[]"):
        path.write_text("\n".join([head, text, *lines[1:], ""]))
        with pytest.raises(LatticeError, match="is damaged"):
            O.class_set(file=path)


@pytest.mark.parametrize(
    "numbers", [[], [0], [-128, 127], [128], [-(2**31)], [2**63], [1, -(2**90)]]
)
def test_packed_integers(numbers: list[int]) -> None:
    assert unpack(pack(numbers)) == numbers
    assert pack(tuple(numbers)) == pack(numbers)


def test_sparse_rows() -> None:
    rows = SparseRows([{2: 1, 0: 5, 1: 0}, {}, {1: 2}])
    assert list(rows) == [{0: 5, 2: 1}, {}, {1: 2}]
    assert rows[-1] == {1: 2}
    assert rows[1:] == [{}, {1: 2}]
    assert rows != [{0: 5}, {}, {1: 2}]
    assert rows != [{0: 5, 2: 1}]
    assert [x.tolist() for x in rows.arrays] == [[0, 2, 2, 3], [0, 2, 1], [5, 1, 2]]
    with pytest.raises(IndexError, match="3 rows"):
        rows[3]
    with pytest.raises(OverflowError):
        rows.append({0: -1})


def test_matrices_that_do_not_fit_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    C = ORDERS["QQ"].class_set()
    monkeypatch.setattr(brandt, "MAX_MATRIX_BYTES", 16 * len(C) ** 2 - 1)
    for method in (C.brandt_matrix, C.hecke_polynomial):
        with pytest.raises(TooLargeError, match=r"1089 entries .* GB.*neighbour_counts"):
            method(2)
    with pytest.raises(TooLargeError):
        C.power_neighbours(2, 2)
    assert C.hecke_operator(2, [1] * len(C)) == [3] * len(C)
