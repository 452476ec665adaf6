import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from anim.picture import outlines as outlines_module
from anim.picture.outlines import HIDDEN, Rim, outlines, runs

keys = st.integers(3, 24).flatmap(lambda n: arrays(np.int64, n, elements=st.integers(-1, 1)))


def area(loop) -> float:
    x, y = loop.T
    return float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2)


def rims(n):
    """Return two concentric polygons, the outer one the low rim."""
    angle = np.arange(n) * 2 * np.pi / n
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    return 100 * circle, 30 * circle


@given(keys)
def test_runs_cover_what_is_visible_once(keys):
    covered = np.full(len(keys), HIDDEN)
    for run in runs(keys):
        faces = np.arange(run.start, run.stop) % len(keys)
        assert len(faces) == len(set(faces.tolist()))
        assert (covered[faces] == HIDDEN).all()
        covered[faces] = run.key
    np.testing.assert_array_equal(covered, keys)


@given(keys)
def test_neighbouring_runs_differ(keys):
    found = runs(keys)
    for run, following in zip(found, found[1:] + found[:1], strict=True):
        if len(found) > 1 and (run.stop - following.start) % len(keys) == 0:
            assert run.key != following.key


@given(keys)
def test_outlines_without_overlap_have_the_area_of_the_faces(keys):
    low, high = rims(len(keys))
    before = outlines_module.OVERLAP
    outlines_module.OVERLAP = 0.0
    try:
        found = list(outlines(Rim(low), Rim(high), keys))
    finally:
        outlines_module.OVERLAP = before
    one_face = (area(low) - area(high)) / len(keys)
    for key in (0, 1):
        total = sum(area(loop) for k, loops in found for loop in loops if k == key)
        np.testing.assert_allclose(total, one_face * (keys == key).sum(), atol=1e-6)


@given(keys)
def test_overlap_stays_under_neighbours_drawn_later(keys):
    low, high = rims(len(keys))
    found = list(outlines(Rim(low), Rim(high), keys))
    if not found:
        return
    parts = runs(keys)
    for order, (_, loops) in enumerate(found):
        if len(loops) > 1:
            continue
        # The middle of every edge of the outline lies in a face of the run or of one drawn later.
        allowed = {face % len(keys) for run in parts[order:] for face in range(run.start, run.stop)}
        centre = 0.999 * loops[0] + 0.001 * loops[0].mean(axis=0)
        angle = np.arctan2(centre[:, 1], centre[:, 0]) / (2 * np.pi) % 1
        if len(allowed) < len(keys) and parts[order].stop - parts[order].start < len(keys) // 3:
            faces = {int(turn * len(keys)) % len(keys) for turn in angle}
            assert faces <= allowed


def test_a_strip_is_as_wide_near_the_point_as_at_the_rim():
    # A fan of eight faces in two colours: the first outline reaches OVERLAP beyond the common edge.
    n = 8
    angle = np.arange(n) * 2 * np.pi / n
    rim = 100 * np.column_stack([np.cos(angle), np.sin(angle)])
    keys = np.array([0, 0, 1, 1, -1, -1, -1, -1])
    (_, (first,)), _ = outlines(Rim(np.zeros((n, 2))), Rim(rim), keys)
    # The common edge is the y axis; the neighbour lies at x < 0.
    reach = -first[:, 0].min()
    assert 0.9 * outlines_module.OVERLAP < reach <= outlines_module.OVERLAP + 1e-9
    near = first[first[:, 0] < -0.6 * outlines_module.OVERLAP]
    assert near[:, 1].min() < 5
