// Every path goes on.

real chance_to_go_on(real3 weight, int bounce) {
    return real(1.0f);
}
