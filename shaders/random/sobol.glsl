// Pairs that fill the square evenly: of any 2^n samples in a row that begin at a multiple of 2^n,
// each of the 2^n boxes of one shape has one. Each pair of each pixel has an order and a scrambling
// of its own. Source: Sobol, "On the distribution of points in a cube and the approximate
// evaluation of integrals", 1967; Owen, "Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences", 1995;
// by hashes, Burley, "Practical Hash-based Owen Scrambling", 2020.

uint reversed_bits(uint bits) {
    uint pairs = ((bits >> 1u) & 0x55555555u) | ((bits & 0x55555555u) << 1u);
    uint fours = ((pairs >> 2u) & 0x33333333u) | ((pairs & 0x33333333u) << 2u);
    uint bytes = ((fours >> 4u) & 0x0F0F0F0Fu) | ((fours & 0x0F0F0F0Fu) << 4u);
    uint words = ((bytes >> 8u) & 0x00FF00FFu) | ((bytes & 0x00FF00FFu) << 8u);
    return (words >> 16u) | (words << 16u);
}

// Turns over each bit or not, by the bits above it. Source: Laine and Karras, "Stratified Sampling
// for Stochastic Transparency", 2011; the factors are Vegdahl's, as Burley has them.
uint scrambled(uint bits, uint chance) {
    uint x = reversed_bits(bits);
    x ^= x * 0x3D20ADEAu;
    x += chance;
    x *= (chance >> 16u) | 1u;
    x ^= x * 0x05526C56u;
    x ^= x * 0x53A22864u;
    return reversed_bits(x);
}

// The second number of Sobol's sequence; the first one has the bits of the index reversed.
uint second_of_sobol(uint index) {
    uint sum = 0u;
    uint direction = 0x80000000u;
    for (uint rest = index; rest != 0u; rest >>= 1u) {
        sum ^= (rest & 1u) != 0u ? direction : 0u;
        direction ^= direction >> 1u;
    }
    return sum;
}

SquarePoint random_point(int pixel, int sample_number, int pair) {
    uint chance = seed_of_pair(pixel, pair);
    uint index = scrambled(uint(sample_number), chance);
    SquarePoint point;
    point.x = unit_number(scrambled(reversed_bits(index), hashed(chance ^ 0x1u)));
    point.y = unit_number(scrambled(second_of_sobol(index), hashed(chance ^ 0x2u)));
    return point;
}
