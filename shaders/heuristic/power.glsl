// As balance.glsl, with the squares of the densities: the better way counts nearly alone. Source:
// Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997, section 9.2.

real share_of_light(real light_density, real bounce_density_there) {
    real ratio = bounce_density_there / light_density;
    return real(1.0f) / (real(1.0f) + ratio * ratio);
}

real share_of_bounce(real bounce_density_there, real light_density) {
    real ratio = light_density / bounce_density_there;
    return real(1.0f) / (real(1.0f) + ratio * ratio);
}
