#version 410 core
// Adds the light that a ray of a list has found to the pixel that it belongs to.

flat in vec3 light;

out vec4 color; // added to the picture

void main() {
    color = vec4(light, 0.0);
}
