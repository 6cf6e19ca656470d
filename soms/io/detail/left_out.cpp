#include "soms/io/detail/left_out.h"

#include <algorithm>
#include <cstddef>

namespace soms::detail {

std::string LeftOut::note(std::string_view what) const {
  return std::string(what) + ": " + std::to_string(count_) + (count_ > 1 ? ", the first " : ", ") +
         place_;
}

void add_note(std::vector<std::string>& notes, const LeftOut& left_out, std::string_view what) {
  if (left_out.count() > 0) {
    notes.push_back(left_out.note(what));
  }
}

std::string joined(std::span<const std::string> notes) {
  constexpr std::size_t kMostShown = 8;
  std::string all;
  for (std::size_t i = 0; i < std::min(notes.size(), kMostShown); ++i) {
    all += (i == 0 ? "" : "; ") + notes[i];
  }
  if (notes.size() > kMostShown) {
    all += "; and " + std::to_string(notes.size() - kMostShown) + " more notes";
  }
  return all;
}

}  // namespace soms::detail
