// From the third bounce on, a path goes on as likely as it still counts. Source: Arvo and Kirk,
// "Particle Transport and Image Synthesis", 1990.
const int bounces_for_all = 3;

real chance_to_go_on(real3 weight, int bounce) {
    real counts = max(weight.x, max(weight.y, weight.z));
    return bounce < bounces_for_all ? real(1.0f) : min(counts, real(1.0f));
}
