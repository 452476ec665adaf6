from typing import Any
def read_proposition(t): return None
def establish_proposition(*a): raise AssertionError
def proposition_tree(p): return p
