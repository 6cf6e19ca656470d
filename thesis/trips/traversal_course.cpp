#include "thesis/trips/traversal_course.h"

#include "soms/thesis/traversals.h"
#include "soms/tree/build.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace soms::reproduce {

namespace {

/// Right triangles of a size with their right angles at points of the plane.
Mesh toy(const std::vector<Vec3>& corners, double size) {
  Mesh mesh;
  for (const Vec3& corner : corners) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {corner, corner + Vec3{size, 0, 0}, corner + Vec3{0, size, 0}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

class Recorder {
 public:
  explicit Recorder(const ToyPair& toy) : toy_(toy) {}

  Course record(const std::string& name, const TraversalOptions& options) {
    Course course{.name = name};
    TraversalVisitor visitor;
    visitor.tested = [&](NodePair p, bool overlap) {
      Story& story = at(course, p);
      story.tested = ++tests_;
      story.overlap = overlap;
      course.events.push_back({"test", p, overlap ? "overlap" : "apart"});
    };
    visitor.entered = [&](NodePair p) {
      at(course, p).entered = ++entries_;
      course.events.push_back({"enter", p, ""});
    };
    visitor.leaf_pair = [&](NodePair p) {
      at(course, p).reported = ++reports_;
      course.events.push_back({"report", p, fmt::format("after {} tests", tests_)});
      return true;
    };
    course.counts = traverse(toy_.boxes_a.view(), toy_.boxes_b.view(), options, visitor);
    for (Story& story : course.stories) {
      story.parent = index_.at(key(parent(story.pair)));
    }
    return course;
  }

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;

  static Key key(NodePair p) { return {p.a, p.b}; }

  Story& at(Course& course, NodePair p) {
    const auto [place, added] = index_.try_emplace(key(p), course.stories.size());
    if (added) {
      course.stories.push_back({p});
    }
    return course.stories[place->second];
  }

  /// Index of the parent of a node at the deeper side, else the node itself.
  static std::uint32_t up(const Tree& tree, std::uint32_t node) {
    const TreeId id = parent_of(tree.nodes[node].id);
    return id == kNoTreeId ? node
                           : static_cast<std::uint32_t>(find_node(tree, id) - tree.nodes.data());
  }

  [[nodiscard]] NodePair parent(NodePair p) const {
    const std::uint32_t depth_a = toy_.tree_a.nodes[p.a].depth;
    const std::uint32_t depth_b = toy_.tree_b.nodes[p.b].depth;
    return {depth_a >= depth_b ? up(toy_.tree_a, p.a) : p.a,
            depth_b >= depth_a ? up(toy_.tree_b, p.b) : p.b};
  }

  const ToyPair& toy_;
  std::map<Key, std::size_t> index_;
  std::size_t tests_ = 0;
  std::size_t entries_ = 0;
  std::size_t reports_ = 0;
};

}  // namespace

ToyPair::ToyPair()
    : mesh_a(toy({{0, 0, 0}, {0.4, 2.6, 0}, {3.2, 2.2, 0}, {4, 0.4, 0}}, 1.6)),
      mesh_b(toy({{4.6, 1.2, 0}, {4.3, 3.2, 0}, {7.4, 3.6, 0}, {7.8, 0.6, 0}}, 1.6)),
      tree_a(build(mesh_a, thesis_options(Rule::soms))),
      tree_b(build(mesh_b, thesis_options(Rule::soms))),
      boxes_a(mesh_a, tree_a),
      boxes_b(mesh_b, tree_b) {
  boxes_a.move(Pose::identity());
  boxes_b.move(Pose::identity());
}

Course record(const ToyPair& toy, const std::string& name, const TraversalOptions& options) {
  return Recorder(toy).record(name, options);
}

std::string pair_words(const ToyPair& toy, NodePair p) {
  return fmt::format("{}|{}", toy.tree_a.nodes[p.a].id, toy.tree_b.nodes[p.b].id);
}

}  // namespace soms::reproduce
