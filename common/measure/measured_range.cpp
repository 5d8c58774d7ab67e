#include "report/measured_range.h"

#include <algorithm>

namespace raysteps {

MeasuredRange measured_range(std::vector<double> values) {
    //# exercise 7.1: the median and the range
    std::sort(values.begin(), values.end());
    return {values[values.size() / 2], values.front(), values.back()};
    //# stub: return {values.front(), values.front(), values.front()};
    //# end
}

bool lies_below(const MeasuredRange& a, const MeasuredRange& b) {
    //# exercise 7.2: is one surely less
    return a.highest < b.lowest;
    //# stub: return a.median < b.median;
    //# end
}

} // namespace raysteps
