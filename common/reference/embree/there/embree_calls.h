#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <array>
#include <cstddef>

namespace raysteps {

// Embree's queries as functions of values, the same for its versions 3 and 4: version 3 asks for a
// context that version 4 has as an argument that may be left out.

constexpr std::size_t packet_size = 8;

// Which of the eight rays there are: -1; the others 0.
struct alignas(32) Valid {
    std::array<int, packet_size> rays{};
};

#if RTC_VERSION_MAJOR >= 4

inline RTCRayHit intersect(RTCScene scene, RTCRayHit query) {
    rtcIntersect1(scene, &query);
    return query;
}

inline RTCRayHit8 intersect(RTCScene scene, const Valid& valid, RTCRayHit8 query) {
    rtcIntersect8(valid.rays.data(), scene, &query);
    return query;
}

inline RTCRay occlude(RTCScene scene, RTCRay query) {
    rtcOccluded1(scene, &query);
    return query;
}

inline RTCRay8 occlude(RTCScene scene, const Valid& valid, RTCRay8 query) {
    rtcOccluded8(valid.rays.data(), scene, &query);
    return query;
}

#else

inline RTCIntersectContext new_context() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    return context;
}

inline RTCRayHit intersect(RTCScene scene, RTCRayHit query) {
    RTCIntersectContext context = new_context();
    rtcIntersect1(scene, &context, &query);
    return query;
}

inline RTCRayHit8 intersect(RTCScene scene, const Valid& valid, RTCRayHit8 query) {
    RTCIntersectContext context = new_context();
    rtcIntersect8(valid.rays.data(), scene, &context, &query);
    return query;
}

inline RTCRay occlude(RTCScene scene, RTCRay query) {
    RTCIntersectContext context = new_context();
    rtcOccluded1(scene, &context, &query);
    return query;
}

inline RTCRay8 occlude(RTCScene scene, const Valid& valid, RTCRay8 query) {
    RTCIntersectContext context = new_context();
    rtcOccluded8(valid.rays.data(), scene, &context, &query);
    return query;
}

#endif

} // namespace raysteps
