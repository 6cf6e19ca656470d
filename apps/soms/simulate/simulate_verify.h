/// \file
/// A second opinion on a simulation: brute force, without a tree or a broad phase.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/random.h"
#include "soms/scene/scene.h"

#include "apps/world/world.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace soms::command {

/// What brute force said to a simulation's answers.
struct Verified {
  std::uint64_t contacts = 0;  ///< touching pairs of bodies, in a frame: all their triangle pairs
  std::uint64_t free = 0;      ///< movers in a frame that touch nothing
  /// Touching pairs, and movers, where brute force found another answer.
  std::uint64_t wrong = 0;
};

/// Checks every touching pair of every frame, and every mover that touches something and some that
/// touch nothing against all there is: a linear scan over all triangles with a closed box reject,
/// then soms::reference.
class Verifier {
 public:
  Verifier(const World& world, std::uint64_t seed);

  /// \errors ErrorKind::cancelled; the result is that of the frames before then.
  void verify(const StepReport& report, const std::vector<Pose>& poses, const Limits& limits);

  [[nodiscard]] const Verified& result() const { return result_; }

 private:
  /// Boxes of all triangles of a body of the city, by coordinate.
  struct Boxes {
    std::array<std::vector<double>, 3> lower;
    std::array<std::vector<double>, 3> upper;
  };

  /// A mover in question, with what was said of it.
  struct Subject {
    MoverId mover = 0;
    Box box;
    std::vector<EnvironmentContact> said = {};
    bool touches_movers = false;
    bool right = true;
  };

  /// Pairs of movers that touch, the lesser first; sorted.
  using MoverPairs = std::vector<std::pair<MoverId, MoverId>>;

  [[nodiscard]] std::vector<Subject> choose(const StepReport& report,
                                            const std::vector<Pose>& poses);
  void compare(const StepReport& report, const std::vector<Pose>& poses, const Limits& limits);
  void scan_city(std::span<Subject> subjects, const std::vector<Pose>& poses,
                 const Limits& alone) const;
  void verify_movers(const StepReport& report, const std::vector<Pose>& poses,
                     const Limits& limits);
  [[nodiscard]] bool touches_unsaid(const Subject& subject, const MoverPairs& said,
                                    const std::vector<Pose>& poses, const Limits& alone) const;
  [[nodiscard]] std::vector<TrianglePair> pairs_of(MoverId a, MoverId b,
                                                   const std::vector<Pose>& poses,
                                                   const Limits& alone) const;
  [[nodiscard]] bool far_apart(MoverId a, MoverId b, const std::vector<Pose>& poses) const;
  [[nodiscard]] Box moved_box(MoverId mover, const std::vector<Pose>& poses) const;
  [[nodiscard]] const MeshView& mesh(MoverId mover) const;

  const World& world_;
  Rng rng_;
  std::vector<Boxes> boxes_;
  Verified result_;
};

}  // namespace soms::command
