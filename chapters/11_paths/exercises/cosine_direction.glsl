// A direction by the cosine, for the place in the unit square that the origin's x and y make,
// without sign and whole part.
#include "light/samples.glsl"

#include "light/path.glsl"

#include "bounce/cosine.glsl"

uvec4 checkpoint(Ray ray, int step) {
    SquarePoint place;
    place.x = fraction_of(abs(ray.origin.x));
    place.y = fraction_of(abs(ray.origin.y));
    return bits_of_point(bounce_direction(place), 0);
}
