// What glows: triangles whose material has an emission, on the side from which their corners run
// counter-clockwise. They are chosen by their power: area times the brightest of the three colours.
uniform int emitter_count;
uniform samplerBuffer emitter_bounds;     // x: the shares of all up to this one, that is at most 1
uniform isamplerBuffer emitter_triangles; // of the scene
uniform float emitted_power;              // of all together

struct LampPoint {
    real3 point;
    real3 normal; // of length 1, on the side that glows
    real3 emission;
};

real3 front_normal(int triangle) {
    real3 a = triangle_corner(triangle, 0);
    return unit(cross_product(triangle_corner(triangle, 1) - a, triangle_corner(triangle, 2) - a));
}

// A point's density per unit of area, whichever triangle it is on. No emission, no density.
real density_of_emission(real3 emission) {
    return max(emission.x, max(emission.y, emission.z)) / real(emitted_power);
}

// The first whose bound is over the number.
int emitter_at(real number) {
    int first = 0;
    int count = emitter_count - 1;
    while (count > 0) {
        int half_count = (count + 1) / 2;
        bool beyond = real(texelFetch(emitter_bounds, first + half_count - 1).x) <= number;
        first = beyond ? first + half_count : first;
        count = beyond ? count - half_count : half_count - 1;
    }
    return first;
}

// Both numbers place the point, and what the first has left over chooses the triangle.
// Source of the place: Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
LampPoint point_of_emitters(SquarePoint place) {
    int emitter = emitter_at(place.x);
    int triangle = texelFetch(emitter_triangles, emitter).x;
    real lower = emitter == 0 ? real(0.0f) : real(texelFetch(emitter_bounds, emitter - 1).x);
    real upper = real(texelFetch(emitter_bounds, emitter).x);
    real root = sqrt((place.x - lower) / (upper - lower));
    real3 a = triangle_corner(triangle, 0);
    real3 b = triangle_corner(triangle, 1);
    real3 c = triangle_corner(triangle, 2);
    LampPoint lamp;
    lamp.point = a + root * (real(1.0f) - place.y) * (b - a) + root * place.y * (c - a);
    lamp.normal = front_normal(triangle);
    lamp.emission = triangle_material(triangle).emission;
    return lamp;
}

// How much what glows counts where a path of that density meets it. A ray to the lamp was as likely
// as `light_density`, and counts the rest. After the camera, a mirror or glass, which left no
// choice (density 0), there was no such ray.
real share_of_glow(real density, real light_density) {
    //# exercise 11.5: light is counted once
    return density > real(0.0f) ? share_of_bounce(density, light_density) : real(1.0f);
    //# stub: return real(0.0f);
    //# end
}
