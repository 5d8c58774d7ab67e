#version 410 core
// One triangle that covers the whole picture, made of nothing but the number of its vertex.

void main() {
    float x = gl_VertexID == 1 ? 3.0 : -1.0;
    float y = gl_VertexID == 2 ? 3.0 : -1.0;
    gl_Position = vec4(x, y, 0.0, 1.0);
}
