#include "triangle_knob.h"

#include "trace_trials.h"

namespace raysteps {

namespace {

const std::string in_double = "exhibit/double_precision.glsl";

Parts with_test(const std::string& file) {
    return {{"triangle", "triangle/" + file + ".glsl"}};
}

Parts with_test_in_double(const std::string& file) {
    return {{"triangle", "triangle/" + file + ".glsl"}, {"real", in_double}};
}

} // namespace

const std::vector<TriangleMethod>& triangle_methods() {
    static const std::vector<TriangleMethod> all{
        {"paper, culling", with_test("paper_culling")},
        {"paper, 1e-6", with_test("paper_two_sided")},
        {"paper, repaired", with_test("paper_repaired")},
        {"Moeller-Trumbore", with_test("moeller_trumbore")},
        {"Moeller-Trumbore, double", with_test_in_double("moeller_trumbore")},
        {"Pluecker", with_test("pluecker")},
        {"Baldwin-Weber", Parts{{"triangle", "exhibit/precomputed_triangle.glsl"}}},
        {"watertight, rounded", with_test("watertight_rounded")},
        {"watertight, fallback", with_test("watertight_fallback")},
        {"watertight, exact areas", with_test("watertight")},
        {"watertight, double", with_test_in_double("watertight_rounded")}};
    return all;
}

Knob triangle_knob(const std::string& name, const std::shared_ptr<const Subject>& subject,
                   const Effort& effort) {
    std::vector<TraceMethod> methods;
    for (const TriangleMethod& method : triangle_methods()) {
        Parts parts = method.parts;
        parts["structure"] = subject->structure;
        methods.push_back({method.name, std::move(parts), subject->textures});
    }
    const std::span<const glm::vec3> corners = subject->scene.corners;
    const auto families =
        with_truth(families_from_inside(corners, effort.judged_rays, effort.seed), corners, effort);
    Knob knob;
    knob.name = name;
    knob.question = "Where does a ray meet a triangle? On " + subject->scene.name + ".";
    knob.source = "Published, not measured here: watertight at \"the same performance as simpler "
                  "algorithms that are not watertight\" (Woop, Benthin and Wald, Watertight "
                  "Ray/Triangle Intersection, 2013); Plücker's volumes are tight along edges and "
                  "not at corners (the same).";
    knob.unit_of_cases = "ray";
    knob.unit_of_error = "t, in ulp";
    knob.trials = trace_trials(methods, families, corners, effort);
    for (Trial& trial : knob.trials) { // the corners live in the subject
        trial.examine = [examine = std::move(trial.examine), subject] { return examine(); };
    }
    return knob;
}

} // namespace raysteps
