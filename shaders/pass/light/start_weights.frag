#version 410 core
// Before the first bounce, the colour that a path finds counts in full.

out vec4 weight;

void main() {
    weight = vec4(1.0);
}
