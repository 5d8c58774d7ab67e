#include "structure/tree_file/record_arrays.h"

#include "basics/text.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace raysteps::records {

static_assert(std::endian::native == std::endian::little, "the file's numbers are little-endian");

namespace {

constexpr std::uint64_t most_record_bytes = 4096;

struct NamedType {
    std::string_view name;
    FieldType type;
    std::uint64_t bytes;
};

constexpr std::array<NamedType, 9> field_types{{{"float32", FieldType::float32, 4},
                                                {"int8", FieldType::int8, 1},
                                                {"uint8", FieldType::uint8, 1},
                                                {"int16", FieldType::int16, 2},
                                                {"uint16", FieldType::uint16, 2},
                                                {"int32", FieldType::int32, 4},
                                                {"uint32", FieldType::uint32, 4},
                                                {"int64", FieldType::int64, 8},
                                                {"uint64", FieldType::uint64, 8}}};

template <class Number>
std::int32_t narrow_index(Number number) {
    constexpr auto least = std::numeric_limits<std::int32_t>::min();
    if (std::cmp_greater_equal(number, far_out)) {
        return number == std::numeric_limits<std::uint32_t>::max() ? no_child : far_out;
    }
    return std::cmp_less(number, least) ? least : static_cast<std::int32_t>(number);
}

} // namespace

void check_names(const Numbers& object, const std::string& what,
                 const std::vector<std::string_view>& names) {
    for (const auto& [name, value] : object.members()) {
        if (std::ranges::find(names, name) == names.end()) {
            throw InputError(what + " has a member " + in_quotes(name) + ". It may have " +
                             listed(names) + ".");
        }
    }
}

std::uint64_t whole(const Numbers& object, const std::string& name, std::uint64_t most) {
    const double number = object.at(name).number();
    if (!(number >= 0.0 && number <= static_cast<double>(most)) || number != std::floor(number)) {
        throw InputError(fmt::format("`{}` is {}, and must be a whole number from 0 to {}.", name,
                                     number, most));
    }
    return static_cast<std::uint64_t>(number);
}

std::string word(const Numbers& object, const std::string& name,
                 const std::vector<std::string_view>& words) {
    const std::string& text = object.at(name).text();
    if (std::ranges::find(words, text) == words.end()) {
        throw InputError(fmt::format("`{}` is {}, and must be one of {}.", name, in_quotes(text),
                                     listed(words)));
    }
    return text;
}

std::int32_t index_at(const RecordArray& array, const RecordField& field, std::size_t record,
                      std::size_t value) {
    const char* const first = array.bytes + record * array.stride + field.at;
    switch (field.type) {
    case FieldType::int8:
        return value_at<std::int8_t>(first + value);
    case FieldType::uint8:
        return value_at<std::uint8_t>(first + value);
    case FieldType::int16:
        return value_at<std::int16_t>(first + 2 * value);
    case FieldType::uint16:
        return value_at<std::uint16_t>(first + 2 * value);
    case FieldType::int32:
        return value_at<std::int32_t>(first + 4 * value);
    case FieldType::uint32:
        return narrow_index(value_at<std::uint32_t>(first + 4 * value));
    case FieldType::int64:
        return narrow_index(value_at<std::int64_t>(first + 8 * value));
    case FieldType::uint64: {
        const auto number = value_at<std::uint64_t>(first + 8 * value);
        return number == std::numeric_limits<std::uint64_t>::max() ? no_child
                                                                   : narrow_index(number);
    }
    case FieldType::float32:
        break;
    }
    return far_out;
}

float float_at(const RecordArray& array, const RecordField& field, std::size_t record,
               std::size_t value) {
    return value_at<float>(array.bytes + record * array.stride + field.at + 4 * value);
}

const RecordField& need_floats(const RecordArray& array, const std::string& name,
                               std::uint64_t values) {
    const RecordField& field = array.need(name, values);
    if (field.type != FieldType::float32) {
        throw InputError(fmt::format("the field `{}` of `{}` is no float32. Nodes whose boxes are "
                                     "quantised or doubles are not read: write boxes as float32, "
                                     "rounded outwards.",
                                     name, array.name));
    }
    return field;
}

const RecordField& need_indices(const RecordArray& array, const std::string& name,
                                std::uint64_t values) {
    const RecordField& field = array.need(name, values);
    if (field.type == FieldType::float32) {
        throw InputError(
            fmt::format("the field `{}` of `{}` must be of whole numbers.", name, array.name));
    }
    return field;
}

glm::vec3 point_at(const RecordArray& array, const RecordField& field, std::size_t record,
                   std::size_t first) {
    return {float_at(array, field, record, first), float_at(array, field, record, first + 1),
            float_at(array, field, record, first + 2)};
}

namespace {

RecordField read_field(const Numbers& described, const std::string& array) {
    check_names(described, "a field of `" + array + "`", {"name", "type", "at", "values"});
    RecordField field;
    field.name = described.at("name").text();
    const std::string& type = described.at("type").text();
    const auto known = std::ranges::find(field_types, type, &NamedType::name);
    if (known == field_types.end()) {
        throw InputError(fmt::format(
            "the field {} of `{}` has the type {}. Nodes are read as float32 and as int8 to "
            "uint64: quantised boxes and doubles are not, so write boxes as float32, rounded "
            "outwards.",
            in_quotes(field.name), array, in_quotes(type)));
    }
    field.type = known->type;
    field.at = whole(described, "at", most_record_bytes);
    field.values =
        described.find("values") == nullptr ? 1 : whole(described, "values", most_record_bytes);
    return field;
}

} // namespace

RecordArray read_array(const Numbers& described, const std::string& name, std::string_view data) {
    check_names(described, "the array `" + name + "`", {"at", "count", "stride", "fields"});
    RecordArray array{.name = name};
    const std::uint64_t at = whole(described, "at", most_file_bytes);
    const std::uint64_t count = whole(described, "count", most_records);
    const std::uint64_t stride = whole(described, "stride", most_record_bytes);
    for (const Numbers& field : described.at("fields").values()) {
        array.fields.push_back(read_field(field, name));
        const RecordField& read = array.fields.back();
        const auto type = std::ranges::find(field_types, read.type, &NamedType::type);
        if (read.values == 0 || read.at + read.values * type->bytes > stride) {
            throw InputError(fmt::format("the field {} of `{}` reaches beyond its record of {} "
                                         "bytes.",
                                         in_quotes(read.name), name, stride));
        }
    }
    if (at > data.size() || count * stride > data.size() - at) {
        throw InputError(fmt::format("the array `{}` needs {} bytes from byte {} behind the head "
                                     "on, and the file has {} there. It is cut short, or the head "
                                     "is wrong.",
                                     name, count * stride, at, data.size()));
    }
    array.bytes = data.data() + at;
    array.count = count;
    array.stride = stride;
    return array;
}

} // namespace raysteps::records
