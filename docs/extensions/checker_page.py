"""What the page ``check`` needs beside it: the checker, some certificates, and Pyodide if at hand."""

import json
import shutil
import zipfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
PYODIDE = ROOT / "docs" / "_build" / "node_modules" / "pyodide"
RUNTIME = (
    "pyodide.mjs",
    "pyodide.asm.mjs",
    "pyodide.asm.wasm",
    "pyodide-lock.json",
    "python_stdlib.zip",
)
STATEMENTS = {
    "associative": ("(p*q)*r == p*(q*r)", None),
    "not-commutative": ("p*q == q*p", "QQ"),
    "anisotropic": ("norm(q) == 0 => q == 0", "QQ(sqrt(-7))"),
    "zero-divisors": ("p*q == 0 => p == 0 or q == 0", "GF(9)"),
}


def write(app: Any, exception: Exception | None) -> None:
    """Write the folder ``check`` of the site."""
    if exception is not None or app.builder.format != "html":
        return
    from hfield import prove

    folder = Path(app.outdir) / "check"
    folder.mkdir(exist_ok=True)
    with zipfile.ZipFile(folder / "checker.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("hfield/__init__.py", "")  # the checker imports nothing of the rest
        for path in sorted((ROOT / "hfield" / "checker").rglob("*.py")):
            archive.write(path, path.relative_to(ROOT).as_posix())
    for name, (statement, field) in STATEMENTS.items():
        text = json.dumps(prove(statement, field).certificate, ensure_ascii=False, indent=1)
        (folder / f"{name}.json").write_text(text, encoding="utf-8")
    if PYODIDE.is_dir():
        for name in RUNTIME:
            shutil.copyfile(PYODIDE / name, folder / name)


def setup(app: Any) -> dict[str, bool]:
    """Join Sphinx."""
    app.connect("build-finished", write)
    return {"parallel_read_safe": True}
