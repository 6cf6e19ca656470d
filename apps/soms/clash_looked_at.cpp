#include "apps/soms/clash_looked_at.h"

#include "soms/clash/part_keys.h"

#include "apps/soms/clash_listed.h"
#include "apps/soms/clash_rows.h"

namespace soms::command {

LookedAt::LookedAt(const ClashModels& models, const ClashSetOptions& sets,
                   const std::optional<double>& within)
    : models_(models), sets_(sets), within_(within) {
  if (!sets.between.empty()) {
    of_a_ = numbers_of(models.a);
    of_b_ = models.two_sets ? numbers_of(models.b) : of_a_;
  }
}

LookedAt::Numbers LookedAt::numbers_of(const ClashSet& set) {
  Numbers numbers;
  for (std::uint32_t part = 0; part < set.parts.size(); ++part) {
    numbers[side_mark(clash_side(set, part))].push_back(part);
  }
  return numbers;
}

bool LookedAt::is_left_out(const Json& row) const {
  const auto sides = [&](const Numbers& numbers, const char* side) {
    const auto found = row.contains(side) && row[side].is_object()
                           ? numbers.find(side_mark(row[side]))
                           : numbers.end();
    return found == numbers.end() ? std::vector<std::uint32_t>() : found->second;
  };
  const std::string key = row.value("key", "");
  // Sides may have been named in the other order.
  for (const auto& [first, second] : {std::pair("a", "b"), std::pair("b", "a")}) {
    for (const std::uint32_t a : sides(of_a_, first)) {
      for (const std::uint32_t b : sides(of_b_, second)) {
        if (!are_compared(sets_, models_, a, b) &&
            key_text(clash_key(models_.a.keys[a], models_.second().keys[b])) == key) {
          return true;
        }
      }
    }
  }
  return false;
}

bool LookedAt::operator()(const Json& row) const {
  if (row.value("class", "") == clash_name(ClashKind::near)) {
    const Json gap = row.value("gap", Json());
    const bool is_known = gap.is_array() && !gap.empty() && gap.front().is_number();
    if (!within_ || (is_known && gap.front().get<double>() > *within_)) {
      return false;
    }
  }
  return !is_left_out(row);
}

}  // namespace soms::command
