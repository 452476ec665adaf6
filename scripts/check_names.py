"""Reject retired words as names of modules and identifiers, and a few of them in prose.

    python -m scripts.check_names            # the faults; exit status 1 if there are any
    python -m scripts.check_names --count    # how often each word stands where

Each retired word has a plain one to use instead. Prose is that of comments, docstrings and pages; of tests
only the prose is read.
"""

import ast
import io
import re
import sys
import tokenize
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
FOLDERS = ("hfield", "rotation", "anim", "scripts", "benchmarks")
PROSE_FOLDERS = (*FOLDERS, "tests", "docs")
NEWS = ("new.md",)  # says what changed in the words of its version

IDENTIFIERS = {
    "held": "stored",
    "hold": "encode",
    "array_held": "array_storage",
    "holding": "storage",
    "array_holding": "array_storage",
    "Held": "the type of a stored value",
    "Holding": "Storage",
    "over_integers": "is_over_number_field; the base is no part of a name",
    "IntegersLattice": "Lattice",
    "IntegersOrder": "Order",
    "IntegersIdeal": "Ideal",
    "IntegersClassSet": "ClassSet",
    "owners": "foreign_values",
    "owner": "parent",
    "handed_on": "lazy_alias",
    "told": "report, current, flag",
    "asked": "name the call",
    "Because": "ExplainedBool",
    "Known": "Fact",
    "Frame": "AlgebraBasis, QuadraticFrame, Pixels",
    "Local": "OrderAtPrime",
    "Keys": "ClassKeys, KeyArray",
    "Around": "SublatticeKeys",
    "growing": "side_search",
    "grown": "enlarged",
    "single_elements": "elements",
    "named_orders": "standard_orders",
    "compatible_products": "ideal_products",
    "modulo_primes": "linear_algebra_mod_p",
    "checked_arguments": "validation",
    "Finding": "CheckResult",
    "charge": "spend",
    "Pin": "ExpectedClaim",
    "look": "search_counterexample, settings, style, check_claim",
    "Look": "RenderSettings",
    "look_quickly": "quick_search",
    "decide_apart": "decide_in_subprocess",
    "answer_here": "decide_in_process",
    "Elsewhere": "ForeignName",
    "elsewhere": "foreign_names, values_at_other_places",
    "looped": "emit_loop",
    "swept": "strided_loop, jacobian_times, rim_points",
    "sweeping": "strided_loop",
    "assembled": "compile_builtin",
    "introduce": "register_symbols",
    "following": "with_derivatives",
    "derived": "is_differentiable",
    "warming": "precompile",
    "swing": "swing_twist",
    "second_test": "second_benchmark",
    "Told": "TranslatedClaim",
    "Worded": "TemplateProposition",
    "Only": "OnlyOver",
    "Over": "InField",
    "carried": "from_general_proof",
    "rooms": "packages",
    "floors": "layers",
    "room": "environment",
    "merge": "outlines",
}
"""Retired identifiers and names of modules, each with what to write instead."""
PROSE = re.compile(
    r"\b(?:held|told|over_integers|handed[_ ]on|owners|is asked|rooms|floors|house)\b",
    re.IGNORECASE,
)
"""What comments, docstrings and pages must not say."""


MADE = {"_build", "api"}
"""Folders of pages that the build of the documentation makes."""


def sources() -> Iterator[Path]:
    """Yield the Python files, and the pages of the documentation."""
    for folder in PROSE_FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            if (
                path.suffix in (".py", ".md")
                and not MADE.intersection(path.parts)
                and path.name not in NEWS
            ):
                yield path


def names(tree: ast.AST) -> Iterator[tuple[str, int]]:
    """Yield the identifiers of a module, each with its line."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                yield name, node.lineno
            case ast.Name(id=name, ctx=ast.Store()) | ast.arg(arg=name):
                yield name, node.lineno
            case ast.Attribute(attr=name, ctx=ast.Store()):
                yield name, node.lineno
            case _:
                pass


def prose(source: str, tree: ast.AST) -> Iterator[tuple[str, int]]:
    """Yield the comments and docstrings of a module, each with its line."""
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            yield token.string, token.start[0]
    for node in ast.walk(tree):
        match node:
            case ast.Expr(value=ast.Constant(value=str(text))):
                yield text, node.lineno
            case _:
                pass


def faults(path: Path) -> Iterator[tuple[str, int]]:
    """Yield the retired words of a file, each with its line."""
    folders = path.relative_to(ROOT).parent.parts
    source = path.read_text(encoding="utf-8")
    if path.suffix == ".md":
        texts: Iterable[tuple[str, int]] = [(source, 1)]
    else:
        tree = ast.parse(source)
        texts = prose(source, tree)
        if folders[0] in FOLDERS:
            yield from ((name, 1) for name in (*folders, path.stem) if name in IDENTIFIERS)
            yield from ((name, line) for name, line in names(tree) if name in IDENTIFIERS)
    for text, line in texts:
        for n, part in enumerate(text.splitlines()):
            yield from ((word.lower(), line + n) for word in PROSE.findall(part))


def main(arguments: list[str]) -> int:
    """Print the faults, or with ``--count`` how many there are; return 1 if there are any."""
    found = [
        (path.relative_to(ROOT), line, word)
        for path in sources()
        if path != Path(__file__).resolve()
        for word, line in faults(path)
    ]
    if "--count" in arguments:
        for word, count in Counter(word for *_, word in found).most_common():
            print(f"{count:5} {word}")
    else:
        for path, line, word in found:
            print(f"{path}:{line}: {word!r} is retired: {IDENTIFIERS.get(word, 'say it plainly')}")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
