/// \file
/// What a reader leaves out of a file: how much of it there is, and where it begins.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// Things of one kind that are in the file and not in the mesh.
class LeftOut {
 public:
  /// `count` more. `place()` says where ("in line 7"); it is called for the first only.
  template <class Place>
  void add(const Place& place, std::uint64_t count = 1) {
    if (count_ == 0 && count > 0) {
      place_ = place();
    }
    count_ += count;
  }

  /// What was left out elsewhere, later in the file.
  void add(const LeftOut& more) {
    add([&] { return more.place_; }, more.count_);
  }

  [[nodiscard]] std::uint64_t count() const { return count_; }

  /// The note: "WHAT: 3, the first in line 7". \pre count() > 0.
  [[nodiscard]] std::string note(std::string_view what) const;

 private:
  std::uint64_t count_ = 0;
  std::string place_;
};

/// Adds the note of what was left out, if there is any.
void add_note(std::vector<std::string>& notes, const LeftOut& left_out, std::string_view what);

/// Notes as one text: the first eight, and how many more there are.
[[nodiscard]] std::string joined(std::span<const std::string> notes);

}  // namespace soms::detail
