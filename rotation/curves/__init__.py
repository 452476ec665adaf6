"""Rotations and rigid motions in time: between two, through keyframes, from angular velocities."""
