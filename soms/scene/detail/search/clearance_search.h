/// \file
/// The search behind `clearance_along`: stations, the stretches between them, and their halves.
#pragma once

#include "soms/scene/clearance_along.h"
#include "soms/scene/detail/motion_segment.h"

#include <cstddef>
#include <span>
#include <vector>

namespace soms::detail {

/// Where a query is made: a part of a segment of the path.
struct PathPlace {
  std::size_t segment = 0;
  double t = 0;
  double chainage = 0;
};

/// The stations of a path. \errors ErrorKind::usage if there are too many.
[[nodiscard]] std::vector<PathPlace> stations_of(const MotionPath& path, double every);

/// Queries places of a path, and halves what lies between them.
class ClearanceSearch {
 public:
  /// All must stay.
  ClearanceSearch(const Shape& mover, const MotionPath& path, std::span<const Body> fixed,
                  const ClearanceOptions& options, const Limits& limits)
      : mover_(mover),
        bounds_(mover.bounds().empty() ? Box{{0, 0, 0}, {0, 0, 0}} : mover.bounds()),
        path_(path),
        fixed_(fixed),
        options_(options),
        limits_(limits) {}

  [[nodiscard]] Clearance run();

 private:
  /// A place that was queried.
  struct Sample {
    double t = 0;
    Quaternion turn{1, 0, 0, 0};
    double slack = 0;
    Bracket gap;

    [[nodiscard]] MotionPlace place() const { return {t, {}, turn, slack}; }
  };

  /// What is proved between two samples.
  struct Leaf {
    double at_least = 0;
    double at_most = 0;
    double motion = 0;
  };

  struct Stretch {
    std::size_t segment = 0;
    std::vector<Sample> samples = {};
    std::vector<Leaf> leaves = {};  ///< one less
    ClearanceStation least = {};
  };

  /// A leaf that is to be halved.
  struct Half {
    std::size_t stretch = 0;
    std::size_t leaf = 0;
    PathPlace place;
  };

  [[nodiscard]] bool query(std::span<const PathPlace> places, double from, double to,
                           std::vector<ClearanceStation>& found);
  [[nodiscard]] ClearanceStation query_at(const PathPlace& place, const StopToken& stop,
                                          Cost& cost) const;
  [[nodiscard]] Leaf leaf_between(std::size_t segment, const Sample& a, const Sample& b) const;
  void begin_stretches(const std::vector<ClearanceStation>& stations);
  [[nodiscard]] bool is_open(const Leaf& leaf, const Stretch& stretch, double least,
                             bool before_contact) const;
  [[nodiscard]] std::vector<Half> open_leaves() const;
  void insert(std::span<const Half> halves, std::span<const ClearanceStation> found);
  void report(Clearance& answer) const;
  void report_contact(Clearance& answer) const;

  const Shape& mover_;
  Box bounds_;
  const MotionPath& path_;
  std::span<const Body> fixed_;
  const ClearanceOptions& options_;
  const Limits& limits_;
  std::vector<Stretch> stretches_;
  Cost cost_;
  bool cut_ = false;
};

}  // namespace soms::detail
