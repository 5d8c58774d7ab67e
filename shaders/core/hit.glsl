// Where a ray meets a triangle (a, b, c): at origin + t * direction, which is
// (1 - u - v) * a + u * b + v * c. Of a miss, t is the ray's t_max and the triangle no_triangle.
struct Hit {
    real t;
    real u;
    real v;
    int triangle;
};

const int no_triangle = -1;
