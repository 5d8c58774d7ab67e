#include "build_trees.h"
#include "catch.h"
#include "structure/structure.h"
#include "support/error_of.h"

#include <algorithm>
#include <map>

using namespace raysteps;

namespace {

std::map<std::string, double> facts_with(const std::map<std::string, std::string>& values) {
    std::map<std::string, double> facts;
    BuildRequest request;
    request.values = values;
    for (const Fact& fact :
         family_of("bvh_ordered").build(random_corners(71, 300), request).facts) {
        facts[fact.name] = fact.value;
    }
    return facts;
}

} // namespace

TEST_CASE("the family of BVHs builds by every rule and says what came of it", "[06]") {
    for (const std::string split : {"median", "insertion", "binned", "sweep"}) {
        auto facts = facts_with({{"split", split}});
        CAPTURE(split);
        CHECK(facts["nodes"] == 2 * facts["leaves"] - 1);
        CHECK(facts["references"] == 300);
        CHECK(facts["references_per_triangle"] == 1);
        CHECK(facts["longest_leaf"] <= 7);
        CHECK(facts["memory_bytes"] == 260 * facts["nodes"] + 48 * 300);
    }
}

TEST_CASE("options of a BVH do what they say", "[06]") {
    CHECK(facts_with({{"leaf-triangles", "1"}})["leaves"] == 300);
    CHECK(facts_with({{"depth", "9"}, {"leaf-triangles", "1"}})["depth"] == 9);
    CHECK(facts_with({{"split", "median"}, {"leaf-triangles", "2"}})["longest_leaf"] == 2);
    CHECK(facts_with({{"bins", "2"}})["expected_cost"] > facts_with({})["expected_cost"]);
    const auto cost_by_insertion = [](const std::string& order, const std::string& seed) {
        return facts_with(
            {{"split", "insertion"}, {"insertion-order", order}, {"seed", seed}})["expected_cost"];
    };
    CHECK(cost_by_insertion("shuffled", "1") != cost_by_insertion("shuffled", "2"));
    CHECK(cost_by_insertion("as_given", "1") == cost_by_insertion("as_given", "2"));
    // A leaf is cheap where a step is dear.
    CHECK(facts_with({{"traversal-cost", "100"}})["nodes"] < facts_with({})["nodes"]);
    CHECK(facts_with({{"intersection-cost", "100"}})["nodes"] > facts_with({})["nodes"]);
}

TEST_CASE("options of a BVH that make no sense are named", "[06]") {
    const auto sentence = [](const std::string& name, const std::string& value) {
        return error_of([&] { facts_with({{name, value}}); });
    };
    CHECK(sentence("split", "area") == "--split area: there is no such choice. Take one of median, "
                                       "insertion, binned, sweep.");
    CHECK_THAT(sentence("leaf-triangles", "0"), starts_with_text("--leaf-triangles 0: "));
    CHECK_THAT(sentence("bins", "many"), starts_with_text("--bins many: "));
    CHECK_THAT(sentence("seed", "-1"), starts_with_text("--seed -1: "));
    CHECK_THAT(sentence("insertion-order", "sorted"),
               contains_text("Take one of shuffled, as_given."));
}
