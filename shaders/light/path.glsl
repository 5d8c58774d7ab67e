// What paths of light share: where they are in the picture, how they leave a matte surface, and how
// a lamp's points are counted.
const float pi = 3.14159265358979f;

// Several samples of a picture lie side by side, each in a picture of its own.
uniform int picture_width;
uniform int picture_height;
uniform int pictures_across;
uniform int first_sample;

struct PathSample {
    int column;
    int row; // from the bottom
    int pixel;
    int sample_number;
};

PathSample sample_at(int x, int y) {
    PathSample at;
    at.column = x % picture_width;
    at.row = y % picture_height;
    at.pixel = at.row * picture_width + at.column;
    at.sample_number = first_sample + x / picture_width + pictures_across * (y / picture_height);
    return at;
}

// The pairs of random numbers that a bounce draws: pair 0 is the camera's.
const int pairs_of_bounce = 3;
const int pair_of_lamp = 1;
const int pair_of_direction = 2;
const int pair_of_choices = 3;

// What a path is when it has left a surface. The density is that of its direction, per unit of
// solid angle; 0 where a mirror or glass left it no choice.
struct PathStep {
    Ray ray;
    real3 weight;
    real density;
};

// How likely a path leaves a surface as from a matte one; else it is mirrored or goes through. The
// fourth number of a material's first texel.
real matte_share(int triangle) {
    return real(texelFetch(materials, 3 * texelFetch(triangle_materials, triangle).x).w);
}

// The direction with these coordinates about the normal, which both have length 1. Source: Duff and
// others, "Building an Orthonormal Basis, Revisited", 2017.
real3 about_normal(real3 normal, real3 local) {
    real side = normal.z >= real(0.0f) ? real(1.0f) : -real(1.0f);
    real a = -real(1.0f) / (side + normal.z);
    real b = normal.x * normal.y * a;
    real3 across = real3(real(1.0f) + side * normal.x * normal.x * a, side * b, -side * normal.x);
    real3 along = real3(b, side + normal.y * normal.y * a, -normal.y);
    return local.x * across + local.y * along + local.z * normal;
}

// Points of a lamp, counted per unit of its area, as directions that they are seen in, per unit of
// solid angle: far away, and seen from the side, an area fills a small angle. The way leads to the
// lamp.
real density_over_angles(real density_over_area, real3 way, real3 lamp_normal) {
    //# exercise 11.2: from areas to angles
    real squared_distance = dot_product(way, way);
    real cosine = abs(dot_product(lamp_normal, way)) / sqrt(squared_distance);
    return density_over_area * squared_distance / cosine;
    //# stub: return density_over_area;
    //# end
}

// Roulette: some paths end, and the others count for them too.
PathStep after_roulette(PathStep before, real chance, real number) {
    PathStep next = before;
    //# exercise 11.4: roulette
    if (number >= chance) {
        next.ray.t_max = -real(1.0f);
    }
    next.weight = before.weight / chance;
    //# stub: next.weight = before.weight;
    //# end
    return next;
}
