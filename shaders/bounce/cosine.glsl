// Directions by the cosine: where much light would count, many are tried. About the z axis.
// Source: Malley's method; Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th ed., 2023,
// appendix A.5.3.

// The point of a disc, lifted onto the half ball over it.
real3 bounce_direction(SquarePoint place) {
    //# exercise 11.1: a direction by the cosine
    SquarePoint on_disc = point_of_disc(place);
    return real3(on_disc.x, on_disc.y, sqrt(real(1.0f) - place.x));
    //# stub: return real3(real(0.0f), real(0.0f), real(1.0f));
    //# end
}

// Per unit of solid angle.
real bounce_density(real cosine) {
    return cosine / real(pi);
}

// The cosine over pi, by that density: no rounding at all.
real bounce_weight(real cosine) {
    return real(1.0f);
}
