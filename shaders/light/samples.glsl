// Points that are spread evenly over the unit square, one for each sample of a pixel. No random
// numbers: the same sample has the same point on every machine.

struct SquarePoint {
    real x;
    real y;
};

real fraction_of(real x) {
    return x - floor(x);
}

// The place of a sample within its pixel. Sample 0 is the middle, so one sample a pixel is the ray
// of chapter 01. The steps are 1/g and 1/g^2 with g^3 = g + 1.
// Source: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018.
SquarePoint point_in_pixel(int sample_number) {
    SquarePoint point;
    precise real x = real(0.5f) + real(sample_number) * real(0.75487766f);
    precise real y = real(0.5f) + real(sample_number) * real(0.56984029f);
    point.x = fraction_of(x);
    point.y = fraction_of(y);
    return point;
}

// The digits of the number in that base, mirrored at the point: 6 is 110 in base 2, so it becomes
// 0.011. Source: Halton, "On the efficiency of certain quasi-random sequences of points in
// evaluating multi-dimensional integrals", 1960.
real mirrored_digits(int number, int base) {
    real place = real(1.0f) / real(base);
    real sum = real(0.0f);
    int rest = number;
    while (rest > 0) {
        precise real next = sum + real(rest % base) * place;
        sum = next;
        place = place / real(base);
        rest = rest / base;
    }
    return sum;
}

// The same points in every pixel would show as bands; so each pixel shifts them, around the edges
// of the square. Source: Cranley and Patterson, "Randomization of number theoretic methods for
// multiple integration", 1976; the shift here is Roberts' sequence in the plane of the picture.
SquarePoint shifted(SquarePoint point, int column, int row) {
    SquarePoint moved;
    precise real x = point.x + real(column) * real(0.75487766f) + real(row) * real(0.56984029f);
    precise real y = point.y + real(column) * real(0.81917251f) + real(row) * real(0.67104360f);
    moved.x = fraction_of(x);
    moved.y = fraction_of(y);
    return moved;
}

SquarePoint point_on_lamp(int sample_number, int column, int row) {
    SquarePoint point;
    point.x = mirrored_digits(sample_number, 2);
    point.y = mirrored_digits(sample_number, 3);
    return shifted(point, column, row);
}

SquarePoint point_for_lens(int sample_number, int column, int row) {
    SquarePoint point;
    point.x = mirrored_digits(sample_number, 5);
    point.y = mirrored_digits(sample_number, 7);
    return shifted(point, column, row);
}

// The point of the square as one of the disc of radius 1; equal areas stay equal.
SquarePoint point_of_disc(SquarePoint square) {
    real radius = sqrt(square.x);
    real angle = real(6.2831853f) * square.y;
    SquarePoint point;
    point.x = radius * cos(angle);
    point.y = radius * sin(angle);
    return point;
}
