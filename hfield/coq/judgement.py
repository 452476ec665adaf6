"""A certificate about a statement of the language as a theorem of Coq, proved by its evidence.

The theorem is read from the statement, the algebra and the field alone. The evidence becomes data
for computations that Coq has proved to be right (evidence.v, judges.v): where it does not show the
statement, Coq rejects the proof.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product
from typing import Any

from hfield.coq.cofactors import MismatchError
from hfield.coq.formulas import Formula, Formulas, Junction, grouped
from hfield.coq.implied import Directly, Items, facts_used
from hfield.coq.rooms import (
    FIELDS,
    INTEGERS,
    MAX_MODULUS,
    MAX_PRIME,
    RATIONALS,
    RINGS,
    Room,
    of_characteristic,
    room_of,
    value_in,
)
from hfield.coq.terms import NotCoveredError, Terms
from hfield.errors import TooLargeError
from hfield.proving.polynomials.vanishing import prime_factors
from hfield.proving.statements.language import Sort, Statement, read_statement
from hfield.proving.statements.printing import to_text
from hfield.proving.statements.setting import Setting
from hfield.proving.statements.trees import substitute, walk
from hfield.rings import ring
from hfield.syntax import Binary, Compare, Logic, Name, Node, Not, parse

MAX_CASES = 300_000
MAX_WORDS = 64  # of a list of tuples of basis vectors
IN_RINGS = "rings.v"
COMPUTED = "vm_cast_no_check (@eq_refl bool true)."


@dataclass(frozen=True)
class Proved:
    """A proposition with its proof, and what has to stand before it."""

    text: str
    proof: tuple[str, ...]
    before: tuple[str, ...] = ()
    place: str = ""  # the section of the file in which it has to stand

    def lemma(self, name: str, word: str = "Lemma") -> str:
        """Return it under a name."""
        lines = "\n".join(f"  {line}" for line in self.proof)
        whole = f"{word} {name} :\n  {self.text}.\nProof.\n{lines}\nQed."
        return "\n".join([*self.before, whole])


class Sentence:
    """A statement in one room: its text, and the same as data."""

    def __init__(self, statement: Statement, setting: Setting, room: Room) -> None:
        if statement.constants:
            raise NotCoveredError(f"{statement.constants[0]!r} names a constant of the field")
        self.statement, self.setting, self.room = statement, setting, room
        sorts = statement.unknowns
        self.given = [(n, s) for n, s in sorts if n not in statement.exists]
        self.found = [(n, s) for n, s in sorts if n in statement.exists]
        self.terms = Terms(self.given, self.found, setting.constants)
        formulas = Formulas(self.terms, room.type, room.is_field)
        self.defined = [formulas.defined(d) for d in self.terms.defined]
        self.hypotheses = [*self.defined, *(formulas.of(h) for h in statement.hypotheses)]
        self.conclusion = formulas.of(statement.conclusion)

    @property
    def order(self) -> list[tuple[str, Sort]]:
        """The given unknowns in the order in which they are quantified."""
        return [x for x in self.terms.ordered if x in self.given]

    @property
    def body(self) -> str:
        """What the statement says of the room."""
        shown = self.conclusion.text
        if self.found:
            order = [x for x in self.terms.ordered if x in self.found]
            shown = f"exists {_binders(order, self.room)}, {shown}"
        body = " ->\n  ".join([*(grouped(h) for h in self.hypotheses), shown])
        return f"forall {_binders(self.order, self.room)},\n  {body}" if self.given else body

    @property
    def text(self) -> str:
        """The whole proposition."""
        return f"{self.room.opening}{self.body}"

    @property
    def data(self) -> str:
        """The statement as data."""
        constants = " ".join(part.argument for part in self.terms.parts)
        given, found = _count(self.given), _count(self.found)
        hypotheses = "; ".join(h.data for h in self.hypotheses)
        return f"(Statement {constants} {given} [{hypotheses}]\n    {found}\n    ({self.conclusion.data}))"

    @property
    def formulas(self) -> list[Formula]:
        """Hypotheses and conclusion."""
        return [*self.hypotheses, self.conclusion]

    @property
    def intros(self) -> str:
        """The tactic that introduces the ring and the unknowns."""
        names = f"{self.room.names} {' '.join(n for n, _ in self.order)}".strip()
        return f"intros {names}." if names else "idtac."

    @property
    def arguments(self) -> str:
        """The same names, as arguments."""
        return f"{self.room.names} {' '.join(n for n, _ in self.order)}".strip()


def _count(unknowns: Sequence[tuple[str, Sort]]) -> str:
    quaternions = sum(s is Sort.QUATERNION for _, s in unknowns)
    return f"{quaternions} {len(unknowns) - quaternions}"


def _binders(order: Sequence[tuple[str, Sort]], room: Room) -> str:
    groups = []
    kind = room.type if " " not in room.type else f"({room.type})"
    for sort, shown in ((Sort.QUATERNION, f"quaternion {kind}"), (Sort.SCALAR, room.type)):
        names = [n for n, s in order if s is sort]
        if names:
            groups.append(f"({' '.join(names)} : {shown})")
    return " ".join(groups)


class Judgement:
    """Turns the evidence for one statement into a proof."""

    def __init__(self, name: str, text: str, setting: Setting) -> None:
        self.name, self.setting = name, setting
        self.statement = self._read(text, setting)

    def _read(self, text: str, setting: Setting) -> Statement:
        return read_statement(text, setting.field, (), setting.letters, setting.constants)

    def _about(self, node: Node, setting: Setting | None = None) -> "Judgement":
        """Return the same for another statement."""
        out = object.__new__(Judgement)
        out.name, out.setting = self.name, setting or self.setting
        out.statement = self._read(to_text(node), out.setting)
        return out

    # --- verdicts --------------------------------------------------------------------------------

    def proved(self, evidence: Mapping[str, Any]) -> Proved:
        """Prove the statement."""
        kind = evidence.get("kind")
        if self.statement.exists:
            match kind:
                case "witness":
                    return self._example(evidence)
                case "exhaustion":
                    return self._exhausted()
                case "terms":
                    return self._terms(evidence)
                case "cases":
                    return self._cases(evidence)
            raise NotCoveredError(f"evidence of the kind {kind!r} for something that exists")
        match kind:
            case "identity":
                return self._implied([])
            case "implication":
                return self._implied(evidence["items"], evidence["facts"])
            case "exhaustion":
                return self._exhausted()
            case "multilinear":
                return self._multilinear(evidence)
            case "fractions" if self.setting.field == ring("ZZ") and evidence["field"] == "QQ":
                return self.proved(evidence["proof"])
        raise NotCoveredError(f"evidence of the kind {kind!r}")

    def refuted(self, evidence: Mapping[str, Any]) -> Proved:
        """Prove the opposite of the statement."""
        kind = evidence.get("kind")
        if kind == "witness" and not self.statement.exists:
            return self._counterexample(evidence)
        if kind in ("none exists", "place") and self.statement.exists:
            return self._none_exists(evidence)
        raise NotCoveredError(f"evidence of the kind {kind!r} against a statement")

    def vacuous(self, evidence: Mapping[str, Any]) -> Proved:
        """Prove that the hypotheses never hold together."""
        if evidence.get("kind") != "unsatisfiable" or not self.statement.hypotheses:
            raise NotCoveredError(f"evidence of the kind {evidence.get('kind')!r}")
        return self._about(Not(_conjunction(self.statement.hypotheses))).proved(evidence["proof"])

    def true_vacuously(self, evidence: Mapping[str, Any]) -> Proved:
        """Prove the statement itself from hypotheses that never hold together."""
        never, lemma = self.vacuous(evidence), f"{self.name}_never"
        sentence = self.sentence
        if sentence.found or not never.text.startswith(sentence.room.opening):
            raise NotCoveredError("what follows from hypotheses that never hold")
        names = [f"h{n}" for n in range(len(sentence.hypotheses))]
        lines = [sentence.intros, f"intros {' '.join(names)}.", "exfalso."]
        unknowns = {n for h in self.statement.hypotheses for n in _names(h)}
        kept = [n for n, _ in sentence.order if n in unknowns]
        call = f"{lemma} {sentence.room.names} {' '.join(kept)}".strip()
        lines.append(f"pose proof ({call}) as never; tauto.")
        return Proved(sentence.text, tuple(lines), (never.lemma(lemma),))

    @property
    def sentence(self) -> Sentence:
        """The statement as a proposition, over the field or over every field."""
        field = self.setting.field
        return Sentence(self.statement, self.setting, FIELDS if field is None else room_of(field))

    def by(self, verdict: str, evidence: Mapping[str, Any]) -> Proved:
        """Prove what a verdict says."""
        return {"proved": self.proved, "refuted": self.refuted, "vacuous": self.vacuous}[verdict](
            evidence
        )

    # --- all values ------------------------------------------------------------------------------

    def _implied(
        self, items: Sequence[Mapping[str, Any]], facts: Sequence[Mapping[str, Any]] = ()
    ) -> Proved:
        field = self.setting.field
        room = FIELDS if field is None else room_of(field)
        self._check_facts(facts_used(items), facts, room)
        if field is None:
            return self._everywhere(items)
        p = room.characteristic
        if room.is_field and p > MAX_PRIME:
            room = of_characteristic(p)
        sentence = Sentence(self.statement, self.setting, room)
        read = Items(sentence.terms, items)
        if any(i.characteristic not in (0, p) for i in read.items):
            raise MismatchError("an item is about another characteristic")
        divides = self.statement.divides or bool(sentence.defined)
        if not room.is_field and divides:
            raise NotCoveredError(f"division over {field.name}, except by all cases")
        evidence = read.hints(sentence.formulas, read.items, p if p <= MAX_PRIME else 0)
        if room is RATIONALS:
            evidence = replace(evidence, numbers=_divisors(self.setting))
            return _computed(sentence, f"over_rationals\n  ({evidence})%text\n  {sentence.data} _")
        if room is INTEGERS:
            if self._directly(sentence, read):
                judge = f"over_the_integers_directly\n  ({evidence})%text\n  {sentence.data} _"
            else:
                judge = f"integers\n  ({evidence})%text\n  {sentence.data} _ _"
            return _computed(sentence, judge)
        if not room.is_field:
            return _computed(
                sentence, f"residue_ring {p}\n  ({evidence})%text\n  {sentence.data} _"
            )
        if room.is_one_ring:
            width = len(sentence.terms.numerators.atoms) if evidence.vanishing else 0
            return _computed(
                sentence, f"prime_field {p} {width}\n  ({evidence})%text\n  {sentence.data} _ _ _"
            )
        return _computed(
            sentence, f"characteristic_fields {p}\n  ({evidence})%text\n  {sentence.data} _"
        )

    def _check_facts(self, used: set[str], facts: Sequence[Mapping[str, Any]], room: Room) -> None:
        """Raise NotCoveredError for what Coq does not know, MismatchError for what is wrong."""
        for form in used & {"norm", "squares"}:
            fact = next((f for f in facts if f["form"] == form), None)
            if fact is None:
                raise MismatchError(f"a step uses the fact {form!r}, which is not there")
            if "algebra" in fact:
                raise NotCoveredError("the norm form of another algebra than the statement's")
            known = room in (RATIONALS, INTEGERS)
            if known and (form == "squares" or _is_definite(self.setting)):
                continue
            by = fact["by"]
            if room is FIELDS or by == "ordering" or (form == "norm" and not known):
                raise MismatchError(f"the fact {form!r} by {by!r} does not hold there")
            raise NotCoveredError(f"the fact {form!r} by {by!r} over {room.type}")

    def _directly(self, sentence: Sentence, read: Items) -> bool:
        """Tell whether the items show the statement without dividing by anything."""
        usable = [i for i in read.items if not i.characteristic and i.denominators <= {1, -1}]
        goal = sentence.conclusion
        for h in reversed(sentence.hypotheses):
            goal = Junction("=>", h, goal)
        return Directly(usable).derives([], goal)

    def _everywhere(self, items: Sequence[Mapping[str, Any]]) -> Proved:
        general = not (self.statement.divides or self.statement.compares_unequal)
        if general:
            sentence = Sentence(self.statement, self.setting, RINGS)
            read = Items(sentence.terms, items)
            if not sentence.defined and self._directly(sentence, read):
                usable = [i for i in read.items if i.is_direct and i.denominators <= {1, -1}]
                usable = [i for i in usable if not i.characteristic]
                evidence = read.hints(sentence.formulas, usable, 0)
                judge = f"commutative_rings\n  ({evidence})%text\n  {sentence.data} _"
                return _computed(sentence, judge)
        sentence = Sentence(self.statement, self.setting, FIELDS)
        read = Items(sentence.terms, items)
        general_items = [i for i in read.items if not i.characteristic]
        divided = {abs(d) for i in general_items for d in i.denominators}
        if 0 in divided:
            raise MismatchError("a denominator is 0")
        primes = {i.characteristic for i in read.items} - {0}
        for d in divided:
            primes |= set(_primes(d))
        special = []
        for p in sorted(primes):
            own = [
                i
                for i in read.items
                if i.characteristic == p
                or (not i.characteristic and all(d % p for d in i.denominators))
            ]
            special.append(f"({p}%Z, ({read.hints(sentence.formulas, own, 0)})%text)")
        evidence = read.hints(sentence.formulas, general_items, 0)
        listed = "[" + ";\n   ".join(special) + "]"
        return _computed(
            sentence, f"fields\n  ({evidence})%text\n  {listed}\n  {sentence.data} _ _"
        )

    def _one_room(self) -> tuple[Room, Sentence]:
        if self.setting.field is None:
            raise NotCoveredError("something computed over all fields at once")
        room = room_of(self.setting.field)
        return room, Sentence(self.statement, self.setting, room)

    def _exhausted(self) -> Proved:
        room, sentence = self._one_room()
        n = room.characteristic
        width = sum(4 if s is Sort.QUATERNION else 1 for _, s in self.statement.unknowns)
        if not n or n > MAX_MODULUS or n**width > MAX_CASES:
            raise NotCoveredError(f"exhaustion of more than {MAX_CASES} cases")
        return _computed(sentence, f"residues_all_cases {n} {sentence.data} _ _")

    def _multilinear(self, evidence: Mapping[str, Any]) -> Proved:
        whole = self._implied([])
        names = [n for n, s in self.statement.unknowns if s is Sort.QUATERNION]
        tree = self.statement.conclusion
        words = dict(evidence["tuples"])
        if (
            not isinstance(tree, Compare)
            or evidence["unknowns"] != names
            or set(words) != set(map("".join, product("eijk", repeat=len(names))))
            or len(words) != len(evidence["tuples"])
        ):
            raise MismatchError("the list of tuples is not one for the statement")
        if len(words) > MAX_WORDS:
            raise NotCoveredError(f"a list of more than {MAX_WORDS} tuples of basis vectors")
        parts: list[Node] = []
        for word, value in words.items():
            put = {n: Name(x) for n, x in zip(names, word, strict=True)}
            shown = " + ".join(f"({int(c)})*{u}" for c, u in zip(value, "eijk", strict=True))
            for side in (tree.left, tree.right):
                parts.append(Compare("==", substitute(side, put), parse(shown)))
        values = self._about(_conjunction(parts)).proved({"kind": "identity"})
        tuples = f"{self.name}_tuples"
        return replace(whole, before=(values.lemma(tuples), *whole.before))

    # --- some values -----------------------------------------------------------------------------

    def _values(
        self,
        room: Room,
        values: Mapping[str, Sequence[str]],
        sentence: Sentence,
        unknowns: Sequence[tuple[str, Sort]],
    ) -> tuple[str, str]:
        if set(values) != {n for n, _ in unknowns}:
            raise MismatchError("the witness is not one for these unknowns")
        quaternions, scalars = [], []
        for name, sort in sentence.terms.ordered:
            if (name, sort) not in unknowns:
                continue
            found = [value_in(room, text) for text in values[name]]
            if len(found) != (4 if sort is Sort.QUATERNION else 1):
                raise MismatchError(f"{name} has {len(found)} coordinates")
            if sort is Sort.QUATERNION:
                quaternions.append(f"Quaternion {' '.join(found)}")
            else:
                scalars += found
        return f"[{'; '.join(quaternions)}]", f"[{'; '.join(scalars)}]"

    def _counterexample(self, evidence: Mapping[str, Any]) -> Proved:
        field = ring(evidence["field"])
        if self.setting.field is not None and self.setting.field != field:
            raise MismatchError("the witness is from another field")
        room = room_of(field)
        here = replace(self.setting, field=field)
        statement = self._read(self.statement.text, here)
        _check_listed(statement, room)
        sentence = Sentence(statement, here, room)
        values = self._values(room, evidence["values"], sentence, sentence.order)
        call = f"({sentence.data})\n  {values[0]} {values[1]}"
        judge = _named(room, "residues_fail", "rationals_fail", "integers_fail", call)
        if self.setting.field is not None:
            return Proved(f"~ ({sentence.body})", (f"refine ({judge}).", f"all: {COMPUTED}"))
        if not room.is_field:
            raise MismatchError(f"{field.name} is no field")
        everywhere = Sentence(self.statement, self.setting, FIELDS)
        p = room.characteristic
        if p > MAX_PRIME:
            raise NotCoveredError(f"a counterexample in GF(p) with p above {MAX_PRIME}")
        if p:
            lines = [
                "intro F.",
                f"assert (prime : is_prime {p} = true) by ({COMPUTED[:-1]}).",
                f"unshelve refine ({judge} (F (GF {p}) _ _ (GF_field {p} prime))).",
                f"all: {COMPUTED}",
            ]
        else:
            lines = [
                "intro F.",
                f"unshelve refine ({judge} (F Qc _ _ rational_field)).",
                f"all: {COMPUTED}",
            ]
        return Proved(f"~ ({everywhere.text})", tuple(lines))

    def _example(self, evidence: Mapping[str, Any]) -> Proved:
        room, sentence = self._one_room()
        _check_listed(self.statement, room)
        values = self._values(room, evidence["values"], sentence, sentence.found)
        call = f"({sentence.data})\n  {values[0]} {values[1]}"
        judge = _named(room, "residues_example", "rationals_example", "integers_example", call)
        return _computed(sentence, judge)

    # --- existence -------------------------------------------------------------------------------

    def _terms(self, evidence: Mapping[str, Any]) -> Proved:
        lemma = f"{self.name}_instance"
        trees = self._trees(evidence["terms"])
        instance, known = self._instance(trees, [], evidence["proof"])
        room = RINGS if instance.text.startswith(RINGS.opening) else self._room(instance)
        sentence = Sentence(self.statement, self.setting, room)
        names = [f"h{n}" for n in range(len(sentence.hypotheses))]
        lines = [
            sentence.intros,
            *([f"intros {' '.join(names)}."] if names else []),
            f"pose proof ({_call(lemma, instance, room, known)} {' '.join(names)}) as known.",
            *self._there(sentence, trees),
        ]
        return Proved(sentence.text, tuple(lines), (instance.lemma(lemma),))

    def _room(self, proved: Proved) -> Room:
        """Return the room of something proved for the field of the certificate, or for all fields."""
        field = self.setting.field
        if field is None:
            return FIELDS
        room = room_of(field)
        large = of_characteristic(room.characteristic)
        return large if proved.text.startswith(large.opening) else room

    def _trees(self, terms: Mapping[str, str]) -> dict[str, Node]:
        """Return the terms for what exists, scalars as quaternions where these are sought."""
        if set(terms) != set(self.statement.exists):
            raise MismatchError("the terms are not those of what exists")
        trees = {name: parse(text) for name, text in terms.items()}
        given = [(n, s) for n, s in self.statement.unknowns if n not in self.statement.exists]
        own = Terms(given, [], self.setting.constants)
        for name, sort in self.statement.unknowns:
            if name in trees and (own.term(trees[name]).is_scalar) != (sort is Sort.SCALAR):
                if sort is Sort.SCALAR:
                    raise MismatchError(f"the term for {name} is no scalar")
                trees[name] = Binary("*", trees[name], Name("e"))
        return trees

    def _there(self, sentence: Sentence, trees: Mapping[str, Node]) -> list[str]:
        """Return the tactics that name what exists, when it is known that it serves."""
        terms = Terms(sentence.given, [], self.setting.constants)
        named = [terms.term(trees[n]).inner for n, _ in sentence.terms.ordered if n in trees]
        return [*(f"exists {text}." for text in named), "first [exact known | tauto]."]

    def _instance(
        self, trees: Mapping[str, Node], more: Sequence[Node], proof: Mapping[str, Any]
    ) -> tuple[Proved, "Judgement"]:
        """Prove the statement with terms put in, under the hypotheses ``more``."""
        whole = substitute(self.statement.conclusion, trees)
        for h in reversed([*more, *self.statement.hypotheses]):
            whole = Logic("=>", h, whole)
        other = self._about(whole)
        if not {n for n, _ in other.statement.unknowns} <= set(self._given):
            raise MismatchError("the terms are about other unknowns than those given")
        return other.proved(proof), other

    @property
    def _given(self) -> list[str]:
        return [n for n, _ in self.statement.unknowns if n not in self.statement.exists]

    def _cases(self, evidence: Mapping[str, Any]) -> Proved:
        """Prove existence by terms for each of some cases, one of which is always there."""
        cases = evidence["cases"]
        conditions = [parse(case["when"]) for case in cases]
        one_of = conditions[-1]
        for condition in reversed(conditions[:-1]):
            one_of = Logic("or", condition, one_of)
        for h in reversed(self.statement.hypotheses):
            one_of = Logic("=>", h, one_of)
        covered = self._about(one_of)
        if not {n for n, _ in covered.statement.unknowns} <= set(self._given):
            raise MismatchError("the cases are about other unknowns than those given")
        cover = covered.proved(evidence["cover"])
        before = [cover.lemma(f"{self.name}_cover")]
        room = self._room(cover)
        sentence = Sentence(self.statement, self.setting, room)
        names = [f"h{n}" for n in range(len(sentence.hypotheses))]
        defined, rest = names[: len(sentence.defined)], names[len(sentence.defined) :]
        pattern = "w"
        for _ in conditions[:-1]:
            pattern = f"[w | {pattern}]"
        call = _call(f"{self.name}_cover", cover, room, covered)
        lines = [sentence.intros, *([f"intros {' '.join(names)}."] if names else [])]
        lines.append(f"destruct ({call} {' '.join(names)}) as {pattern}.")
        for n, (case, condition) in enumerate(zip(cases, conditions, strict=True), 1):
            trees = self._trees(case["terms"])
            instance, known = self._instance(trees, [condition], case["proof"])
            lemma = f"{self.name}_case_{n}"
            before.append(instance.lemma(lemma))
            call = _call(lemma, instance, room, known)
            lines.append(f"- pose proof ({call} {' '.join([*defined, 'w', *rest])}) as known.")
            lines += [f"  {line}" for line in self._there(sentence, trees)]
        return Proved(sentence.text, tuple(lines), tuple(before))

    def _none_exists(self, evidence: Mapping[str, Any]) -> Proved:
        """Refute that something exists: for some values of what is given, nothing serves."""
        field, statement = self.setting.field, self.statement
        if field is None:
            field = ring(evidence["field"])
        if self.setting.letters:
            raise NotCoveredError("that nothing exists, in an algebra with letters")
        here = replace(self.setting, field=field)
        room = room_of(field)
        sentence = Sentence(self._read(statement.text, here), here, room)
        matrix, proof = statement.conclusion, evidence["proof"]
        for h in reversed(statement.hypotheses):
            matrix = Logic("=>", h, matrix)
        arguments = []
        if evidence["kind"] == "place":
            values = {name: _tree(texts) for name, texts in evidence["values"].items()}
            if set(values) != set(self._given):
                raise MismatchError("the place is not one for what is given")
            matrix = substitute(matrix, values)
            own = Terms([], [], here.constants)
            for name, sort in sentence.order:
                x = own.term(values[name])
                if x.conditions:
                    raise NotCoveredError("a place with fractions")
                arguments.append((own.embed(x) if sort is Sort.QUATERNION else x).inner)
            if proof["kind"] != "none exists":
                raise MismatchError("a place refutes by evidence of the kind 'none exists'")
            proof = proof["proof"]
        elif self._given:
            raise MismatchError("nothing is said about the unknowns that are given")
        other = self._about(Not(matrix), here)
        never = other.proved(proof)
        if not never.text.startswith(other.sentence.body):
            raise NotCoveredError("that nothing exists, in a field that Coq does not compute in")
        lemma = f"{self.name}_never"
        order = [n for n, _ in other.sentence.order]
        zeros = ["(embed 0)" if s is Sort.QUATERNION else "0" for _, s in other.sentence.order]
        names = [f"h{n}" for n in range(len(sentence.hypotheses))]
        found = [n for n, _ in sentence.terms.ordered if n in statement.exists]
        pattern = "c"
        for name in reversed(found):
            pattern = f"[{name} {pattern}]"
        everywhere = self.setting.field is None
        lines = ["intro F."]
        start = "F"
        if everywhere:
            p = room.characteristic
            if p:
                lines.append(f"assert (prime : is_prime {p} = true) by ({COMPUTED[:-1]}).")
            start = f"F (GF {p}) _ _ (GF_field {p} prime)" if p else "F Qc _ _ rational_field"
        lines.append(f"pose proof ({' '.join([start, *arguments])}) as G.")
        if names:
            lines.append(f"apply ({' '.join([lemma, *zeros])}); intros {' '.join(names)}; exfalso.")
        lines.append(f"destruct ({' '.join(['G', *names])}) as {pattern}.")
        lines.append(f"apply ({' '.join([lemma, *order])}); intros; exact c.")
        whole = self._whole_text(sentence)
        return Proved(f"~ ({whole})", tuple(lines), (never.lemma(lemma),))

    def _whole_text(self, sentence: Sentence) -> str:
        if self.setting.field is not None:
            return sentence.body
        return Sentence(self.statement, self.setting, FIELDS).text


def _call(lemma: str, proved: Proved, room: Room, judgement: "Judgement") -> str:
    """Return a lemma applied to the ring and the unknowns of a proof in the room."""
    names = room.names
    if proved.text.startswith(RINGS.opening) and room is not RINGS:
        names = "R operations (F_R (proj1 laws))"
    own = [n for n, _ in judgement.sentence.order]
    return " ".join(x for x in (lemma, names, *own) if x)


def _tree(texts: Sequence[str]) -> Node:
    """Return the tree of c0*e + c1*i + c2*j + c3*k, or of a scalar."""
    if len(texts) == 1:
        return parse(texts[0])
    parts = [Binary("*", parse(c), Name(u)) for c, u in zip(texts, "eijk", strict=True)]
    return Binary("+", Binary("+", parts[0], parts[1]), Binary("+", parts[2], parts[3]))


def _computed(sentence: Sentence, judge: str) -> Proved:
    return Proved(sentence.text, (f"refine ({judge}).", f"all: {COMPUTED}"))


def _names(node: Node) -> set[str]:
    return {n.name for n in walk(node) if isinstance(n, Name)}


def _named(room: Room, residues: str, rationals: str, integers: str, call: str) -> str:
    if room is RATIONALS:
        return f"{rationals} {call} _"
    if room is INTEGERS:
        return f"{integers} {call} _"
    return f"{residues} {room.characteristic} {call} _ _"


def _check_listed(statement: Statement, room: Room) -> None:
    if room.characteristic > MAX_MODULUS and statement.divides:
        raise NotCoveredError(f"division modulo a number above {MAX_MODULUS}")


def _conjunction(parts: Sequence[Node]) -> Node:
    out = parts[-1]
    for part in reversed(parts[:-1]):
        out = Logic("and", part, out)
    return out


def _divisors(setting: Setting) -> tuple[int, ...]:
    """Return the numbers that the structure constants divide by."""
    found: set[int] = set()

    def visit(node: Node) -> None:
        if isinstance(node, Binary):
            visit(node.left)
            visit(node.right)
            if node.op == "/" and hasattr(node.right, "value"):
                found.add(int(node.right.value))

    for text in setting.constants:
        visit(parse(text))
    return tuple(sorted(found - {0, 1}))


def _is_definite(setting: Setting) -> bool:
    """Tell whether t*t + 4*a and b are negative rationals."""
    try:
        a, t, b = (Fraction(text) for text in setting.constants)
    except ValueError:
        return False
    return t * t + 4 * a < 0 and b < 0


def _primes(n: int) -> list[int]:
    primes = prime_factors(n)
    if primes is None:
        raise TooLargeError("a denominator is too large to factor")
    return primes
