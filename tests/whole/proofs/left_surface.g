#: at least 3 e L: how far beyond a crossing of the triangle that it leaves a ray starts
# Along the triangle's unit normal. An error of at most k along each axis is at most sqrt(3) k along any unit vector,
# one of 6, 6 and 17 at most the root of their squares. The corners lie within 2 L of the origin; the part beyond that
# is in e^2.

@rnd = float<24, ne>;
rounding_unit = {shaders/light/leave_surface.glsl rounding_unit};
largest = 1;
leaving_distance rnd= {shaders/light/leave_surface.glsl leaving_distance return};
start = leaving_distance - sqrt(3) * {left_point};
crossing = 2.0001 * sqrt(2 * {sheared_corner} * {sheared_corner} + {distance} * {distance});

{ start - crossing in ? }
