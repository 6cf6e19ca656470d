/// \file
/// What takes part in a comparison: a library that is asked whether two posed meshes touch.
#pragma once

#include "soms/base/pose.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace soms::bench {

/// The meshes of all comparisons: float vertices, so that no contestant has to round them.
struct FloatMesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Two bodies, ready to be asked about.
class Match {
 public:
  virtual ~Match() = default;

  /// Does the mover at each pose share a point with the body that stands still? 1 for yes.
  virtual void any(std::span<const Pose> poses, std::span<std::uint8_t> touches) = 0;
};

/// A library, or one way to use it.
class Contestant {
 public:
  virtual ~Contestant() = default;

  [[nodiscard]] virtual std::string name() const = 0;

  /// Builds all that queries need, own copies of the meshes included.
  [[nodiscard]] virtual std::unique_ptr<Match> prepare(const FloatMesh& mover,
                                                       const FloatMesh& fixed) const = 0;
};

using Roster = std::vector<std::unique_ptr<Contestant>>;

/// Adds soms, asked pose by pose and in one batch.
void add_soms(Roster& roster);

}  // namespace soms::bench

/// Adds FCL's oriented boxes, alone and with swept spheres, in float: its fastest models.
extern "C" void soms_bench_fcl(soms::bench::Roster& roster);
