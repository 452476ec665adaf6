"""Plain tensors in a processor's own memory take the compiled formulas; all others those of torch."""

from typing import Any

import numpy as np
import pytest

from rotation import Rotation
from rotation.native import tensors
from rotation.vectors import to_rotvec

torch: Any = pytest.importorskip("torch")
pytest.importorskip("array_api_compat")
V = np.random.default_rng(3).uniform(-1.5, 1.5, (20, 3))  # shorter than π


def test_plain_tensors_have_the_bits_of_numpy() -> None:
    v = torch.as_tensor(V)
    r, theirs = Rotation.from_rotvec(v), Rotation.from_rotvec(V)
    for found, wanted in (
        (r.as_quat(), theirs.as_quat()),
        ((r * r).as_rotvec(), (theirs * theirs).as_rotvec()),
        (r[0].magnitude(), theirs[0].magnitude()),
        (r.apply(v), theirs.apply(V)),
    ):
        assert type(found) is torch.Tensor
        np.testing.assert_array_equal(found.numpy(), wanted)


def test_single_precision_is_rounded_once() -> None:
    v = torch.as_tensor(V).to(torch.float32)
    found, wanted = Rotation.from_rotvec(v), Rotation.from_rotvec(v.numpy())
    assert found.as_quat().dtype is torch.float32
    np.testing.assert_array_equal(found.as_quat().numpy(), wanted.as_quat().astype(np.float32))


@pytest.mark.filterwarnings("ignore::FutureWarning")  # torch's own
def test_who_may_see_the_difference_gets_torchs_steps() -> None:
    v = torch.as_tensor(V)
    assert tensors.readable((v, v))
    learning = v.clone().requires_grad_()
    seen: list[bool] = []

    def look(x: Any) -> Any:
        seen.append(tensors.readable((x,)))
        return Rotation.from_rotvec(x).as_quat()

    torch.func.vmap(look)(v)
    torch.func.jvp(look, (v,), (v,))
    with torch.autograd.forward_ad.dual_level():
        look(torch.autograd.forward_ad.make_dual(v, v))
    look(learning)
    assert seen == [False] * 4
    assert not tensors.readable((v, v.to(torch.float32)))
    assert not tensors.readable((v.to(torch.int64),))
    assert not tensors.readable((V,))
    with torch.no_grad():
        assert tensors.readable((learning,))
    to_rotvec(look(learning)).sum().backward()
    assert torch.allclose(learning.grad, torch.ones_like(learning), atol=1e-9)
