#pragma once

#include "basics/error.h"
#include "basics/numbers.h"
#include "structure/bvh/box_tree.h"

#include <fmt/core.h>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

// What a tree file consists of: a head in JSON that describes arrays of records, and their bytes.
namespace raysteps::records {

inline constexpr std::string_view magic = "raysteps tree 1\n";
inline constexpr std::uintmax_t most_file_bytes = std::uintmax_t{16} << 30;
inline constexpr std::uint64_t most_records = std::uint64_t{1} << 28;
inline constexpr std::size_t alignment = 16; // of the head's end and of each array

// Throws InputError where the object has a member of another name.
void check_names(const Numbers& object, const std::string& what,
                 const std::vector<std::string_view>& names);

// The whole number of that name, 0 to most. Throws InputError where it is none.
std::uint64_t whole(const Numbers& object, const std::string& name, std::uint64_t most);

// The text of that name, which is one of the words. Throws InputError where it is not.
std::string word(const Numbers& object, const std::string& name,
                 const std::vector<std::string_view>& words);

enum class FieldType { float32, int8, uint8, int16, uint16, int32, uint32, int64, uint64 };

// A field of an array's records: so many values side by side, from that byte of a record on.
struct RecordField {
    std::string name;
    FieldType type = FieldType::int32;
    std::uint64_t at = 0;
    std::uint64_t values = 1;
};

// Records of one size, in the bytes of the file.
struct RecordArray {
    std::string name;
    const char* bytes = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;
    std::vector<RecordField> fields{};

    const RecordField* find(const std::string& field) const {
        const auto known = std::ranges::find(fields, field, &RecordField::name);
        return known == fields.end() ? nullptr : &*known;
    }

    const RecordField& need(const std::string& field, std::uint64_t values) const {
        const RecordField* const known = find(field);
        if (known == nullptr || known->values != values) {
            throw InputError(fmt::format("the array `{}` needs a field `{}` of {} values a record.",
                                         name, field, values));
        }
        return *known;
    }
};

template <class Number>
Number value_at(const char* place) {
    Number number;
    std::memcpy(&number, place, sizeof(Number));
    return number;
}

// A whole number of a record. One that is no int32 becomes far_out, but all ones of an unsigned
// number is -1: that is how C++ writes "none".
std::int32_t index_at(const RecordArray& array, const RecordField& field, std::size_t record,
                      std::size_t value = 0);

float float_at(const RecordArray& array, const RecordField& field, std::size_t record,
               std::size_t value = 0);

// Three floats of a record, from the first on.
glm::vec3 point_at(const RecordArray& array, const RecordField& field, std::size_t record,
                   std::size_t first = 0);

// A field of floats, or of whole numbers. Throws InputError where the array has none.
const RecordField& need_floats(const RecordArray& array, const std::string& name,
                               std::uint64_t values);
const RecordField& need_indices(const RecordArray& array, const std::string& name,
                                std::uint64_t values);

// The array of that name within the bytes behind the head. Throws InputError.
RecordArray read_array(const Numbers& described, const std::string& name, std::string_view data);

struct ReadArrays {
    const Numbers& head;
    std::string_view data;

    bool has(const std::string& name) const { return head.at("arrays").find(name) != nullptr; }

    RecordArray get(const std::string& name) const {
        const Numbers* const described = head.at("arrays").find(name);
        if (described == nullptr) {
            throw InputError("the array `" + name + "` is missing.");
        }
        return read_array(*described, name, data);
    }

    std::vector<std::int32_t> indices(const std::string& name, const std::string& field) const {
        const RecordArray array = get(name);
        const RecordField& own = need_indices(array, field, 1);
        std::vector<std::int32_t> numbers(array.count);
        for (std::size_t i = 0; i < array.count; ++i) {
            numbers[i] = index_at(array, own, i);
        }
        return numbers;
    }
};

} // namespace raysteps::records
