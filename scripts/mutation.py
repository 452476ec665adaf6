"""Mutation testing by mutmut: change a line, see whether a test notices.

    pip install 'mutmut>=3.8'
    nice python scripts/mutation.py product implication      # or --list, or all of them
    nice python scripts/mutation.py polynomials --show       # with the diffs of the survivors

Each part of the code is mutated in a copy of the repository and tried with the few test files that
are about it; mutmut runs for each mutant only the tests that reach its function, in a forked process.
docs/developers/mutation.md has the scores and explains the survivors.
"""

import argparse
import json
import random
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).parents[1]
CORE = ("core_cases", "core_implications", "core_reading", "core_rules")
ALL_CORE = (*CORE, "forged", "messages", "polynomials", "rejected")
CHECKER = (
    *(f"tests/checker/test_{name}.py" for name in ALL_CORE),
    "tests/adversary/test_breaks.py",
)
# Tests that take seconds each and are not about the part: they compile, import, or draw any text.
LEFT_OUT = {"rings": "not galois and not any_text and not of_all_candidates"}
# What is mutated, and the tests that are to notice.
PARTS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "product": (("hfield/core/product.py",), ("tests/adversary/test_product.py",)),
    "polynomials": (
        ("hfield/checker/polynomials.py",),
        ("tests/checker/test_polynomials.py", "tests/checker/test_core_reading.py"),
    ),
    "checker": (
        (
            "hfield/checker/evidence/*.py",
            *(
                f"hfield/checker/{name}.py"
                for name in (
                    *("check", "clauses", "evaluate", "check_result"),
                    *("json_text", "over_field", "statement", "values"),
                )
            ),
        ),
        CHECKER,
    ),
    "places": (
        ("hfield/checker/anisotropy.py", "hfield/checker/scalars/residues.py"),
        ("tests/adversary/test_places.py", "tests/checker/test_local_facts.py"),
    ),
    "vocabulary": (
        (
            "hfield/checker/vocabulary/*.py",
            "hfield/checker/rules.py",
            "hfield/checker/ideal_membership.py",
        ),
        (
            *CHECKER,
            *(
                f"tests/checker/test_{name}.py"
                for name in ("norm_forms", "presentation", "real_words", "vocabulary")
            ),
        ),
    ),
    "scalars": (
        ("hfield/checker/scalars/*.py",),
        (
            *("tests/adversary/test_primitives.py", "tests/adversary/test_places.py"),
            *(
                f"tests/checker/test_{name}.py"
                for name in ("arithmetic", *CORE, "local_facts", "reading", "scalars")
            ),
        ),
    ),
    "implication": (
        ("hfield/prover/methods/implications.py",),
        (
            "tests/adversary/test_breaks.py",
            "tests/prover/test_evidence.py",
            "tests/prover/test_verdicts.py",
            "tests/prover/test_scopes.py",
        ),
    ),
    "rings": (
        ("hfield/fields/base/*.py", "hfield/fields/rationals/ring.py", "hfield/fields/finite/*.py"),
        tuple(
            f"tests/fields/test_{name}.py"
            for name in (
                *("operations", "numbers", "finite", "functions", "floats", "names"),
                *(
                    "number_fields",
                    "local",
                    "equal_numbers",
                    "radicands",
                    "enclosures",
                    "extensions",
                ),
                *(
                    "batches_of_any_ring",
                    "powers",
                    "descriptions",
                    "places_and_ideals",
                    "words_for_rings",
                ),
            )
        ),
    ),
}
OUTCOMES = {0: "survived", 1: "killed", 3: "killed", 33: "no tests"}
OUTCOMES |= dict.fromkeys((36, 24, -24, 152), "timeout")
# A mutated message is no fault of the verdict: these lines are left out.
MESSAGES = (r"^\s*(reject|return reject|self\.fail)\(f?\".*\"\)$", r"^\s*f?\"[^\"]*\"$")

# Put in front of the tests of the copy: what a cache remembers was decided by another mutant.
FORGETTING = """

@pytest.fixture(autouse=True)
def _forget():
    for name, module in list(sys.modules.items()):
        if name.startswith("hfield"):
            for value in list(vars(module).values()):
                if hasattr(value, "cache_clear") and not isinstance(value, type):
                    value.cache_clear()
"""


def copied(target: Path, part: str) -> None:
    """Copy what mutmut needs for a part into a folder of its own."""
    sources, tests = PARTS[part]
    for name in ("hfield", "rotation", "anim", "tests", "scripts", "docs"):
        shutil.copytree(ROOT / name, target / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "README.md"):
        shutil.copy(ROOT / name, target / name)
    with (target / "tests" / "conftest.py").open("a") as out:
        out.write(FORGETTING)
    lines = {
        "source_paths": ["hfield"],
        "only_mutate": [
            str(file.relative_to(ROOT)) for source in sources for file in ROOT.glob(source)
        ],
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
            *(["-k", LEFT_OUT[part]] if part in LEFT_OUT else []),
        ],
        "also_copy": [
            *("rotation", "anim", "scripts", "docs", "README.md"),
            *(str(stub.relative_to(ROOT)) for stub in ROOT.glob("hfield/**/*.pyi")),
            *(str(page.relative_to(ROOT)) for page in ROOT.glob("hfield/**/*.toml")),
        ],
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


def run(part: str, show: bool, sample: int, seeds: list[int]) -> Counter[str]:
    """Mutate one part; print its score and the survivors, of a sample for each seed."""
    total: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        copied(folder, part)

        def mutmut(*words: str) -> str:
            command = [sys.executable, "-m", "mutmut", *words]
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
            return done.stdout + done.stderr

        said = mutmut("run", "--max-children", "1", *(["no such mutant"] if sample else []))
        names = sorted(outcomes(folder))
        for seed in seeds if sample else [0]:
            chosen = names
            if sample:
                chosen = random.Random(seed).sample(names, min(sample, len(names)))
                said = mutmut("run", "--max-children", "1", *chosen)
            after = outcomes(folder)
            found = {name: after[name] for name in chosen}
            tally = Counter(found.values())
            if not tally.keys() & {"killed", "survived"}:
                print(said[-3_000:])
            killed, every = tally["killed"] + tally["timeout"], len(found)
            of = f"{every} of {len(after)} drawn, seed {seed}," if sample else f"{every}"
            print(
                f"{part}: {killed} of {of} killed ({killed / max(every, 1):.1%}); {dict(tally)}",
                flush=True,
            )
            for mutant, outcome in found.items():
                if outcome in ("survived", "no tests"):
                    print(f"  {outcome}: {mutant}")
                    if show:
                        diff = mutmut("show", mutant).splitlines()
                        changed = [x for x in diff if x[:1] in "+-" and x[:3] not in ("+++", "---")]
                        print("\n".join(f"      {x}" for x in changed), flush=True)
            total += tally
    return total


def main() -> int:
    """Run; exit status 1 when less than nine in ten are killed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", help=f"of {', '.join(PARTS)}; all of them without one")
    parser.add_argument("--show", action="store_true", help="print the diffs of the survivors")
    parser.add_argument("--list", action="store_true", help="list the parts")
    parser.add_argument("--sample", type=int, default=0, help="draw so many mutants of each part")
    parser.add_argument("--seed", type=int, nargs="+", default=[0], help="of a sample each")
    args = parser.parse_args()
    if args.list:
        for part, (sources, tests) in PARTS.items():
            print(f"{part}: {' '.join(sources)} by {' '.join(tests)}")
        return 0
    total: Counter[str] = Counter()
    for part in args.parts or PARTS:
        total += run(part, args.show, args.sample, args.seed)
    killed = total["killed"] + total["timeout"]
    return int(killed < 0.9 * total.total())


if __name__ == "__main__":
    sys.exit(main())
