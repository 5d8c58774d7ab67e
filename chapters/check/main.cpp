// A structure of anybody's: what is wrong with it, which rays go wrong in it, and why.
// load_scene, read_tree_file -> inspect -> check_walks -> tables and files
#include "answers.h"
#include "basics/error.h"
#include "inspection.h"
#include "program/figures.h"
#include "program/options.h"
#include "scene/ray_file.h"
#include "structure/bvh/build_bvh.h"
#include "structure/bvh/family_bvh.h"
#include "structure/grid/build_grid.h"
#include "structure/kd_tree/build_kd_tree.h"
#include "structure/padding.h"
#include "trace/trace_options.h"
#include "why.h"

#include <iostream>

using namespace raysteps;

namespace {

struct CheckRequest {
    PictureOptions scene{.scene = "bunny", .needs_camera = false};
    std::filesystem::path rays;
    std::filesystem::path hits;     // of --judge
    std::filesystem::path exported; // of --export
    bool triangles_inside = false;
    std::string structure = "bvh_ordered";
    std::map<std::string, std::string> build_values; // --tree is among them
    std::string why;
};

AnyTree own_tree(const CheckRequest& request, const Scene& scene) {
    check_build_values(request.build_values, {{request.structure}});
    const BuildRequest build{.values = request.build_values};
    const std::string family = family_of(request.structure).name;
    if (family == "kd") {
        return build_kd_tree(scene.corners, kd_options_of(build));
    }
    if (family == "grid") {
        return build_grid(scene.corners, grid_options_of(build));
    }
    if (family == "bvh") {
        return box_tree_of(build_bvh(scene.corners, bvh_options_of(build)));
    }
    if (family == "bvh4") {
        return box_tree_of(collapse(build_bvh(scene.corners, bvh4_options_of(build))));
    }
    throw InputError("--structure " + request.structure +
                     ": it has no tree to write. Take a BVH, a kd-tree or a grid.");
}

// The tree of --tree, in the scene's numbers, or one of our own.
TreeFile tree_to_export(const CheckRequest& request, const Scene& scene) {
    const auto asked = request.build_values.find("tree");
    if (asked != request.build_values.end()) {
        TreeFile file = read_tree_file(asked->second);
        return {file.made_by, in_numbers_of(file, scene.corners)};
    }
    return {"Raysteps " + request.structure, own_tree(request, scene)};
}

void export_tree(const CheckRequest& request, const Scene& scene) {
    TreeFile file = tree_to_export(request, scene);
    if (request.triangles_inside) {
        file.corners = scene.corners;
    }
    write_tree_file(request.exported, file);
    print_written(request.exported);
}

// `RAY,TRIANGLE`, both from 0.
std::pair<std::size_t, std::int32_t> parse_why(const std::string& text, std::size_t rays,
                                               int triangles) {
    const std::vector<std::string> words = split_words(text, ',');
    const auto ray = parse_number<std::size_t>(words.front());
    const auto triangle = parse_number<std::int32_t>(words.back());
    if (words.size() != 2 || !ray || !triangle || *ray >= rays || *triangle < 0 ||
        *triangle >= triangles) {
        throw InputError("--why " + text +
                         ": give the number of a ray of --rays and of a triangle, as in 3,17; "
                         "there are " +
                         std::to_string(rays) + " rays and " + std::to_string(triangles) +
                         " triangles, counted from 0.");
    }
    return {*ray, *triangle};
}

void explain(const CheckRequest& request, const AnyTree& tree, const Scene& scene,
             std::span<const Ray> rays) {
    const auto* const boxes = std::get_if<BoxTree>(&tree);
    if (boxes == nullptr) {
        throw InputError("--why asks hierarchies of boxes, and this is " + kind_of(tree) +
                         ". See it with ./run.sh view.");
    }
    const auto [ray, triangle] = parse_why(request.why, rays.size(), triangle_count(scene));
    std::cout << "Ray " << ray << ", triangle " << triangle << "\n"
              << why_not(*boxes, scene.corners, rays[ray], triangle);
}

void write_rays(const std::filesystem::path& path, std::span<const Ray> rays,
                const AnswerCheck& check, bool faults) {
    std::vector<Ray> some;
    for (const WrongAnswer& wrong : check.wrong) {
        if (wrong.is_fault == faults) {
            some.push_back(rays[wrong.ray]);
        }
    }
    if (!some.empty()) {
        write_ray_file(path, some);
        print_written(path);
    }
}

void report_answers(const CheckRequest& request, std::span<const Ray> rays,
                    const AnswerCheck& check) {
    std::cout << to_table(check) << std::flush;
    write_rays(request.scene.out / "bad.csv", rays, check, true);
    write_rays(request.scene.out / "slipped.csv", rays, check, false);
}

// As far as a walk can go through the tree at all.
std::optional<AnswerCheck> try_walks(const AnyTree& tree, const Scene& scene,
                                     std::span<const Ray> rays) {
    try {
        return check_walks(tree, scene, rays);
    } catch (const InputError& error) {
        std::cout << "\nRays are not traced: " << error.what() << "\n";
        return std::nullopt;
    }
}

void run_check(const CheckRequest& request) {
    const Scene scene = load_scene(request.scene);
    if (!request.exported.empty()) {
        export_tree(request, scene);
        return;
    }
    const std::vector<Ray> rays =
        request.rays.empty() ? std::vector<Ray>() : read_ray_file(request.rays);
    FiguresHead head{.schema = "check.schema.json", .scenes = {record_of(scene)}};
    Numbers figures = empty_object();
    std::size_t faults = 0;
    const auto asked = request.build_values.find("tree");
    if (asked != request.build_values.end()) {
        const WorkNotice reading("reading " + asked->second);
        TreeFile file = read_tree_file(asked->second);
        const std::string made_by = file.made_by;
        const AnyTree tree = in_numbers_of(std::move(file), scene.corners);
        std::cout << "tree      " << asked->second << ": " << kind_of(tree)
                  << (made_by.empty() ? "" : ", made by " + made_by) << "\n";
        if (!request.why.empty()) {
            explain(request, tree, scene, rays);
            return;
        }
        const BvhOptions options = bvh_options_of(
            {.reach = reach_of(rays, scene.corners), .values = request.build_values});
        const Inspection inspection =
            inspect(tree, scene, options, show_progress("checking the tree"));
        std::cout << to_table(inspection) << std::flush;
        for (const FaultKind& kind : inspection.faults.kinds) {
            faults += kind.count;
        }
        figures = numbers_of(inspection);
        if (!rays.empty() && request.hits.empty()) {
            if (const auto check = try_walks(tree, scene, rays)) {
                report_answers(request, rays, *check);
                figures["answers"] = numbers_of(*check);
                faults += count_faults(*check);
            }
        }
    }
    if (!request.hits.empty()) {
        const AnswerCheck check = check_hits(read_hit_file(request.hits), scene, rays);
        report_answers(request, rays, check);
        figures["answers"] = numbers_of(check);
        faults += count_faults(check);
    }
    figures["faults_found"] = faults;
    write_figures(request.scene.json, head, figures);
    if (faults > 0) {
        throw Error(ExitCode::check_failed,
                    "faults found: " + std::to_string(faults) + ". See the lines above; " +
                        (rays.empty() ? "with --rays it says which go wrong."
                                      : "--why asks for one ray and triangle, and ./run.sh view "
                                        "shows the rays of bad.csv."));
    }
    std::cout << "no fault\n";
}

// Throws InputError where the request asks for nothing, or for what contradicts itself.
void refuse_contradictions(const CheckRequest& request) {
    const bool tree = request.build_values.contains("tree");
    if (!tree && request.hits.empty() && request.exported.empty()) {
        throw InputError("name a file with --tree, or hits with --judge, or --export one of "
                         "our own.");
    }
    if ((!request.hits.empty() || !request.why.empty()) && request.rays.empty()) {
        throw InputError("--judge and --why are about the rays of a file. Name it with "
                         "--rays.");
    }
}

} // namespace

int main(int argc, char** argv) {
    Options options("check", "Checks a structure from a file, and what rays find in it.");
    CheckRequest request;
    request.scene.out = "out/check";
    options.text("--scene", request.scene.scene, "the scene that the tree is of");
    options.number("--scale-exponent", request.scene.scale_exponent,
                   "multiply all lengths of the scene's file by 2 to this power");
    options.input_file("--rays", request.rays, "rays to trace through the tree (.f32 or .csv)");
    options.input_file("--judge", request.hits,
                       "hits that another program found for --rays (.f32 or .csv): check these");
    options.text("--why", request.why,
                 "RAY,TRIANGLE: why that ray of --rays does not come to that triangle");
    options.output_file(
        "--export", request.exported,
        "write our own structure, or that of --tree, to this file, and check nothing");
    options.flag("--triangles-inside", request.triangles_inside,
                 "with the triangles themselves in the file of --export");
    options.text("--structure", request.structure,
                 "what --export writes: the structure of this walk, with its builder's options");
    options.output_folder("--out", request.scene.out, "the folder for rays that go wrong");
    options.output_file("--json", request.scene.json, "a file for what was found");
    add_build_options(options, request.build_values);
    return options.run(argc, argv, [&] {
        refuse_contradictions(request);
        run_check(request);
    });
}
