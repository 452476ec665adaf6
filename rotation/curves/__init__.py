"""Rotations and rigid motions in time: interpolation, curves through keyframes, angular velocities."""
