// Lamps are found by chance, where a path meets one.

real share_of_light(real light_density, real bounce_density_there) {
    return real(0.0f);
}

real share_of_bounce(real bounce_density_there, real light_density) {
    return real(1.0f);
}
