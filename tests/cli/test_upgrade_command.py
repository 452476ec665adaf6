"""``hfield upgrade``: names in certificates of the first schema become data."""

import json
from pathlib import Path
from typing import Any

import pytest

from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from hfield.cli import main


def first(statement: str, field: str | None, evidence: Any, **more: Any) -> dict[str, Any]:
    """A certificate as the first schema had it."""
    data = {"schema": "hfield-cert/1", "statement": statement, "algebra": f"(-1,-1|{field or 'F'})"}
    own = {"verdict": "proved", "method": "identity", "assumes": [], "evidence": evidence}
    return {**data, "field": field, **own, **more}


def anisotropic(place: str) -> dict[str, Any]:
    u, j = ["1/2"] * 4, ["1", "1", "0", "0"]
    return {"kind": "anisotropic", "by": "place", "place": place, "u": u, "j": j}


CASES = [
    first("s*q == q*s", "QQ(zeta_8)", {"kind": "identity"}),
    first("s*q == q*s", "GF(2^8)", {"kind": "identity"}),
    first("over{QQ(sqrt(3)); 1 + 1 == 2}", None, {"kind": "identity"}),
    first("division", "QQ", anisotropic("2"), method="anisotropic norm"),
    first(
        "division",
        "QQ(sqrt(5))",
        {"kind": "anisotropic", "by": "ordering"},
        method="anisotropic norm",
    ),
    first("division", "QQ(sqrt(-7))", anisotropic("(2, sqrt(-7)-1)"), method="anisotropic norm"),
    first("p*q == q*p", None, {"kind": "over", "field": "Q", "evidence": {}}, verdict="refuted"),
]
CASES[-1]["evidence"] = {
    "kind": "witness", "field": "Q", "values": {"p": ["0", "1", "0", "0"], "q": ["0", "0", "1", "0"]}
}  # fmt: skip


@pytest.mark.parametrize("data", CASES, ids=[f"{c['statement']} {c['field']}" for c in CASES])
def test_what_is_written_is_accepted(
    data: dict[str, Any], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    old, new = tmp_path / "old.json", tmp_path / "new.json"
    old.write_text(json.dumps(data))
    assert main(["upgrade", str(old), "-o", str(new)]) == 0
    found = json.loads(new.read_text())
    assert found["schema"] == "hfield-cert/2"
    assert check(found).verdict == data["verdict"]
    assert data["verdict"] in capsys.readouterr().err
    assert main(["upgrade", str(old), str(old), "--into", str(tmp_path / "folder")]) == 0
    assert json.loads((tmp_path / "folder" / "old.json").read_text()) == found


def test_names_outside_the_table_wait_for_the_command() -> None:
    with pytest.raises(Rejected, match="hfield upgrade"):
        check(CASES[0])
    with pytest.raises(Rejected, match="hfield upgrade"):
        check(CASES[5])
    assert check(CASES[3]).verdict == "proved"


def test_bad_usage(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "one.json"
    path.write_text(json.dumps({**CASES[0], "schema": "hfield-cert/2"}))
    assert main(["upgrade", str(path)]) == 1
    assert "this is not a certificate hfield-cert/1" in capsys.readouterr().err
    path.write_text(json.dumps({**CASES[0], "field": "GF(6)"}))
    assert main(["upgrade", str(path)]) == 1
    assert "nothing is written: GF(6)" in capsys.readouterr().err
    path.write_text("{")
    assert main(["upgrade", str(path)]) == 1
    assert main(["upgrade", str(tmp_path / "none.json")]) == 2
    assert main(["upgrade", str(path), str(path)]) == 2
    assert main(["upgrade"]) == 2
    forged = {**CASES[0], "statement": "p*q == q*p"}
    path.write_text(json.dumps(forged))
    assert main(["upgrade", str(path)]) == 1
    assert "rejected" in capsys.readouterr().err
