"""Read torch tensors as numpy arrays, if gradients and devices allow it.

For tensors in CPU memory a compiled formula takes a tenth of the time of the same formula in torch
operations. It can be used for tensors that need no gradient and that torch is not tracing or mapping.
"""

import sys
from collections.abc import Sequence
from typing import Protocol, TypeGuard, cast

import numpy as np

from rotation.array_types import Array


class Tensor(Protocol):
    """The part of torch's tensor interface that is used here."""

    dtype: object
    device: "Device"
    requires_grad: bool

    def detach(self) -> "Tensor":
        """Return the same numbers without derivatives."""

    def is_conj(self) -> bool:
        """Return whether the tensor is a lazy conjugate, with entries conjugate to the stored numbers."""

    def numpy(self) -> Array:
        """Return an array on the same memory."""


class Device(Protocol):
    """The device on which the numbers of a tensor are stored."""

    type: str


def readable(arrays: Sequence[Tensor] | Sequence[Array]) -> TypeGuard[tuple[Tensor, ...]]:
    """Return whether all are plain tensors of one float type in memory that numpy can read."""
    torch = sys.modules.get("torch")
    if torch is None or any(type(a) is not torch.Tensor for a in arrays):
        return False
    tensors = cast(Sequence[Tensor], arrays)
    kind = tensors[0].dtype
    if kind not in (torch.float32, torch.float64) or torch.compiler.is_compiling():
        return False
    inside = torch._C  # mapping, tracing and forward differentiation leave no public sign
    forward = torch.autograd.forward_ad._current_level >= 0
    if torch.jit.is_tracing() or inside._len_torch_dispatch_stack() or forward:
        return False
    learning = torch.is_grad_enabled()
    return not any(
        a.dtype is not kind
        or a.device.type != "cpu"
        or (learning and a.requires_grad)
        or inside._functorch.is_functorch_wrapped_tensor(a)
        or a.is_conj()
        for a in tensors
    )


def like(tensor: Tensor, values: Array) -> Array:
    """Return numpy numbers as a tensor of the same type as another."""
    torch = sys.modules["torch"]
    converted: Array = torch.from_numpy(np.asarray(values)).to(tensor.dtype)
    return converted
