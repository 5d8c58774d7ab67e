// The t_max of a ray without an end: the largest single-precision number, so that no kernel depends
// on a platform's infinity.
const float farthest = 3.402823466e+38f;

// The points origin + t * direction with t_min <= t <= t_max.
// The direction need not have length 1; t counts lengths of the direction.
struct Ray {
    real3 origin;
    real3 direction;
    real t_min;
    real t_max;
};

// What is asked of every ray.

// A ray without a point, or without a direction: it hits nothing, and no walk has to be made for
// it. The second kind is what a fetch beyond the edge of a texture gives. Where a GPU works in
// blocks of pixels, those of a block that lie beyond the picture run too, and the others wait.
bool is_empty(Ray ray) {
    return ray.t_max < ray.t_min || ray.direction == real3(real(0.0f));
}
