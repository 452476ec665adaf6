"""Error messages for functions of quaternions at arguments without a value."""

NO_POLAR_FORM = "there is no polar form where the part of trace 0 has no negative square"


def no_value(shown: str, noun: str, at: str = "") -> str:
    """Return the message that a quaternion has no logarithm, or no power with this exponent."""
    return (
        f"the quaternion ({shown}){at} has no {noun}: it is 0 or too large, has a negative real "
        "eigenvalue, or is a negative scalar, for which every n with n² = −1 gives another value"
    )
