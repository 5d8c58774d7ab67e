// Pairs of independent random numbers.

SquarePoint random_point(int pixel, int sample_number, int pair) {
    uint first = hashed(hashed(uint(sample_number)) ^ seed_of_pair(pixel, pair));
    SquarePoint point;
    point.x = unit_number(first);
    point.y = unit_number(hashed(first));
    return point;
}
