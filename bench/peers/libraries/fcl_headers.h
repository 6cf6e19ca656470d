/// \file
/// FCL 0.7 from its headers alone, compiled with the flags of the file that includes this.
///
/// The headers declare the double templates `extern`, so that calls would go to the packaged
/// library, which is compiled for plain x86-64 and with another alignment of Eigen's types than
/// -march=native gives. FCL's headers are therefore read with `extern` blanked: declarations become
/// instantiations of this file. All that needs a true `extern` is included before.
#pragma once

#include <Eigen/Dense>
#include <Eigen/StdVector>
#include <ccd/ccd.h>
#include <ccd/quat.h>
#include <ccd/vec3.h>
#include <octomap/octomap.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdarg>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <queue>
#include <random>
#include <set>
#include <span>
#include <sstream>
#include <stack>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <vector>

// clang-format off: utility.h must come before BVH_model.h, which uses its fit().
#define extern
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/math/bv/utility.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>
#include <fcl/narrowphase/detail/traversal/distance/mesh_distance_traversal_node.h>
#undef extern

// clang-format on

// The few small members that FCL keeps in its library, so that no call leaves this file.
namespace fcl {

inline Triangle::Triangle() {
}

inline Triangle::Triangle(std::size_t a, std::size_t b, std::size_t c) : vids{a, b, c} {
}

inline void Triangle::set(std::size_t a, std::size_t b, std::size_t c) {
  vids[0] = a;
  vids[1] = b;
  vids[2] = c;
}

inline std::size_t Triangle::operator[](int i) const {
  return vids[i];
}

inline std::size_t& Triangle::operator[](int i) {
  return vids[i];
}

inline bool BVNodeBase::isLeaf() const {
  return first_child < 0;
}

inline int BVNodeBase::primitiveId() const {
  return -(first_child + 1);
}

inline int BVNodeBase::leftChild() const {
  return first_child;
}

inline int BVNodeBase::rightChild() const {
  return first_child + 1;
}

namespace detail {

inline BVHFrontNode::BVHFrontNode(int left_, int right_) : left(left_), right(right_), valid(true) {
}

/// Spreads the lowest `bits` bits of x to every third place.
inline std::uint64_t spread_bits(std::uint64_t x, unsigned bits) {
  std::uint64_t spread = 0;
  for (unsigned i = 0; i < bits; ++i) {
    spread |= ((x >> i) & 1U) << (3 * i);
  }
  return spread;
}

inline uint32 morton_code(uint32 x, uint32 y, uint32 z) {
  return static_cast<uint32>(spread_bits(x, 10) | spread_bits(y, 10) << 1 |
                             spread_bits(z, 10) << 2);
}

inline uint64 morton_code60(uint32 x, uint32 y, uint32 z) {
  return spread_bits(x, 20) | spread_bits(y, 20) << 1 | spread_bits(z, 20) << 2;
}

// No query here keeps a front list; the null check must stay.
inline void updateFrontList(BVHFrontList* list, int a, int b) {
  if (list != nullptr) {
    list->emplace_back(a, b);
  }
}

}  // namespace detail

}  // namespace fcl
