"""The two tables of times printed in 3.2.1, in seconds, and terms computed from them."""

Times = tuple[int, ...]

QUATERNIONS_1: Times = (402, 414, 428, 437, 438, 445, 450, 432, 442, 461)
MATRICES_1: Times = (415, 430, 427, 427, 383, 354, 360, 355, 346, 354)
QUATERNIONS_2: Times = (457, 458, 440, 439, 439, 439, 437, 437, 450, 449)
MATRICES_2: Times = (1767, 1769, 1768, 1768, 1768, 1759, 1757, 1757, 1759, 1765)
ALL = (QUATERNIONS_1, MATRICES_1, QUATERNIONS_2, MATRICES_2)


def mean(times: Times) -> str:
    """Return the mean as a term over ℚ, such as ``(1 + 2)/2``."""
    return f"({' + '.join(map(str, times))})/{len(times)}"


def ratio(slow: Times, fast: Times) -> str:
    """Return the ratio of two mean times."""
    return f"({mean(slow)})/({mean(fast)})"


def saving(slow: Times, fast: Times) -> str:
    """Return by how many per cent the fast time is shorter than the slow one."""
    return f"100*({mean(slow)} - {mean(fast)})/({mean(slow)})"
