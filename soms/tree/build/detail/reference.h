/// \file
/// Triangles as boxes in float, and how a run of them is divided in two.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/build/detail/build_lanes.h"
#include "soms/tree/build_options.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// A triangle's box, relative to a place and in a unit near the size of what is divided: good for
/// choosing splits, never for bounds.
struct alignas(32) Reference {
  std::array<float, 3> middle;
  TriangleId id;
  std::array<float, 3> half;
  float zero = 0;

  /// Lane 3 is 0: an id would be a subnormal number there, and slow to add.
  [[nodiscard]] lanes::F4 point() const { return lanes::first_three(lanes::load(this)); }

  [[nodiscard]] lanes::F4 half_extent() const { return lanes::load(half.data()); }
};

static_assert(sizeof(Reference) == 32);

/// Place and unit of references.
struct PrimitiveFrame {
  Vec3 origin;
  double scale = 1;
};

/// The frame in which a box fills the cube from -1 to 1.
[[nodiscard]] PrimitiveFrame frame_of(const Box& box);

[[nodiscard]] Reference reference_of(const MeshView& mesh, TriangleId id,
                                     const PrimitiveFrame& frame);

/// A run of references: their number, the box of their middles and their widest halves.
struct PrimitiveRange {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  lanes::Box4 middles;
  lanes::F4 widest = lanes::splat(0);

  void add(const Reference& r) {
    middles.grow(r.point());
    widest = lanes::max(widest, r.half_extent());
    ++count;
  }
};

/// Two runs that make up a third; `even` if all middles were one point and the run was halved.
struct Halves {
  PrimitiveRange left;
  PrimitiveRange right;
  bool even = false;
};

/// Divides runs of references in place; the order on both sides is kept.
class ReferenceDivider {
 public:
  /// Nodes with at most this many triangles are divided between any two of them.
  static constexpr std::uint32_t kSweep = 16;

  explicit ReferenceDivider(const BuildOptions& options);

  /// \pre At least two references.
  [[nodiscard]] Halves divide(std::span<Reference> all, const PrimitiveRange& run);

  /// The same by the instructions that every processor has.
  [[nodiscard]] Halves divide_plainly(std::span<Reference> all, const PrimitiveRange& run);

  /// Equal counts as they lie, where nothing else may be done.
  [[nodiscard]] static Halves halve(std::span<const Reference> all, const PrimitiveRange& run);

 private:
  static constexpr std::size_t kMostBins = 32;

  struct Bin {
    lanes::Box4 box;
    std::uint32_t count = 0;
  };

  struct Plane {
    std::size_t axis = 0;
    float value = 0;
    bool found = false;
  };

  /// \tparam Lanes what keys are compared by
  template <class Lanes>
  [[nodiscard, gnu::always_inline]] inline Halves divide_by(std::span<Reference> all,
                                                            const PrimitiveRange& run);
  [[nodiscard]] Halves divide_by_avx2(std::span<Reference> all, const PrimitiveRange& run);
  [[nodiscard, gnu::always_inline]] inline Plane cheapest_plane(std::span<const Reference> run,
                                                                const PrimitiveRange& range);
  [[nodiscard, gnu::always_inline]] inline Halves cut(std::span<Reference> all,
                                                      const PrimitiveRange& run,
                                                      const Plane& plane);
  template <class Lanes>
  [[nodiscard, gnu::always_inline]] inline Halves sweep(std::span<Reference> all,
                                                        const PrimitiveRange& run);

  std::uint32_t per_leaf_;
  bool quality_;
  std::array<float, kSweep + 1> blocks_ = {};  ///< that so many triangles fill
  std::array<std::array<Bin, kMostBins>, 3> bins_;
  std::vector<Reference> right_;
};

}  // namespace soms::detail
