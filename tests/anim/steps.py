"""The integrators' loops with arrays made for what they write, plain or compiled."""

import numpy as np

from anim.physics.free_top_equations import SIZE, workspace


def kept(run, start, h, steps, every, *rest):
    """Return the states that `run` or `follow` keeps, and when the rim touches, or −1."""
    states = np.empty((steps // every + 1, len(start)))
    more = (workspace(),) if len(start) == SIZE else ()
    return states, run(states, start, h, steps, every, *rest, *more)


def visited(visit, states, spacing, times, *rest):
    """Return the states at ``times`` that `visit` or `meet` finds."""
    found = np.empty((len(times), states.shape[1]))
    more = (workspace(),) if states.shape[1] == SIZE else ()
    visit(found, states, spacing, times, *rest, *more)
    return found
