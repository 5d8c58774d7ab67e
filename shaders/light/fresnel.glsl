// Light at a smooth surface between two clear media.

// The part of it that is reflected; the rest goes on. The cosine is that of the angle between the
// ray and the normal, 0 to 1. From 1 on it is total: no angle behind has such a sine.
// Source: Fresnel, "Memoire sur la loi des modifications que la reflexion imprime a la lumiere
// polarisee", 1823; for light that is not polarised, the mean of both directions.
real reflected_part(real cosine, real index_before, real index_behind) {
    if (index_before == index_behind) {
        return real(0.0f);
    }
    //# exercise 9.1: the part that is reflected
    precise real ratio = index_before / index_behind;
    precise real squared_sine_behind = ratio * ratio * (real(1.0f) - cosine * cosine);
    if (squared_sine_behind >= real(1.0f)) {
        return real(1.0f);
    }
    precise real cosine_behind = sqrt(real(1.0f) - squared_sine_behind);
    precise real across = (index_before * cosine - index_behind * cosine_behind) /
                          (index_before * cosine + index_behind * cosine_behind);
    precise real along = (index_before * cosine_behind - index_behind * cosine) /
                         (index_before * cosine_behind + index_behind * cosine);
    precise real part = real(0.5f) * (across * across + along * along);
    return part;
    //# stub: return real(0.0f);
    //# end
}

// The direction behind the surface; direction and normal have length 1, and the normal points
// against the direction. Only where the reflection is not total.
// Source: Snell's law; as a vector, Heckbert and Hanrahan, "Beam Tracing Polygonal Objects", 1984.
real3 refracted_direction(real3 direction, real3 normal, real index_before, real index_behind) {
    if (index_before == index_behind) {
        return direction;
    }
    //# exercise 9.2: the refracted direction
    precise real cosine = -dot_product(direction, normal);
    precise real ratio = index_before / index_behind;
    precise real squared_sine_behind = ratio * ratio * (real(1.0f) - cosine * cosine);
    precise real cosine_behind = sqrt(max(real(0.0f), real(1.0f) - squared_sine_behind));
    precise real3 refracted = ratio * direction + (ratio * cosine - cosine_behind) * normal;
    return refracted;
    //# stub: return direction;
    //# end
}
