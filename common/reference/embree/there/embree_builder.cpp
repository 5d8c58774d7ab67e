#include "reference/embree/embree.h"

#include "basics/error.h"
#include "reference/embree/there/embree_calls.h"

#include <vector>

namespace raysteps {

namespace {

struct InnerNode {
    std::array<void*, 2> children;
    std::array<RTCBounds, 2> boxes;
};

// Its triangles stand behind it.
struct Leaf {
    std::size_t count;
};

// A pointer to a leaf is told from one to an inner node by its lowest bit.
void* marked(Leaf* leaf) {
    return reinterpret_cast<char*>(leaf) + 1;
}

const Leaf* leaf_of(const void* node) {
    const bool leaf = (reinterpret_cast<std::uintptr_t>(node) & 1U) != 0;
    return leaf ? reinterpret_cast<const Leaf*>(static_cast<const char*>(node) - 1) : nullptr;
}

// What Embree calls for each part of the tree; `tree` is the EmbreeTree.

void* make_inner_node(RTCThreadLocalAllocator memory, unsigned, void* tree) {
    ++static_cast<EmbreeTree*>(tree)->inner_nodes;
    return rtcThreadLocalAlloc(memory, sizeof(InnerNode), alignof(InnerNode));
}

void set_children(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) {
        static_cast<InnerNode*>(node)->children[i] = children[i];
    }
}

void set_boxes(void* node, const RTCBounds** boxes, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) {
        static_cast<InnerNode*>(node)->boxes[i] = *boxes[i];
    }
}

void* make_leaf(RTCThreadLocalAllocator memory, const RTCBuildPrimitive* triangles,
                std::size_t count, void* tree) {
    ++static_cast<EmbreeTree*>(tree)->leaves;
    static_cast<EmbreeTree*>(tree)->triangles += count;
    auto* const leaf = static_cast<Leaf*>(
        rtcThreadLocalAlloc(memory, sizeof(Leaf) + count * sizeof(unsigned), alignof(Leaf)));
    leaf->count = count;
    auto* const own = reinterpret_cast<unsigned*>(leaf + 1);
    for (std::size_t i = 0; i < count; ++i) {
        own[i] = triangles[i].primID;
    }
    return marked(leaf);
}

} // namespace

struct EmbreeBuilder::Inside {
    EmbreeTreeOptions options;
    std::vector<RTCBuildPrimitive> triangles;
    std::vector<RTCBuildPrimitive> prepared;
    RTCDevice device = nullptr;
    RTCBVH tree = nullptr;
    void* root = nullptr;
};

EmbreeBuilder::EmbreeBuilder(std::span<const Box> boxes, const EmbreeTreeOptions& options)
    : inside_(std::make_unique<Inside>()) {
    inside_->options = options;
    for (const Box& box : boxes) {
        RTCBuildPrimitive triangle{};
        triangle.lower_x = box.lower.x;
        triangle.lower_y = box.lower.y;
        triangle.lower_z = box.lower.z;
        triangle.upper_x = box.upper.x;
        triangle.upper_y = box.upper.y;
        triangle.upper_z = box.upper.z;
        triangle.primID = static_cast<unsigned>(inside_->triangles.size());
        inside_->triangles.push_back(triangle);
    }
    inside_->device = rtcNewDevice("threads=1");
    if (inside_->device == nullptr) {
        throw MachineError("Embree cannot start: it gives no device.");
    }
}

EmbreeBuilder::~EmbreeBuilder() {
    if (inside_->tree != nullptr) {
        rtcReleaseBVH(inside_->tree);
    }
    if (inside_->device != nullptr) {
        rtcReleaseDevice(inside_->device);
    }
}

void EmbreeBuilder::prepare() {
    if (inside_->tree != nullptr) {
        rtcReleaseBVH(inside_->tree);
    }
    inside_->tree = rtcNewBVH(inside_->device);
    inside_->prepared = inside_->triangles;
}

EmbreeTree EmbreeBuilder::build() {
    EmbreeTree tree;
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.byteSize = sizeof(arguments);
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = 64;
    arguments.sahBlockSize = 1;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = static_cast<unsigned>(inside_->options.leaf_triangles);
    arguments.traversalCost = static_cast<float>(inside_->options.traversal_cost);
    arguments.intersectionCost = static_cast<float>(inside_->options.intersection_cost);
    arguments.bvh = inside_->tree;
    arguments.primitives = inside_->prepared.data();
    arguments.primitiveCount = inside_->prepared.size();
    arguments.primitiveArrayCapacity = inside_->prepared.size();
    arguments.createNode = make_inner_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_boxes;
    arguments.createLeaf = make_leaf;
    arguments.userPtr = &tree;
    inside_->root = rtcBuildBVH(&arguments);
    if (inside_->root == nullptr) {
        throw MachineError("Embree built no tree: its error has the number " +
                           std::to_string(rtcGetDeviceError(inside_->device)) + ".");
    }
    return tree;
}

EmbreeNodes EmbreeBuilder::nodes() const {
    EmbreeNodes read;
    std::vector<const void*> places{inside_->root}; // of the nodes, which are read in this order
    read.nodes.emplace_back();
    for (std::size_t i = 0; i < places.size() && places[i] != nullptr; ++i) {
        if (const Leaf* const leaf = leaf_of(places[i])) {
            read.nodes[i].first = static_cast<std::int32_t>(read.triangles.size());
            read.nodes[i].count = static_cast<std::int32_t>(leaf->count);
            const auto* const own = reinterpret_cast<const unsigned*>(leaf + 1);
            read.triangles.insert(read.triangles.end(), own, own + leaf->count);
            continue;
        }
        const auto* const inner = static_cast<const InnerNode*>(places[i]);
        for (std::size_t side = 0; side < 2; ++side) {
            const RTCBounds& bounds = inner->boxes[side];
            EmbreeNode child;
            child.box = {{bounds.lower_x, bounds.lower_y, bounds.lower_z},
                         {bounds.upper_x, bounds.upper_y, bounds.upper_z}};
            read.nodes[i].children[side] = static_cast<std::int32_t>(places.size());
            places.push_back(inner->children[side]);
            read.nodes.push_back(child);
        }
    }
    Box& root = read.nodes.front().box;
    for (const RTCBuildPrimitive& triangle : inside_->triangles) {
        root = merge(root, glm::vec3(triangle.lower_x, triangle.lower_y, triangle.lower_z));
        root = merge(root, glm::vec3(triangle.upper_x, triangle.upper_y, triangle.upper_z));
    }
    return read;
}

} // namespace raysteps
