// What a ray is inside of after it has left a body. Whole numbers are made of the ray's: the list
// of the origin and the direction's x, up to its first 0, and the body of its y.
#include "light/media.glsl"

uint whole(real number) {
    return uint(floor(abs(number)));
}

uvec4 checkpoint(Ray ray, int step) {
    uvec4 media = uvec4(whole(ray.origin.x), whole(ray.origin.y), whole(ray.origin.z),
                        whole(ray.direction.x));
    for (int i = 1; i < 4; ++i) {
        media[i] = media[i - 1] == 0u ? 0u : media[i];
    }
    return leave_medium(media, int(whole(ray.direction.y)));
}
