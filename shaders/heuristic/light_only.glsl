// Lamps are found by rays sent to them, and by no others but those of mirrors and glass.

real share_of_light(real light_density, real bounce_density_there) {
    return real(1.0f);
}

real share_of_bounce(real bounce_density_there, real light_density) {
    return real(0.0f);
}
