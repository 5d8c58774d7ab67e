#include "numbers.h"

#include <algorithm>

namespace raysteps {

namespace {

using Json = nlohmann::ordered_json;

Json row_numbers(const ContestRow& row) {
    Json numbers{{"contender", row.contender}, {"rays", row.rays},
                 {"of", row.all_rays},         {"million_rays_a_second", row.rate.median},
                 {"lowest", row.rate.lowest},  {"highest", row.rate.highest},
                 {"cores", row.cores},         {"other_answers", row.different}};
    if (!is_embree(row.contender)) {
        numbers["visits_a_ray"] = row.visits_a_ray;
        numbers["tests_a_ray"] = row.tests_a_ray;
    }
    return numbers;
}

// The rows of one kind, the best walk of ours among them, and its ratio to Embree.
Json kind_numbers(const std::vector<ContestRow>& rows) {
    Json walks = Json::array();
    const ContestRow* best = nullptr;
    const ContestRow* embree = nullptr;
    for (const ContestRow& row : rows) {
        walks.push_back(row_numbers(row));
        if (row.contender == embree_single) {
            embree = &row;
        } else if (!is_embree(row.contender) &&
                   (best == nullptr || row.rate.median > best->rate.median)) {
            best = &row;
        }
    }
    Json numbers{{"kind", rows.front().kind}, {"walks", walks}};
    if (best != nullptr) {
        numbers["best_walk"] = best->contender;
    }
    if (best != nullptr && embree != nullptr) {
        const double ratio = best->rate.median / embree->rate.median;
        numbers["ratio_to_embree"] = ratio;
        // Rays a second that a CPU worked on them, whoever else had the others.
        numbers["ratio_by_cpu_time"] = ratio * embree->cores / best->cores;
    }
    return numbers;
}

Json scene_numbers(const SceneResult& result) {
    Json builds = Json::array();
    for (const ContestBuild& build : result.builds) {
        Json facts = Json::object();
        for (const Fact& fact : build.facts) {
            facts[fact.name] = fact.value;
        }
        builds.push_back({{"contender", build.contender}, {"facts", facts}});
    }
    Json kinds = Json::array();
    auto begin = result.rows.begin();
    while (begin != result.rows.end()) { // the rows of a kind follow one another
        const auto end = std::find_if(begin, result.rows.end(), [&](const ContestRow& row) {
            return row.kind != begin->kind;
        });
        kinds.push_back(kind_numbers({begin, end}));
        begin = end;
    }
    return {{"scene", result.scene},
            {"triangles", result.triangles},
            {"structures", builds},
            {"rays", kinds}};
}

Json claim_numbers(const ClaimResult& claim) {
    Json cases = Json::array();
    for (const ClaimCase& one : claim.cases) {
        cases.push_back(
            {{"scene", one.scene}, {"verdict", to_words(one.verdict)}, {"numbers", one.numbers}});
    }
    return {{"claim", claim.claim},
            {"by", claim.kind},
            {"verdict", to_words(claim.verdict)},
            {"cases", cases}};
}

Json growth_numbers(const GrowthLine& line) {
    Json points = Json::array();
    for (const GrowthPoint& point : line.points) {
        points.push_back({{"triangles", point.triangles}, {"cost", point.cost}});
    }
    return {{"contender", line.contender},
            {"cost", line.cost},
            {"exponent", line.exponent},
            {"points", points}};
}

} // namespace

Json to_json(const Report& report) {
    Json scenes = Json::array();
    for (const SceneResult& result : report.results) {
        scenes.push_back(scene_numbers(result));
    }
    Json claims = Json::array();
    for (const ClaimResult& claim : report.claims) {
        claims.push_back(claim_numbers(claim));
    }
    Json growth = Json::array();
    for (const GrowthLine& line : report.growth) {
        growth.push_back(growth_numbers(line));
    }
    return {{"renderer", report.renderer},
            {"embree", report.embree},
            {"scenes", scenes},
            {"claims", claims},
            {"growth", growth}};
}

} // namespace raysteps
