#include "structure/split_median.h"

namespace raysteps {

std::optional<BvhCut> split_median(const BvhRange& range, const BvhOptions& /*options*/) {
    return BvhCut{longest_axis(range.centers), range.items.size() / 2};
}

} // namespace raysteps
