#include "scene/import/mesh_file.h"

#include "basics/error.h"
#include "scene/obj/obj_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace raysteps {

namespace {

constexpr std::string_view beginning = "raysteps mesh 1\n";

// Numbers and vectors of them lie in the file as in memory.
template <class Value>
concept Plain = std::is_arithmetic_v<Value> || std::is_same_v<Value, glm::vec2> ||
    std::is_same_v<Value, glm::vec3> || std::is_same_v<Value, glm::dvec3>;

class MeshWriter {
public:
    template <Plain Value>
    void visit(const Value& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }

    void visit(const std::string& text) {
        visit(static_cast<std::uint64_t>(text.size()));
        bytes += text;
    }

    template <class Value>
    void visit(const std::vector<Value>& values) {
        visit(static_cast<std::uint64_t>(values.size()));
        if constexpr (Plain<Value>) {
            bytes.append(reinterpret_cast<const char*>(values.data()),
                         values.size() * sizeof(Value));
        } else {
            for (const Value& value : values) {
                visit_fields(*this, value);
            }
        }
    }

    template <class Value>
    void visit(const std::optional<Value>& value) {
        visit(static_cast<std::uint8_t>(value ? 1 : 0));
        if (value) {
            visit_fields(*this, *value);
        }
    }

    std::string bytes{beginning};
};

class MeshReader {
public:
    MeshReader(std::string_view bytes, const std::filesystem::path& path)
        : rest_(bytes), path_(path) {}

    template <Plain Value>
    void visit(Value& value) {
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
    }

    void visit(std::string& text) { text = take(count(1)); }

    template <class Value>
    void visit(std::vector<Value>& values) {
        if constexpr (Plain<Value>) {
            values.resize(count(sizeof(Value)));
            const std::string_view bytes = take(values.size() * sizeof(Value));
            if (!bytes.empty()) {
                std::memcpy(values.data(), bytes.data(), bytes.size());
            }
        } else {
            values.resize(count(least_bytes<Value>));
            for (Value& value : values) {
                visit_fields(*this, value);
            }
        }
    }

    template <class Value>
    void visit(std::optional<Value>& value) {
        std::uint8_t is_there = 0;
        visit(is_there);
        if (is_there != 0) {
            visit_fields(*this, value.emplace());
        }
    }

    std::string_view take(std::uint64_t size) {
        if (size > rest_.size()) {
            fail("it ends too early");
        }
        const std::string_view bytes = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return bytes;
    }

    bool is_at_end() const { return rest_.empty(); }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(path_.string() + ": what was imported cannot be used: " + what +
                         ". Check the export, or try another format.");
    }

private:
    // A text has eight bytes or more, and everything that holds one.
    template <class Value>
    static constexpr std::uint64_t least_bytes = 8;

    std::uint64_t count(std::uint64_t bytes_each) {
        std::uint64_t number = 0;
        visit(number);
        if (number > rest_.size() / bytes_each) {
            fail("it ends too early");
        }
        return number;
    }

    std::string_view rest_;
    const std::filesystem::path& path_;
};

// One list of fields for both directions.

template <class Archive, class Text>
requires std::is_same_v<std::remove_const_t<Text>, std::string>
void visit_fields(Archive& archive, Text& text) {
    archive.visit(text);
}

template <class Archive, class Group>
requires std::is_same_v<std::remove_const_t<Group>, MeshGroup>
void visit_fields(Archive& archive, Group& group) {
    archive.visit(group.first_face);
    archive.visit(group.material);
    archive.visit(group.primitive);
    archive.visit(group.object);
}

template <class Archive, class Kind>
requires std::is_same_v<std::remove_const_t<Kind>, Material>
void visit_fields(Archive& archive, Kind& material) {
    archive.visit(material.name);
    archive.visit(material.diffuse);
    archive.visit(material.specular);
    archive.visit(material.shininess);
    archive.visit(material.emission);
    archive.visit(material.refractive_index);
    archive.visit(material.opacity);
    archive.visit(material.transmission);
    archive.visit(material.illumination_model);
    archive.visit(material.diffuse_map);
    archive.visit(material.cutout_map);
    archive.visit(material.cutoff);
    archive.visit(material.normal_map);
    archive.visit(material.emissive_map);
    archive.visit(material.emissive_factor);
}

template <class Archive, class Kind>
requires std::is_same_v<std::remove_const_t<Kind>, Light>
void visit_fields(Archive& archive, Kind& light) {
    archive.visit(light.position);
    archive.visit(light.color);
    archive.visit(light.across);
    archive.visit(light.along);
}

template <class Archive, class Kind>
requires std::is_same_v<std::remove_const_t<Kind>, EnclosedPicture>
void visit_fields(Archive& archive, Kind& picture) {
    archive.visit(picture.name);
    archive.visit(picture.bytes);
}

template <class Archive, class Kind>
requires std::is_same_v<std::remove_const_t<Kind>, Camera>
void visit_fields(Archive& archive, Kind& camera) {
    archive.visit(camera.eye);
    archive.visit(camera.target);
    archive.visit(camera.up);
    archive.visit(camera.vertical_field_of_view);
}

template <class Archive, class Kind>
requires std::is_same_v<std::remove_const_t<Kind>, MeshFile>
void visit_fields(Archive& archive, Kind& mesh) {
    archive.visit(mesh.positions);
    archive.visit(mesh.normals);
    archive.visit(mesh.texture_coordinates);
    archive.visit(mesh.colors);
    archive.visit(mesh.corners);
    archive.visit(mesh.sizes);
    archive.visit(mesh.groups);
    archive.visit(mesh.materials);
    archive.visit(mesh.lights);
    archive.visit(mesh.pictures);
    archive.visit(mesh.camera);
    archive.visit(mesh.messages);
}

template <class Vector>
bool is_within(const Vector& vector, double greatest) {
    for (int i = 0; i < Vector::length(); ++i) {
        if (!(std::abs(static_cast<double>(vector[i])) <= greatest)) { // NaN is not
            return false;
        }
    }
    return true;
}

float in_range(float value, float least, float greatest, float otherwise) {
    return std::isnan(value) ? otherwise : std::clamp(value, least, greatest);
}

glm::vec3 in_range(const glm::vec3& color, float greatest) {
    return {in_range(color.x, 0.0f, greatest, 0.0f), in_range(color.y, 0.0f, greatest, 0.0f),
            in_range(color.z, 0.0f, greatest, 0.0f)};
}

// The ranges of an MTL file's values (scene/obj/mtl.cpp).
void bring_in_range(Material& material) {
    material.diffuse = in_range(material.diffuse, 1.0f);
    material.specular = in_range(material.specular, 1.0f);
    material.emission = in_range(material.emission, 1e6f);
    material.transmission = in_range(material.transmission, 1.0f);
    material.shininess = in_range(material.shininess, 0.0f, 1e6f, 0.0f);
    material.refractive_index = in_range(material.refractive_index, 0.001f, 10.0f, 1.0f);
    material.opacity = in_range(material.opacity, 0.0f, 1.0f, 1.0f);
    material.illumination_model = std::clamp(material.illumination_model, 0, 10);
    material.cutoff = in_range(material.cutoff, 0.0f, 1.0f, 0.5f);
    material.emissive_factor = in_range(material.emissive_factor, 1e6f);
}

bool is_usable(const Camera& camera) {
    const double angle = static_cast<double>(camera.vertical_field_of_view);
    return is_within(camera.eye, greatest_coordinate) &&
           is_within(camera.target, greatest_coordinate) && is_within(camera.up, 1e6) &&
           camera.up != glm::vec3(0.0f) && camera.eye != camera.target && angle > 0.0 &&
           angle < 180.0;
}

void check_lists(const MeshFile& mesh, const MeshReader& reader) {
    const auto fits = [&](std::size_t count) {
        return count == 0 || count == mesh.positions.size();
    };
    if (!fits(mesh.normals.size()) || !fits(mesh.texture_coordinates.size()) ||
        !fits(mesh.colors.size())) {
        reader.fail("its lists have different lengths");
    }
    std::uint64_t corners = 0;
    for (const std::uint32_t size : mesh.sizes) {
        corners += size;
    }
    if (corners != mesh.corners.size()) {
        reader.fail("its faces do not have the corners that it holds");
    }
    for (const std::uint32_t corner : mesh.corners) {
        if (corner >= mesh.positions.size()) {
            reader.fail("a face names a vertex that is not there");
        }
    }
    for (const glm::dvec3& position : mesh.positions) {
        if (!is_within(position, greatest_coordinate)) {
            reader.fail("a coordinate is not a number between -1.8e18 and 1.8e18");
        }
    }
}

void check_groups(const MeshFile& mesh, const MeshReader& reader) {
    std::uint64_t last = 0;
    for (const MeshGroup& group : mesh.groups) {
        const bool has_material =
            group.material >= 0 && static_cast<std::size_t>(group.material) < mesh.materials.size();
        if (!has_material || group.first_face < last || group.first_face > mesh.sizes.size()) {
            reader.fail("its groups are not in order");
        }
        last = group.first_face;
    }
    if (!mesh.sizes.empty() && (mesh.groups.empty() || mesh.groups.front().first_face != 0)) {
        reader.fail("a face belongs to no group");
    }
}

} // namespace

std::string write_mesh_file(const MeshFile& mesh) {
    MeshWriter writer;
    visit_fields(writer, mesh);
    return std::move(writer.bytes);
}

MeshFile read_mesh_file(std::string_view bytes, const std::filesystem::path& path) {
    MeshReader reader(bytes, path);
    if (!bytes.starts_with(beginning)) {
        reader.fail("it does not begin as a mesh does");
    }
    reader.take(beginning.size());
    MeshFile mesh;
    visit_fields(reader, mesh);
    if (!reader.is_at_end()) {
        reader.fail("it goes on where it should end");
    }
    check_lists(mesh, reader);
    check_groups(mesh, reader);
    for (Material& material : mesh.materials) {
        bring_in_range(material);
    }
    for (glm::vec3& color : mesh.colors) {
        color = in_range(color, 1.0f);
    }
    for (glm::vec2& place : mesh.texture_coordinates) {
        place = is_within(place, greatest_coordinate) ? place : glm::vec2(0.0f);
    }
    std::erase_if(mesh.lights, [](const Light& light) {
        return !is_within(light.position, greatest_coordinate) || !is_within(light.color, 1e6) ||
               has_area(light);
    });
    for (Light& light : mesh.lights) {
        light.color = in_range(light.color, 1e6f);
    }
    if (mesh.camera && !is_usable(*mesh.camera)) {
        mesh.camera.reset();
    }
    return mesh;
}

} // namespace raysteps
