#include "apps/soms/clash/clash_looked_at.h"

#include "soms/clash/part_keys.h"

#include "apps/soms/clash/clash_rows.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace soms::command {

LookedAt::LookedAt(const ClashModels& models, const ClashSetOptions& sets,
                   const std::optional<double>& within)
    : models_(models), sets_(sets), within_(within) {
  if (!sets.between.empty()) {
    of_a_ = marked_parts(models.a);
    of_b_ = models.two_sets ? marked_parts(models.b) : of_a_;
  }
}

bool LookedAt::is_left_out(const Json& row) const {
  const auto sides = [&](const MarkedParts& parts, const char* side) {
    const auto found = row.contains(side) && row[side].is_object()
                           ? parts.find(side_mark(row[side]))
                           : parts.end();
    return found == parts.end() ? std::vector<std::uint32_t>() : found->second;
  };
  const std::string key = text_of(row, "key");
  // A row of bodies, one of which may be inside the other, was looked for if these were compared.
  const bool may_be_of_bodies =
      text_of(row, "class") == name(ClashKind::undecided) && text_of(row, "triangle_pairs") == "0";
  const auto were_compared = [&](std::uint32_t a, std::uint32_t b) {
    return may_be_of_bodies ? bodies_are_compared(sets_, models_, a, b)
                            : are_compared(sets_, models_, a, b);
  };
  // Sides may have been named in the other order.
  for (const auto& [first, second] : {std::pair("a", "b"), std::pair("b", "a")}) {
    for (const std::uint32_t a : sides(of_a_, first)) {
      for (const std::uint32_t b : sides(of_b_, second)) {
        if (!were_compared(a, b) &&
            key_text(clash_key(models_.a.keys[a], models_.second().keys[b])) == key) {
          return true;
        }
      }
    }
  }
  return false;
}

bool LookedAt::operator()(const Json& row) const {
  if (text_of(row, "class") == name(ClashKind::near)) {
    const auto gap = row.find("gap");
    const bool is_known =
        gap != row.end() && gap->is_array() && !gap->empty() && gap->front().is_number();
    if (!within_ || (is_known && gap->front().get<double>() > *within_)) {
      return false;
    }
  }
  return !is_left_out(row);
}

}  // namespace soms::command
