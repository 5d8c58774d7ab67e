// The points origin + t * direction with t_min <= t <= t_max.
// The direction need not have length 1; t counts lengths of the direction.
struct Ray {
    real3 origin;
    real3 direction;
    real t_min;
    real t_max;
};
