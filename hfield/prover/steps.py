"""The lines of a proof, as sentences from ``steps.json`` in several languages."""

import json
from collections.abc import Callable, Mapping
from functools import cache
from pkgutil import get_data


class Step(str):
    """A step of a proof: an English sentence with its key and the values of its slots."""

    name: str
    slots: Mapping[str, str]

    def at(self, text: str) -> "Step":
        """Return the step with its text indented differently."""
        line = Step(text)
        line.name, line.slots = self.name, self.slots
        return line

    def strip(self, chars: str | None = None) -> "Step":
        """Return the line without surrounding blanks."""
        return self.at(super().strip(chars))

    def said(self, language: str, other: Callable[[str], str | None]) -> str | None:
        """Return the sentence in a language; ``other`` translates slots that are not steps."""
        said = {}
        for slot, value in self.slots.items():
            text = value.said(language, other) if isinstance(value, Step) else other(value)
            if text is None:
                return None
            said[slot] = text
        return sentences()[self.name][language].format_map(said)


@cache
def sentences() -> dict[str, dict[str, str]]:
    """Return the sentences by name and language."""
    table: dict[str, dict[str, str]] = json.loads(get_data("hfield.prover", "steps.json") or "{}")
    return table


def say(name: str, **slots: object) -> Step:
    """Return a sentence of the table with its slots filled by formulas, numbers or other lines.

    >>> say("all-zero", R="ℤ").said("pl", str)
    'wszystkie współczynniki różnicy są równe 0 w ℤ'
    """
    filled = {slot: x if isinstance(x, Step) else str(x) for slot, x in slots.items()}
    line = Step(sentences()[name]["en"].format_map(filled))
    line.name, line.slots = name, filled
    return line


def indented(line: str) -> str:
    """Return a line with more indentation."""
    return line.at(f"  {line}") if isinstance(line, Step) else f"  {line}"
