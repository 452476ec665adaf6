"""Mutation testing by mutmut: change a line, see whether a test notices.

    pip install 'mutmut>=3.8'
    nice python scripts/mutation.py product implication      # or --list, or all of them
    nice python scripts/mutation.py polynomials --show       # with the diffs of the survivors

Each part of the code is mutated in a copy of the repository and tried with the few test files that
are about it; mutmut runs for each mutant only the tests that reach its function, in a forked process.
docs/mutation.md has the scores and explains the survivors.
"""

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[1]
CHECKER = ("tests/adversary/test_checker_rules.py", "tests/certificates")
# What is mutated, and the tests that are to notice.
PARTS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "product": (("hfield/product.py",), ("tests/adversary/test_product.py",)),
    "implication": (
        ("hfield/proving/implication.py",),
        ("tests/adversary/test_scopes.py", "tests/proving/test_evidence.py"),
    ),
    "polynomials": (
        ("hfield/certificates/polynomials.py",),
        ("tests/adversary/test_primitives.py", "tests/certificates/test_polynomials.py"),
    ),
}
OUTCOMES = {0: "survived", 1: "killed", 3: "killed", 33: "no tests"}
OUTCOMES |= dict.fromkeys((36, 24, -24, 152), "timeout")
# A mutated message is no fault of the verdict: these lines are left out.
MESSAGES = (r"^\s*(reject|return reject|self\.fail)\(f?\".*\"\)$", r"^\s*f?\"[^\"]*\"$")


def copied(target: Path, sources: tuple[str, ...], tests: tuple[str, ...]) -> None:
    """Copy what mutmut needs into a folder of its own."""
    for name in ("hfield", "rotation", "anim", "tests", "scripts", "docs"):
        shutil.copytree(ROOT / name, target / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "README.md"):
        shutil.copy(ROOT / name, target / name)
    lines = {
        "source_paths": ["hfield"],
        "only_mutate": list(sources),
        "pytest_add_cli_args_test_selection": list(tests),
        "pytest_add_cli_args": [
            "-p",
            "no:xdist",
            "-p",
            "no:cacheprovider",
            "-x",
            "-q",
            "-o",
            "addopts=",
        ],
        "also_copy": ["rotation", "anim", "scripts", "docs", "README.md"],
        "do_not_mutate_patterns": list(MESSAGES),
    }
    with (target / "pyproject.toml").open("a") as out:
        out.write("\n[tool.mutmut]\nuse_git_change_detection = false\n")
        out.writelines(f"{key} = {json.dumps(value)}\n" for key, value in lines.items())


def outcomes(folder: Path) -> dict[str, str]:
    """Return what became of each mutant."""
    found = {}
    for meta in sorted((folder / "mutants").rglob("*.meta")):
        for name, code in json.loads(meta.read_text())["exit_code_by_key"].items():
            found[name] = OUTCOMES.get(code, f"other ({code})")
    return found


def run(part: str, show: bool, jobs: int) -> Counter[str]:
    """Mutate one part; print its score and the survivors."""
    sources, tests = PARTS[part]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        copied(folder, sources, tests)
        command = [sys.executable, "-m", "mutmut"]
        done = subprocess.run(
            [*command, "run", "--max-children", str(jobs)],
            cwd=folder,
            capture_output=True,
            text=True,
            check=False,
        )
        found = outcomes(folder)
        if not found:
            print(done.stdout[-3000:], done.stderr[-3000:], sep="\n")
        tally = Counter(found.values())
        killed = tally["killed"] + tally["timeout"]
        print(
            f"{part}: {killed} of {len(found)} killed ({killed / max(len(found), 1):.1%}); {dict(tally)}"
        )
        for mutant, outcome in found.items():
            if outcome in ("survived", "no tests"):
                print(f"  {outcome}: {mutant}")
                if show:
                    diff = subprocess.run(
                        [*command, "show", mutant],
                        cwd=folder,
                        capture_output=True,
                        text=True,
                        check=False,
                    ).stdout
                    changed = [
                        x
                        for x in diff.splitlines()
                        if x[:1] in "+-" and x[:3] not in ("+++", "---")
                    ]
                    print("\n".join(f"      {x}" for x in changed))
    return tally


def main() -> int:
    """Run; exit status 1 when less than nine in ten are killed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", help=f"of {', '.join(PARTS)}; all of them without one")
    parser.add_argument("--show", action="store_true", help="print the diffs of the survivors")
    parser.add_argument("--list", action="store_true", help="list the parts")
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    if args.list:
        for part, (sources, tests) in PARTS.items():
            print(f"{part}: {' '.join(sources)} by {' '.join(tests)}")
        return 0
    total: Counter[str] = Counter()
    for part in args.parts or PARTS:
        total += run(part, args.show, args.jobs)
    killed = total["killed"] + total["timeout"]
    return int(killed < 0.9 * total.total())


if __name__ == "__main__":
    sys.exit(main())
