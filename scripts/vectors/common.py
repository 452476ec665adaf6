"""Run gp and GAP on generated programs, and write vector files with one case a line.

Shared by the make_*.py and check_*.py scripts of this folder. Nothing here or beside it imports
hfield: the vectors come from other systems only.
"""

import json
import subprocess
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
VECTORS = HERE.parents[1] / "tests" / "vectors"


def _run(command: list[str], program: str, suffix: str) -> list[str]:
    with tempfile.NamedTemporaryFile("w", suffix=suffix) as script:
        script.write(program)
        script.flush()
        done = subprocess.run(
            [*command, script.name],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
        )
    if done.returncode or "***" in done.stdout + done.stderr or "Error" in done.stdout:
        raise RuntimeError(f"{command[0]} failed:\n{done.stdout[-2000:]}\n{done.stderr[:2000]}")
    return done.stdout.splitlines()


def run_gp(program: str) -> list[str]:
    """Return the lines that gp (Debian: pari-gp) prints for the program."""
    flags = ["-q", "--default", "colors=no", "--default", "parisizemax=2G"]
    return _run(["gp", *flags], program, ".gp")


def run_gap(program: str) -> list[str]:
    """Return the lines that GAP (Debian: gap-core) prints; its lines may not be wrapped."""
    head = 'SetPrintFormattingStatus("*stdout*", false);\n'
    return _run(["gap", "-q", "-A", "-b", "-r"], head + program + "\nQUIT;\n", ".g")


def pari_version() -> str:
    return "PARI/GP " + run_gp('v = version(); print(v[1], ".", v[2], ".", v[3]);')[0]


def gap_version() -> str:
    return "GAP " + run_gap('Print(GAPInfo.Version, "\\n");')[0]


def write_cases(name: str, source: Mapping[str, str], cases: Iterable[Mapping[str, Any]]) -> None:
    """Write tests/vectors/NAME with the keys source and cases, one case a line."""
    lines = [json.dumps(case, separators=(",", ":"), ensure_ascii=False) for case in cases]
    VECTORS.mkdir(parents=True, exist_ok=True)
    head = json.dumps(dict(source), ensure_ascii=False)
    body = ",\n".join(lines)
    (VECTORS / name).write_text(f'{{"source":{head},\n"cases":[\n{body}\n]}}\n', encoding="utf-8")
    print(f"{name}: {len(lines)} cases")


def read_cases(name: str) -> list[dict[str, Any]]:
    """Return the cases of tests/vectors/NAME."""
    data = json.loads((VECTORS / name).read_text(encoding="utf-8"))
    cases: list[dict[str, Any]] = data["cases"]
    return cases
