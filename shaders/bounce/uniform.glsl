// All directions of the half ball about the z axis are equally likely.

real3 bounce_direction(SquarePoint place) {
    real height = place.x;
    real aside = sqrt(real(1.0f) - height * height);
    real angle = real(2.0f * pi) * place.y;
    return real3(aside * cos(angle), aside * sin(angle), height);
}

// Per unit of solid angle.
real bounce_density(real cosine) {
    return real(0.5f) / real(pi);
}

// The cosine over pi, by that density.
real bounce_weight(real cosine) {
    return real(2.0f) * cosine;
}
