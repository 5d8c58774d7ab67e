#version 410 core
// Draws every pixel: with a mask, a query then counts the live ones.

void main() {}
