#include "scene/mtl_values.h"

#include "scene/obj_findings.h"
#include "scene/obj_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace raysteps {

namespace {

enum class OutOfRange { take_nearest, leave_out };

struct Rule {
    std::string_view keyword;
    std::size_t count;
    double least;
    double greatest;
    OutOfRange out_of_range;
};

// Reflectances over 1 make light out of nothing, and facing mirrors then overflow. The ranges of Ni
// and illum are those of the format's description (Wavefront, "MTL material format", 1995); a
// refractive index or a model outside them has no nearest value that would be meant.
constexpr std::array<Rule, 10> rules = {{
    {"Kd", 3, 0.0, 1.0, OutOfRange::take_nearest},
    {"Ks", 3, 0.0, 1.0, OutOfRange::take_nearest},
    {"Ke", 3, 0.0, 1e6, OutOfRange::take_nearest},
    {"Kt", 3, 0.0, 1.0, OutOfRange::take_nearest},
    {"Tf", 3, 0.0, 1.0, OutOfRange::take_nearest},
    {"Ns", 1, 0.0, 1e6, OutOfRange::take_nearest},
    {"Ni", 1, 0.001, 10.0, OutOfRange::leave_out},
    {"d", 1, 0.0, 1.0, OutOfRange::take_nearest},
    {"Tr", 1, 0.0, 1.0, OutOfRange::take_nearest},
    {"illum", 1, 0.0, 10.0, OutOfRange::leave_out},
}};

const Rule* find_rule(std::string_view keyword) {
    const auto is_of_keyword = [&](const Rule& rule) { return rule.keyword == keyword; };
    const auto rule = std::find_if(rules.begin(), rules.end(), is_of_keyword);
    return rule == rules.end() ? nullptr : &*rule;
}

std::string statement(std::string_view keyword, std::span<const float> values) {
    std::string text(keyword);
    for (const float value : values)
        text += ' ' + to_text(value);
    return text + '\n';
}

std::string statement(std::string_view keyword, const glm::vec3& color) {
    return statement(keyword, std::array{color.x, color.y, color.z});
}

std::string renamed_statement(const Rule& rule, std::vector<float> values) {
    if (rule.keyword == "Kt")
        return statement("Tf", values);
    if (rule.keyword == "Tr")
        return statement("d", std::array{1.0f - values[0]});
    return statement(rule.keyword, values);
}

std::string complaint(const Rule& rule, std::string_view word) {
    return std::string(rule.keyword) + " " + in_quotes(word) + " is not a number between " +
           to_text(static_cast<float>(rule.least)) + " and " +
           to_text(static_cast<float>(rule.greatest));
}

} // namespace

bool has_mtl_values(std::string_view keyword) {
    return find_rule(keyword) != nullptr;
}

MtlValues checked_mtl_values(const std::vector<std::string_view>& words) {
    const Rule& rule = *find_rule(words.front());
    MtlValues result;
    std::vector<float> values;
    for (std::size_t i = 1; i <= rule.count; ++i) {
        const bool is_grey = words.size() == 2;
        const std::string_view word = is_grey ? words[1] : i < words.size() ? words[i] : "";
        const double number = to_number(word).value_or(std::nan(""));
        const bool is_right = number >= rule.least && number <= rule.greatest;
        const bool is_hopeless = std::isnan(number) || rule.out_of_range == OutOfRange::leave_out;
        if (!is_right && is_hopeless)
            return {"", complaint(rule, word) + ", so the line was left out"};
        const auto value = static_cast<float>(std::clamp(number, rule.least, rule.greatest));
        if (!is_right)
            result.correction = complaint(rule, word) + ", so " + to_text(value) + " is used";
        values.push_back(value);
    }
    result.statement = renamed_statement(rule, values);
    return result;
}

std::string to_mtl(const Material& material) {
    return "newmtl " + material.name + '\n' + statement("Kd", material.diffuse) +
           statement("Ks", material.specular) + statement("Ke", material.emission) +
           statement("Tf", material.transmission) + "Ns " + to_text(material.shininess) + "\nNi " +
           to_text(material.refractive_index) + "\nd " + to_text(material.opacity) + "\nillum " +
           std::to_string(material.illumination_model) + '\n';
}

} // namespace raysteps
