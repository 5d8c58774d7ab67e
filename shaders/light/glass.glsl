// Where a ray meets glass it splits in two: a reflected and a refracted ray.

struct GlassMeeting {
    Ray reflected;
    Ray refracted;
    real reflected_part; // of the light; the rest is refracted
    uvec4 media_before;  // what the reflected ray is inside of
    uvec4 media_behind;  // what the refracted ray is inside of
};

// Whether the ray meets the side from which the corners run counter-clockwise: the outside.
bool meets_outside(Ray ray, Hit hit) {
    real3 a = triangle_corner(hit.triangle, 0);
    real3 b = triangle_corner(hit.triangle, 1);
    real3 c = triangle_corner(hit.triangle, 2);
    return dot_product(cross_product(b - a, c - a), ray.direction) <= real(0.0f);
}

// The origin of rays that leave on the other side. The surface's origin lies at most 33 e M from
// where it should (light/leave_surface.glsl); this adds one rounding of a number up to 2 M, and
// 64 e M keeps clear of both.
real3 origin_behind(Surface surface, Hit hit) {
    real distance =
        leaving_distance(triangle_corner(hit.triangle, 0), triangle_corner(hit.triangle, 1),
                         triangle_corner(hit.triangle, 2));
    precise real3 origin = surface.origin - real(2.0f) * distance * surface.geometric_normal;
    return origin;
}

// The index where nothing else is: that of air, and of empty space, is 1.
real index_inside(uvec4 media) {
    int material = innermost_medium(media);
    return material < 0 ? real(1.0f) : glass_of(material).index;
}

// Leaving a body that the ray never entered means that it was in it from the start.
uvec4 media_before(uvec4 media, int material, bool outside) {
    return outside || is_inside(media, material) ? media : enter_medium(media, material);
}

GlassMeeting meet_glass(Ray ray, Hit hit, Surface surface, uvec4 media) {
    int material = material_number(hit.triangle);
    bool outside = meets_outside(ray, hit);
    uvec4 before = media_before(media, material, outside);
    uvec4 behind = outside ? enter_medium(before, material) : leave_medium(before, material);
    real index_before = index_inside(before);
    real index_behind = index_inside(behind);

    real3 direction = unit(ray.direction);
    // An interpolated normal can face away from the ray, or bend it back: then the plane's decides.
    bool turned = dot_product(direction, surface.normal) >= real(0.0f);
    real3 normal = turned ? surface.geometric_normal : surface.normal;
    real cosine = clamp(-dot_product(direction, normal), real(0.0f), real(1.0f));

    GlassMeeting meeting;
    meeting.reflected = mirror_ray(surface, ray);
    meeting.reflected_part = reflected_part(cosine, index_before, index_behind);
    meeting.media_before = before;
    meeting.media_behind = behind;
    real3 refracted = refracted_direction(direction, normal, index_before, index_behind);
    if (dot_product(refracted, surface.geometric_normal) >= real(0.0f)) {
        refracted =
            direction; // bent back by an interpolated normal: straight on is nearer the truth
    }
    meeting.refracted.origin = origin_behind(surface, hit);
    meeting.refracted.direction = refracted;
    meeting.refracted.t_min = real(0.0f);
    meeting.refracted.t_max = real(farthest);
    return meeting;
}
