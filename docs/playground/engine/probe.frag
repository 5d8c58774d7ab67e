#version 410 core
// How this GPU rounds, for engine/probe.js: what the lessons take for granted, one question a number.
uniform sampler2D numbers; // a, b, c, and a denormal

layout(location = 0) out uvec4 basics; // a * b, a / b, the root of |a|, a * b + c
layout(location = 1) out uvec4 others; // what a * b lost, a denormal, 32 bits in a struct, a NaN is one

struct Bits {
    int low;
    int high;
};

struct Halves {
    float upper;
    float lower;
};

// Dekker, "A floating-point technique for extending the available precision", 1971.
Halves split(float a) {
    precise float far = 4097.0f * a;
    precise float upper = far - (far - a);
    precise float lower = a - upper;
    Halves halves;
    halves.upper = upper;
    halves.lower = lower;
    return halves;
}

Bits count_on(Bits bits) {
    bits.high = bits.high + 1;
    bits.low = bits.low - 1;
    return bits;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 given = texelFetch(numbers, pixel, 0);
    float a = given.x;
    float b = given.y;
    precise float product = a * b;
    precise float sum = product + given.z;
    basics = uvec4(floatBitsToUint(product), floatBitsToUint(a / b), floatBitsToUint(sqrt(abs(a))),
                   floatBitsToUint(sum));
    Halves of_a = split(a);
    Halves of_b = split(b);
    precise float lost = ((of_a.upper * of_b.upper - product) + of_a.upper * of_b.lower +
                          of_a.lower * of_b.upper) + of_a.lower * of_b.lower;
    Bits bits;
    bits.high = floatBitsToInt(a);
    bits.low = 70000 + pixel.x;
    bits = count_on(bits);
    bool whole = bits.high == floatBitsToInt(a) + 1 && bits.low == 69999 + pixel.x;
    others = uvec4(floatBitsToUint(lost), floatBitsToUint(given.w * 1.0f), whole ? 1u : 0u,
                   isnan(uintBitsToFloat(0x7fc00000u | uint(pixel.x))) ? 1u : 0u);
}
