// Numbers that look like chance and are computed from where they are needed: nothing is kept from
// one to the next, and they are the same on every machine.
uniform int seed; // another one gives another picture of the same scene

// A mixture of the bits that maps no two numbers to one. Source: O'Neill, "PCG: A Family of Simple
// Fast Space-Efficient Statistically Good Algorithms for Random Number Generation", 2014; as a
// hash, Jarzynski and Olano, "Hash Functions for GPU Rendering", 2020.
uint hashed(uint bits) {
    uint state = bits * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// What tells apart the pairs of numbers of all pixels: a path draws one pair after the other, and
// pair 0 is the place in the pixel.
uint seed_of_pair(int pixel, int pair) {
    //# exercise 11.6: a seed for each pair of numbers
    return hashed(uint(pixel) + hashed(uint(pair) + hashed(uint(seed))));
    //# stub: return 0u;
    //# end
}

// The upper 24 bits as a number from 0 on and under 1: every one is exact.
real unit_number(uint bits) {
    return real(bits >> 8u) * real(5.9604644775390625e-8f);
}
