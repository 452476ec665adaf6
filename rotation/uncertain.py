"""Rotations and rigid motions with covariance: products, inverses, fusion, interpolation, samples.

The true motion is ``exp(ξ)·mean``, where ξ is normally distributed with mean 0. T. D. Barfoot and P. T.
Furgale, "Associating uncertainty with three-dimensional poses for use in estimation problems", IEEE Trans.
Robotics 30 (2014). All formulas use `ad` and the adjoint, so they hold for both groups.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from operator import add
from typing import Self

import numpy as np

from rotation import hints, pytrees, sampling
from rotation.array_types import Array, ArrayLike, Seed
from rotation.arrays import common_batch
from rotation.errors import DTypeError, RotationError
from rotation.immutable_arrays import on_the_right
from rotation.jacobians import (
    ad,
    inverse_left_jacobian,
    inverse_right_jacobian,
    left_jacobian,
)
from rotation.namespaces import (
    certainly,
    expect_numpy,
    floats,
    namespace,
    number,
    quiet,
    refuse_rows,
)
from rotation.rigid import RigidTransform
from rotation.rotation import Rotation

_STEPS = 50  # of Gauss and Newton; about five suffice unless estimates contradict each other

Motion = Rotation | RigidTransform


@pytrees.register_pytree("_mean", "_covariance")
class Uncertain:
    """Rotations or rigid motions with a covariance.

    Parameters
    ----------
    mean : Rotation or RigidTransform, shape (…)
    covariance : array_like, shape (…, 3, 3) or (…, 6, 6)
        Of tangents: rotation vectors (radians²), or exponential coordinates, the rotation first. The batch
        shapes broadcast.
    side : "left" or "right"
        Whether the tangents are in world axes, ``exp(ξ)·mean``, or in body axes, ``mean·exp(ξ)``.

    Raises
    ------
    RotationError
        A covariance of another shape, not symmetric or with a negative variance; another side.
    DTypeError
        The mean is neither a Rotation nor a RigidTransform.

    Examples
    --------
    >>> from rotation import RigidTransform
    >>> step = Uncertain(RigidTransform.from_translation([1, 0, 0]), np.diag([0, 0, 0.01, 0, 0, 0]))
    >>> path = step * step  # after the first, headings are uncertain by 0.1 rad
    >>> path.mean.translation, path.covariance[4, 4].round(6)
    (array([2., 0., 0.]), np.float64(0.009983))
    """

    __slots__ = ("_covariance", "_mean")
    __array_ufunc__ = None

    def __init__(self, mean: Motion, covariance: ArrayLike, side: str = "left") -> None:
        if not isinstance(mean, Rotation | RigidTransform):
            raise DTypeError(hints.refusal(mean, "mean", "Rotation"))
        n = 3 if isinstance(mean, Rotation) else 6
        xp = namespace(mean._q, covariance)
        p = floats(covariance, "covariance", xp)
        if p.ndim < 2 or tuple(p.shape[-2:]) != (n, n):
            raise RotationError(
                f"covariance has shape {tuple(p.shape)}; expected (…, {n}, {n}) for a {type(mean).__name__}"
            )
        batch = common_batch(mean=mean.shape, covariance=tuple(p.shape[:-2]))
        _expect_covariance(p)
        if on_the_right(side):
            p = _carried(mean.adjoint(), p)
        self._mean, self._covariance = mean, xp.broadcast_to(p, (*batch, n, n))

    @property
    def mean(self) -> Motion:
        """The rotations or rigid motions without the covariance."""
        return self._mean

    @property
    def covariance(self) -> Array:
        """The covariances (…, n, n) of left tangents, in world axes."""
        return self._covariance + 0.0

    @property
    def right_covariance(self) -> Array:
        """The covariances (…, n, n) of right tangents, in body axes."""
        return _carried(self._mean.inverse().adjoint(), self._covariance)

    def __repr__(self) -> str:
        return f"Uncertain({self._mean!r}, {self._covariance!r})"

    def __mul__(self, other: object) -> Self:
        """Return the product of independent motions (``other`` is applied first), to fourth order in
        deviations.
        """
        if not isinstance(other, Uncertain):
            return NotImplemented
        mean = self._mean * other._mean
        p, q = self._covariance, _carried(self._mean.adjoint(), other._covariance)
        xp = namespace(p)
        a, b = _squared(p), _squared(q)
        fourth = _sum_over(ad(p), q) / 4.0
        for square, beside in ((a, q), (b, p)):
            half = xp.matmul(square, beside) / 12.0
            fourth = fourth + half + xp.matrix_transpose(half)
        return type(self)(mean, p + q + fourth)

    def inverse(self) -> Self:
        """Return the inverse motions; exact."""
        back = self._mean.inverse()
        return type(self)(back, _carried(back.adjoint(), self._covariance))

    inv = inverse

    @quiet
    def interpolate(self, other: Self, t: ArrayLike) -> Self:
        """Return the motion at ``t`` (…) on the path to an independent one, to first order in the deviations.

        The mean moves along one screw with constant velocity, as in `sclerp`, or for rotations as in `slerp`.

        Raises
        ------
        RotationError
            Shapes that do not fit.
        DTypeError
            The other is of another kind.
        """
        _expect_uncertain(other)
        way = other._mean.minus(self._mean, "left")
        if isinstance(t, int | float):
            x: Array = number(t, "t")
        else:
            x = floats(t, "t", namespace(way, t))[..., None]
        part = x * way
        mean = self._mean.plus(part, "left")
        xp = namespace(part)
        s = x if isinstance(t, int | float) else x[..., None]
        onto = s * xp.matmul(left_jacobian(part), inverse_left_jacobian(way))
        back = s * xp.matmul(left_jacobian(part), inverse_right_jacobian(way))
        own = self._mean.exp(part).adjoint() - back
        p = _carried(onto, other._covariance) + _carried(own, self._covariance)
        return type(self)(mean, _symmetric(p))

    @classmethod
    @quiet
    def fuse(cls, estimates: Iterable[Self]) -> Self:
        """Return the most likely motion, given independent estimates of it, and its covariance.

        Minimises ``Σ eᵀ·P⁻¹·e`` with ``e = log(mean·T⁻¹)`` by Gauss–Newton steps, starting from the first
        estimate.

        Raises
        ------
        RotationError
            No estimates, shapes that do not fit, a covariance that is singular, or no convergence.
        DTypeError
            One of them is not an Uncertain, or they are of two kinds.
        """
        members = list(estimates)
        if not members:
            raise RotationError("fuse takes at least one Uncertain")
        _expect_uncertain(*members)
        for m in members:
            values = namespace(m._covariance).linalg.eigvalsh(m._covariance)
            tiny = 1e-14 if values.dtype == namespace(values).float64 else 1e-6
            refuse_rows(
                ~(values[..., 0] > tiny * values[..., -1]),
                "the covariance",
                "is singular: what is exact is not fused",
            )
        knowledge = [namespace(m._covariance).linalg.inv(m._covariance) for m in members]
        best = members[0]._mean
        for _ in range(_STEPS):
            pieces = []
            for member, known in zip(members, knowledge, strict=True):
                e = member._mean.minus(best, "left")
                xp = namespace(e)
                g = inverse_right_jacobian(e)
                weighed = xp.matmul(xp.matrix_transpose(g), known)
                pieces.append((xp.matmul(weighed, g), xp.matmul(weighed, e[..., None])))
            information, pull = (reduce(add, terms) for terms in zip(*pieces, strict=True))
            step = xp.linalg.solve(information, pull)
            best = best.plus(step[..., 0], "left")
            small = 64.0 * float(xp.finfo(step.dtype).eps)
            size = 1.0 + xp.max(xp.abs(best.log()), axis=-1)
            if certainly(xp.all(xp.max(xp.abs(step[..., 0]), axis=-1) <= small * size)):
                return cls(best, _symmetric(xp.linalg.inv(information)))
        if isinstance(pull, np.ndarray):
            raise RotationError(
                f"the estimates contradict each other: no best one was found in {_STEPS} steps"
            )
        return cls(best, _symmetric(xp.linalg.inv(information)))

    def sample(
        self,
        shape: int | Sequence[int] | None = None,
        rng: Seed | None = None,
        *,
        seed: Seed | None = None,
    ) -> Motion:
        """Return random motions, with batch shape ``shape`` followed by that of the mean.

        Parameters
        ----------
        shape, rng, seed
            As in `Rotation.random`; numpy's arrays only.
        """
        expect_numpy("sample", self._covariance)
        batch, generator = sampling.as_shape(shape), sampling.generator(rng, seed)
        values, vectors = np.linalg.eigh(self._covariance)
        root = vectors * np.sqrt(np.maximum(values, 0.0))[..., None, :]
        z = generator.standard_normal((*batch, *root.shape[:-1]))
        return self._mean.plus((root @ z[..., None])[..., 0], "left")

    @classmethod
    def from_samples(cls, samples: Motion) -> Self:
        """Return the mean and the covariance of at least two independent samples along the first axis.

        At the mean the left tangents sum to 0; the covariance is divided by n − 1.

        Raises
        ------
        RotationError
            Fewer than two, or samples so far apart that no mean is found.
        DTypeError
            The samples are neither a Rotation nor a RigidTransform.
        """
        if not isinstance(samples, Rotation | RigidTransform):
            raise DTypeError(hints.refusal(samples, "samples", "Rotation"))
        expect_numpy("from_samples", samples._q)
        if samples.single or len(samples) < 2:
            raise RotationError("a covariance takes at least two samples, along the first axis")
        best: Motion = samples.mean(axis=0)
        for _ in range(_STEPS):
            apart = samples.minus(best, "left")
            step = apart.mean(axis=0)
            best = best.plus(step, "left")
            if np.all(np.abs(step) <= 1e-14 * (1.0 + np.abs(apart).max(axis=0))):
                apart = np.moveaxis(samples.minus(best, "left"), 0, -1)
                return cls(best, apart @ np.swapaxes(apart, -1, -2) / (len(samples) - 1))
        raise RotationError(f"no mean was found in {_STEPS} steps: the samples spread too far")


def _expect_uncertain(*members: Uncertain) -> None:
    for n, m in enumerate(members):
        if not isinstance(m, Uncertain):
            raise DTypeError(f"number {n} is {hints.described(m)}; expected an Uncertain")
        if type(m._mean) is not type(members[0]._mean):
            raise DTypeError("rotations and rigid motions are not fused with each other")


@quiet
def _expect_covariance(p: Array) -> None:
    xp = namespace(p)
    allowed = 1e-9 if p.dtype == xp.float64 else 1e-4
    size = xp.max(xp.abs(p), axis=(-2, -1))
    off = xp.max(xp.abs(p - xp.matrix_transpose(p)), axis=(-2, -1))
    refuse_rows(off > allowed * size, "the covariance", "is not symmetric")
    finite = xp.isfinite(size)
    values = xp.linalg.eigvalsh(xp.where(finite[..., None, None], p, xp.zeros_like(p)))
    refuse_rows(
        finite & (values[..., 0] < -allowed * size), "the covariance", "has a negative variance"
    )


def _carried(a: Array, p: Array) -> Array:
    """Return ``A·P·Aᵀ``."""
    xp = namespace(a, p)
    return _symmetric(xp.matmul(xp.matmul(a, p), xp.matrix_transpose(a)))


def _symmetric(p: Array) -> Array:
    return 0.5 * (p + namespace(p).matrix_transpose(p))


def _squared(p: Array) -> Array:
    """Return the mean of ``ad(ξ)²``; ad is linear, so row i of P gives ``Σⱼ Pᵢⱼ·ad(eⱼ)``."""
    xp = namespace(p)
    units = ad(xp.eye(p.shape[-1], dtype=p.dtype))
    return xp.sum(xp.matmul(units, ad(p)), axis=-3)


def _sum_over(rows: Array, q: Array) -> Array:
    """Return the mean of ``ad(ξ)·Q·ad(ξ)ᵀ``."""
    xp = namespace(q)
    units = ad(xp.eye(q.shape[-1], dtype=q.dtype))
    each = xp.matmul(xp.matmul(units, q[..., None, :, :]), xp.matrix_transpose(rows))
    return xp.sum(each, axis=-3)
