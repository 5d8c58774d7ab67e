// What is left of light after a way through a medium that absorbs.
// Source: Bouguer, "Essai d'optique", 1729; Beer, "Bestimmung der Absorption des rothen Lichts in
// farbigen Fluessigkeiten", 1852: each unit of length keeps the same part of what came to it.

// A clear medium keeps all, to the bit: pow(1, x) is not exactly 1 everywhere.
real kept_of(real transmission, real distance) {
    //# exercise 9.4: what a way through glass leaves
    return transmission == real(1.0f) ? real(1.0f) : pow(transmission, distance);
    //# stub: return real(1.0f);
    //# end
}

real3 transmitted(real3 transmission, real distance) {
    return real3(kept_of(transmission.x, distance), kept_of(transmission.y, distance),
                 kept_of(transmission.z, distance));
}

real travelled(Ray ray, Hit hit) {
    precise real distance = hit.t * sqrt(dot_product(ray.direction, ray.direction));
    return distance;
}
