// No surface has holes: nothing is asked of a hit.

bool is_solid(Hit hit) {
    return true;
}
