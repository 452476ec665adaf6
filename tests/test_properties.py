"""Properties that are computed once."""

from functools import cached_property as pythons

import pytest

from hfield.core.properties import WithoutCaches, cached_property


class Base(WithoutCaches):
    calls = 0

    @cached_property
    def value(self) -> int:
        self.calls += 1
        return 1


class Derived(Base):
    @cached_property
    def value(self) -> int:
        return 10 * super().value

    def of_base(self) -> int:
        return super().value


def test_a_value_is_computed_once() -> None:
    x = Base()
    assert (x.value, x.value, x.calls) == (1, 1, 1)
    del x.value
    assert (x.value, x.calls) == (1, 2)


def test_super_leaves_the_cache_of_the_derived_class() -> None:
    x, y = Derived(), Derived()
    assert (x.of_base(), x.value, x.of_base(), x.value) == (1, 10, 1, 10)
    assert (y.value, y.of_base(), y.value) == (10, 1, 10)


def test_a_property_without_a_name_is_refused() -> None:
    class Late:
        pass

    Late.x = cached_property(lambda self: 1)  # type: ignore[attr-defined]
    late = Late()
    with pytest.raises(TypeError, match="__set_name__"):
        late.x  # type: ignore[attr-defined]  # noqa: B018
    assert vars(late) == {}
    vars(Late)["x"].__set_name__(Late, "x")
    assert (late.x, vars(late)) == (1, {"x": 1})  # type: ignore[attr-defined]


def test_caches_are_left_out_of_states() -> None:
    class Other(WithoutCaches):
        def __init__(self) -> None:
            self.given = 2

        @pythons
        def twice(self) -> int:
            return 2 * self.given

    x = Other()
    assert x.twice == 4
    assert x.__getstate__() == {"given": 2}


def test_a_state_is_taken_while_another_thread_computes_a_value() -> None:
    class AtAccess:
        """Looked up on the class, it lets another thread, as it were, store a value."""

        def __get__(self, instance: object, owner: type) -> int:
            vars(x)["computed"] = 3
            return 0

    class Given(WithoutCaches):
        given = AtAccess()

    x = Given()
    vars(x)["given"] = 1
    assert x.__getstate__() == {"given": 1}
    assert vars(x) == {"given": 1, "computed": 3}
