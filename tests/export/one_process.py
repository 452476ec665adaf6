"""Many theorems given to Coq in one process, each judged by itself."""

import subprocess

from hfield.export.coq.coqc import CLOSED, opening


def reject_each(coq, theorems):
    """Tell of each theorem by itself whether Coq rejects it, all in one process of ``coqtop``."""
    coq.compile_library()
    lines = [opening(), "Set Silent."]
    for number, one in enumerate(theorems):
        text = str(one) if not one.place else ""
        # After an error the proof is still open, and nothing has the name.
        lines += [text, "Abort All.", f'Goal True. idtac "@@ {number}". Abort.']
        lines.append(f"Print Assumptions {one.name}.")
    done = subprocess.run(
        [coq.program.replace("coqc", "coqtop"), "-q", "-quiet"],
        cwd=coq.folder,
        input="\n".join(lines) + "\n",
        capture_output=True,
        text=True,
        check=False,
    )
    parts = done.stdout.split("@@ ")[1:]
    assert len(parts) == len(theorems), done.stderr
    return [
        bool(coq.judge([one]).rejected) if one.place else CLOSED not in part
        for one, part in zip(theorems, parts, strict=True)
    ]
