// What is asked of a walk that is written as a whole.
uniform int asked;             // one of those below
uniform ivec3 compared_places; // which numbers of the place the contract fixes: 1, else 0

const int asked_start = 0;
const int asked_step = 1;
const int asked_nearest = 2;
const int asked_any = 3;
const int asked_observed = 4;
const int asked_launches = 5;

const int most_launches = 4096; // a walk that never ends has made more

// The place counts as long as there is something left to do.
uvec4 state_of(Walk walk) {
    ivec3 place = walk.ended ? ivec3(0) : walk.place * compared_places;
    return uvec4(uint(place.x), uint(place.y + place.z), walk.ended ? 1u : 0u,
                 uint(walk.nearest.triangle));
}

// The whole walk, each launch with so many rounds.
uvec4 in_launches(Ray ray, int rounds) {
    Walk walk = start_walk(ray);
    int launches = 0;
    while (!walk.ended && launches < most_launches) {
        walk = go_on(walk, ray, -real(farthest), rounds);
        launches = launches + 1;
    }
    return uvec4(uint(walk.nearest.triangle), uint(launches), observations().xy);
}

uvec4 checkpoint(Ray ray, int step) {
    if (asked == asked_start) {
        return state_of(start_walk(ray));
    }
    if (asked == asked_step) {
        return state_of(walk_after(ray, step));
    }
    if (asked == asked_nearest) {
        return bits_of_hit(closest_hit(ray));
    }
    if (asked == asked_any) {
        Hit hit = find_hit(ray, real(3.0f));
        return uvec4(uint(hit.triangle), observations().xyw);
    }
    if (asked == asked_observed) {
        closest_hit(ray);
        return observations();
    }
    return in_launches(ray, step);
}
