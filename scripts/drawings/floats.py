"""Numbers as the GPU has them: each operation is rounded once to a float of 24 bits."""

import math
import struct


def rounded(x):
    """The nearest float."""
    return struct.unpack("f", struct.pack("f", x))[0]


def ulp(x):
    """From a normal float to the next one: 2^(k - 23) between 2^k and 2^(k + 1)."""
    return 2.0 ** (math.floor(math.log2(abs(x))) - 23)


def difference(a, b):
    return tuple(rounded(p - q) for p, q in zip(a, b))


def product(a, b):
    return rounded(a * b)


def cross_product(a, b):
    """As shaders/core/vector.glsl writes it out."""

    def part(i, j):
        return rounded(product(a[i], b[j]) - product(a[j], b[i]))

    return (part(1, 2), part(2, 0), part(0, 1))


def dot_product(a, b):
    return rounded(rounded(product(a[0], b[0]) + product(a[1], b[1])) + product(a[2], b[2]))
