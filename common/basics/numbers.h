#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace raysteps {

// Measured numbers by their names, in the order in which they are to be read: what --json writes
// (program/figures.h). Of values it is a list, of pairs of a name and a value an object, else a
// value by itself.
class Numbers {
public:
    using List = std::vector<Numbers>;
    using Object = std::vector<std::pair<std::string, Numbers>>;

    Numbers() = default; // nothing: becomes an object or a list by what is added

    template <class Number>
    requires std::is_arithmetic_v<Number> Numbers(Number number) : value_(as_stored(number)) {}
    Numbers(std::string text) : value_(std::move(text)) {}
    Numbers(const char* text) : value_(std::string(text)) {}
    Numbers(List values) : value_(std::in_place_type<List>, std::move(values)) {}
    Numbers(Object members) : value_(std::in_place_type<Object>, std::move(members)) {}
    Numbers(std::initializer_list<std::pair<std::string, Numbers>> members);

    template <class Element>
    Numbers(const std::vector<Element>& values)
        : value_(std::in_place_type<List>, values.begin(), values.end()) {}

    // The value of that name, which is added where there is none. Of objects only.
    Numbers& operator[](const std::string& name);

    // Of lists only.
    void push_back(Numbers value);

    // What is in it. Throws InputError that names what is missing, or what is something else.
    const Numbers* find(const std::string& name) const; // null where it is not there
    const Numbers& at(const std::string& name) const;
    double number() const;
    const std::string& text() const;
    const List& values() const;
    const Object& members() const;

    // As JSON, indented by 2, with the fewest digits that give the same numbers again.
    std::string to_json() const;

    using Value = std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double,
                               std::string, List, Object>;
    const Value& value() const { return value_; }

private:
    template <class Number>
    static Value as_stored(Number number) {
        if constexpr (std::is_same_v<Number, bool>) {
            return number;
        } else if constexpr (std::is_floating_point_v<Number>) {
            return static_cast<double>(number);
        } else if constexpr (std::is_signed_v<Number>) {
            return static_cast<std::int64_t>(number);
        } else {
            return static_cast<std::uint64_t>(number);
        }
    }

    Value value_;
};

// A list and an object without anything in them.
inline Numbers empty_list() {
    return Numbers::List{};
}
inline Numbers empty_object() {
    return Numbers::Object{};
}

// The text of a JSON file; the path is named where it is wrong. Throws InputError.
Numbers parse_json(const std::string& text, const std::filesystem::path& path);

} // namespace raysteps
