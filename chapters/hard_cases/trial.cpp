#include "trial.h"

namespace raysteps {

namespace {

std::string with_commas(std::size_t number) {
    std::string text = std::to_string(number);
    for (auto i = static_cast<std::ptrdiff_t>(text.size()) - 3; i > 0; i -= 3) {
        text.insert(static_cast<std::size_t>(i), ",");
    }
    return text;
}

} // namespace

std::string to_words(std::size_t wrong, std::size_t tried) {
    return with_commas(wrong) + " of " + with_commas(tried);
}

Verdict verdict_of(std::size_t wrong) {
    return wrong == 0 ? Verdict::pass : Verdict::fail;
}

TrialRow promised_row(const std::string& method, const std::string& where,
                      const std::string& expected, std::size_t wrong, std::size_t tried) {
    return {method, where, expected, to_words(wrong, tried) + " wrong", verdict_of(wrong),
            tried,  wrong};
}

TrialRow reported_row(const std::string& method, const std::string& where,
                      const std::string& expected, std::size_t wrong, std::size_t tried) {
    TrialRow row = promised_row(method, where, expected, wrong, tried);
    row.verdict = Verdict::reported;
    return row;
}

} // namespace raysteps
