#include "basics/numbers.h"

#include "basics/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace raysteps {

namespace {

using Json = nlohmann::ordered_json;

// No file of ours goes deeper than ten; each level takes room on the stack.
constexpr int deepest = 64;

Json json_of(const Numbers& numbers);

Json json_of(std::monostate) {
    return nullptr;
}

template <class Value>
Json json_of(const Value& value) {
    return value;
}

Json json_of(const Numbers::List& values) {
    Json json = Json::array();
    for (const Numbers& value : values) {
        json.push_back(json_of(value));
    }
    return json;
}

Json json_of(const Numbers::Object& members) {
    Json json = Json::object();
    for (const auto& [name, value] : members) {
        json[name] = json_of(value);
    }
    return json;
}

Json json_of(const Numbers& numbers) {
    return std::visit([](const auto& value) { return json_of(value); }, numbers.value());
}

Numbers numbers_of(const Json& json) {
    switch (json.type()) {
    case Json::value_t::object: {
        Numbers numbers = empty_object();
        for (const auto& [name, value] : json.items()) {
            numbers[name] = numbers_of(value);
        }
        return numbers;
    }
    case Json::value_t::array: {
        Numbers numbers = empty_list();
        for (const Json& value : json) {
            numbers.push_back(numbers_of(value));
        }
        return numbers;
    }
    case Json::value_t::string:
        return json.get<std::string>();
    case Json::value_t::boolean:
        return json.get<bool>();
    case Json::value_t::number_integer:
        return json.get<std::int64_t>();
    case Json::value_t::number_unsigned:
        return json.get<std::uint64_t>();
    case Json::value_t::number_float:
        return json.get<double>();
    default:
        return {};
    }
}

// The value where it is of that kind.
template <class Kind>
const Kind& value_of(const Numbers& numbers, const std::string& kind) {
    const Kind* const value = std::get_if<Kind>(&numbers.value());
    if (value == nullptr) {
        throw InputError("`" + numbers.to_json() + "` stands in a JSON file where " + kind +
                         " is needed. Check how the file was written.");
    }
    return *value;
}

} // namespace

Numbers::Numbers(std::initializer_list<std::pair<std::string, Numbers>> members)
    : value_(std::in_place_type<Object>, members) {}

Numbers& Numbers::operator[](const std::string& name) {
    if (std::holds_alternative<std::monostate>(value_)) {
        value_ = Object{};
    }
    auto& members = std::get<Object>(value_);
    const auto known = std::find_if(members.begin(), members.end(),
                                    [&](const auto& member) { return member.first == name; });
    return known != members.end() ? known->second : members.emplace_back(name, Numbers{}).second;
}

void Numbers::push_back(Numbers value) {
    if (std::holds_alternative<std::monostate>(value_)) {
        value_ = List{};
    }
    std::get<List>(value_).push_back(std::move(value));
}

const Numbers* Numbers::find(const std::string& name) const {
    const Object& all = members();
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const auto& member) { return member.first == name; });
    return known == all.end() ? nullptr : &known->second;
}

const Numbers& Numbers::at(const std::string& name) const {
    const Numbers* const value = find(name);
    if (value == nullptr) {
        throw InputError("`" + name +
                         "` is missing in a JSON file. Check how the file was "
                         "written.");
    }
    return *value;
}

double Numbers::number() const {
    if (const auto* const whole = std::get_if<std::int64_t>(&value_)) {
        return static_cast<double>(*whole);
    }
    if (const auto* const count = std::get_if<std::uint64_t>(&value_)) {
        return static_cast<double>(*count);
    }
    return value_of<double>(*this, "a number");
}

const std::string& Numbers::text() const {
    return value_of<std::string>(*this, "a text");
}

const Numbers::List& Numbers::values() const {
    return value_of<List>(*this, "a list");
}

const Numbers::Object& Numbers::members() const {
    return value_of<Object>(*this, "an object");
}

std::string Numbers::to_json() const {
    return json_of(*this).dump(2);
}

Numbers parse_json(const std::string& text, const std::filesystem::path& path) {
    try {
        return numbers_of(Json::parse(text, [&](int depth, Json::parse_event_t, const Json&) {
            if (depth > deepest) {
                throw InputError(path.string() + ": lists within lists, deeper than " +
                                 std::to_string(deepest) + ". Check how the file was written.");
            }
            return true;
        }));
    } catch (const Json::exception& error) {
        throw InputError(path.string() + ": this is no JSON file (" + error.what() +
                         "). Name another.");
    }
}

} // namespace raysteps
