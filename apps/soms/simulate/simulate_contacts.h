/// \file
/// Contacts over frames: when each begins and ends, and what is touched most.
#pragma once

#include "soms/scene/scene.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace soms::command {

/// A mover touches a triangle of the city, or another mover, in each frame from `begin` to `end`.
struct Contact {
  static constexpr std::uint32_t kMover = 0xffffffffU;

  MoverId mover = 0;
  /// Body of the city; `kMover` when another mover is touched.
  EnvironmentId part = 0;
  /// Triangle of that body, or number of the other mover (greater than `mover`).
  std::uint32_t other = 0;
  std::uint64_t begin = 0;
  std::uint64_t end = 0;

  [[nodiscard]] bool same_touch(const Contact& c) const {
    return mover == c.mover && part == c.part && other == c.other;
  }

  [[nodiscard]] bool touches_less(const Contact& c) const {
    return mover != c.mover ? mover < c.mover : part != c.part ? part < c.part : other < c.other;
  }
};

/// How often a triangle of the city was touched.
struct Touched {
  EnvironmentId part = 0;
  TriangleId triangle = 0;
  std::uint64_t frames = 0;    ///< summed over movers
  std::uint64_t contacts = 0;  ///< begins
  MoverId mover = 0;           ///< the first to touch it, in frame `begin`
  std::uint64_t begin = 0;
};

/// Follows contacts from frame to frame.
class ContactLog {
 public:
  /// Adds the report of the next frame. \pre Its lists are sorted, as a step's are.
  void add(const StepReport& report, std::uint64_t frame);

  /// Ends what still lasts.
  void finish();

  /// All contacts, by begin, then mover, then what is touched; complete after `finish`.
  [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }

  [[nodiscard]] std::uint64_t between_movers() const { return between_movers_; }

  /// Movers that touched anything.
  [[nodiscard]] std::uint64_t movers() const;

  /// The `n` triangles of the city that were touched in most frames; ties by part and triangle.
  [[nodiscard]] std::vector<Touched> most_touched(std::size_t n) const;

 private:
  void begin(const Contact& contact);
  void follow(std::vector<Contact>& now, std::uint64_t frame);

  std::vector<Contact> contacts_;
  std::vector<Contact> lasting_;       ///< of the frame before, sorted by what is touched
  std::vector<Contact> now_;           ///< scratch
  std::vector<TriangleId> triangles_;  ///< scratch
  std::unordered_map<std::uint64_t, Touched> touched_;
  std::uint64_t between_movers_ = 0;
};

}  // namespace soms::command
