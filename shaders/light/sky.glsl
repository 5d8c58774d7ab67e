// What a ray sees that leaves the scene.
uniform vec3 sky_zenith;
uniform vec3 sky_horizon;
uniform vec3 sky_ground;

// The sky by the height of a direction: its sine over the horizon. The ground is reached four times
// as fast as the zenith: haze is thin below.

real3 sky_color(real3 direction) {
    real height = unit(direction).y;
    real3 end = height > real(0.0f) ? real3(sky_zenith) : real3(sky_ground);
    real part = height > real(0.0f) ? height : min(real(1.0f), real(-4.0f) * height);
    precise real3 color = (real(1.0f) - part) * real3(sky_horizon) + part * end;
    return color;
}
