// Each way of finding a lamp counts by its share of both densities. Source: Veach and Guibas,
// "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995.

real share_of_light(real light_density, real bounce_density_there) {
    //# exercise 11.3: the weight of one of two ways
    return light_density / (light_density + bounce_density_there);
    //# stub: return real(0.0f);
    //# end
}

// The rest, so that both sum to 1.
real share_of_bounce(real bounce_density_there, real light_density) {
    return bounce_density_there / (light_density + bounce_density_there);
}
