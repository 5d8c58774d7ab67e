#include "report/growth.h"

#include "error/error.h"

#include <cmath>

namespace raysteps {

double growth_exponent(std::span<const GrowthPoint> points) {
    for (const GrowthPoint& point : points) {
        if (!(point.triangles > 0.0 && point.cost > 0.0)) {
            throw InputError("a growth exponent needs numbers over 0. Leave out empty scenes.");
        }
    }
    //# exercise 7.3: how a cost grows
    const double count = static_cast<double>(points.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (const GrowthPoint& point : points) {
        mean_x += std::log(point.triangles) / count;
        mean_y += std::log(point.cost) / count;
    }
    double squares = 0.0;
    double products = 0.0;
    for (const GrowthPoint& point : points) {
        const double x = std::log(point.triangles) - mean_x;
        squares += x * x;
        products += x * (std::log(point.cost) - mean_y);
    }
    //# stub: const double squares = 1.0;
    //# stub: const double products = 0.0;
    //# end
    // A sum of rounding errors is no spread: numbers of triangles are whole, and the logarithms of
    // two different ones below 2^31 lie 4e-10 apart.
    if (!(squares > 1e-20)) {
        throw InputError("a growth exponent needs two scenes of different numbers of triangles. "
                         "Add a scene.");
    }
    return products / squares;
}

} // namespace raysteps
