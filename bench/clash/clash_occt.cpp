// The way of ifcclash since 2023 (clash_collision_many in IfcOpenShell's IfcGeomTree.h), on the
// same trees of Open CASCADE: one of boxes over each set, in double; for a pair of parts whose
// boxes meet, their oriented boxes; then a linear BVH of each part's triangles, whose leaves that
// meet are compared triangle by triangle. IfcOpenShell itself is no Debian package. The test of two
// triangles is exact here, so that answers can be compared: it costs less than Moeller's with
// tolerances, which is what IfcOpenShell has.
#include "bench/clash/clash_peers.h"
#include "bench/peers/libraries/triangle_test.h"

#include <BVH_BoxSet.hxx>
#include <BVH_LinearBuilder.hxx>
#include <BVH_Triangulation.hxx>
#include <Bnd_OBB.hxx>
#include <TColgp_Array1OfPnt.hxx>

namespace soms::bench {

namespace {

using OcctTree = opencascade::handle<BVH_Tree<double, 3, BVH_BinaryTree>>;

bool apart(const BVH_Tree<double, 3, BVH_BinaryTree>& a, int i,
           const BVH_Tree<double, 3, BVH_BinaryTree>& b, int j) {
  const auto& a_low = a.MinPoint(i);
  const auto& a_high = a.MaxPoint(i);
  const auto& b_low = b.MinPoint(j);
  const auto& b_high = b.MaxPoint(j);
  return a_low.x() > b_high.x() || b_low.x() > a_high.x() || a_low.y() > b_high.y() ||
         b_low.y() > a_high.y() || a_low.z() > b_high.z() || b_low.z() > a_high.z();
}

/// Calls `leaf(i, j)` for leaves whose boxes meet, until it is true; true if it was.
template <class Leaf>
bool descend(const BVH_Tree<double, 3, BVH_BinaryTree>& a,
             const BVH_Tree<double, 3, BVH_BinaryTree>& b, Leaf&& leaf) {
  if (a.Length() == 0 || b.Length() == 0) {
    return false;
  }
  std::vector<std::pair<int, int>> stack{{0, 0}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    if (apart(a, i, b, j)) {
      continue;
    }
    if (a.IsOuter(i) && b.IsOuter(j)) {
      if (leaf(i, j)) {
        return true;
      }
    } else if (b.IsOuter(j) || (!a.IsOuter(i) && a.Level(i) <= b.Level(j))) {
      stack.emplace_back(a.Child<0>(i), j);
      stack.emplace_back(a.Child<1>(i), j);
    } else {
      stack.emplace_back(i, b.Child<0>(j));
      stack.emplace_back(i, b.Child<1>(j));
    }
  }
  return false;
}

struct OcctPart {
  explicit OcctPart(const FloatMesh& mesh) {
    BVH_Triangulation<double, 3> triangles(new BVH_LinearBuilder<double, 3>(
        BVH_Constants_LeafNodeSizeDefault, BVH_Constants_MaxTreeDepth));
    TColgp_Array1OfPnt points(1, static_cast<int>(mesh.vertices.size()));
    int number = 0;
    for (const auto& v : mesh.vertices) {
      triangles.Vertices.push_back(BVH_Vec3d(v[0], v[1], v[2]));
      points.SetValue(++number, gp_Pnt(v[0], v[1], v[2]));
    }
    number = 0;
    for (const auto& t : mesh.triangles) {
      triangles.Elements.push_back(BVH_Vec4i(static_cast<int>(t[0]), static_cast<int>(t[1]),
                                             static_cast<int>(t[2]), number++));
    }
    triangles.MarkDirty();
    tree = triangles.BVH();
    for (const auto& element : triangles.Elements) {
      corners.push_back(mesh.triangle(static_cast<std::size_t>(element[3])));
    }
    oriented.ReBuild(points);
  }

  OcctTree tree;
  std::vector<Triangle> corners;  ///< by the tree's order
  Bnd_OBB oriented;
};

class OcctClash final : public ClashPeer {
 public:
  OcctClash(std::span<const FloatMesh> a, std::span<const FloatMesh> b, const Loan& loan)
      : a_(a), b_(b), loan_(loan) {}

  void find(PartPairs& pairs) override {
    const OcctTree& of_a = a_.boxes.BVH();
    const OcctTree& of_b = b_.boxes.BVH();
    descend(*of_a, *of_b, [&](int i, int j) {
      for (int k = of_a->BegPrimitive(i); k <= of_a->EndPrimitive(i); ++k) {
        for (int l = of_b->BegPrimitive(j); l <= of_b->EndPrimitive(j); ++l) {
          const int a = a_.boxes.Element(k);
          const int b = b_.boxes.Element(l);
          if (!a_.boxes.Box(k).IsOut(b_.boxes.Box(l)) &&
              touch(a_.parts[static_cast<std::size_t>(a)], b_.parts[static_cast<std::size_t>(b)])) {
            pairs.emplace_back(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
          }
        }
      }
      return false;
    });
  }

 private:
  struct Set {
    explicit Set(std::span<const FloatMesh> meshes) {
      int number = 0;
      for (const FloatMesh& mesh : meshes) {
        parts.emplace_back(mesh);
        const OcctTree& tree = parts.back().tree;
        boxes.Add(number++, BVH_Box<double, 3>(tree->MinPoint(0), tree->MaxPoint(0)));
      }
      boxes.Build();
    }

    std::vector<OcctPart> parts;
    BVH_BoxSet<double, 3, int> boxes;
  };

  [[nodiscard]] bool touch(const OcctPart& a, const OcctPart& b) const {
    if (a.oriented.IsOut(b.oriented)) {
      return false;
    }
    return descend(*a.tree, *b.tree, [&](int i, int j) {
      for (int k = a.tree->BegPrimitive(i); k <= a.tree->EndPrimitive(i); ++k) {
        for (int l = b.tree->BegPrimitive(j); l <= b.tree->EndPrimitive(j); ++l) {
          if (triangles_touch(a.corners[static_cast<std::size_t>(k)],
                              b.corners[static_cast<std::size_t>(l)], loan_)) {
            return true;
          }
        }
      }
      return false;
    });
  }

  Set a_;
  Set b_;
  Loan loan_;
};

}  // namespace

void add_occt_clash(std::vector<ClashPeerMaker>& makers) {
  makers.push_back({"occt-lbvh",
                    [](std::span<const FloatMesh> a, std::span<const FloatMesh> b,
                       const Loan& loan) -> std::unique_ptr<ClashPeer> {
                      return std::make_unique<OcctClash>(a, b, loan);
                    }});
}

}  // namespace soms::bench
