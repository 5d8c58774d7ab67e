#version 410 core
// Draws the pixels whose path counts so little that it is not worth a ray.

uniform sampler2D weights;
uniform float faintest; // the threshold

void main() {
    vec3 weight = vec3(texelFetch(weights, ivec2(gl_FragCoord.xy), 0));
    if (max(weight.x, max(weight.y, weight.z)) > faintest) {
        discard;
    }
}
