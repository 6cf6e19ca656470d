/// \file
/// Values under numbers that are given once and never again.
#pragma once

#include "soms/base/error.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace soms::detail {

/// Values in the order of their ids. Ids ascend and are never reused. A removed value is destroyed
/// at once; its place is taken back when half of the places are empty, so memory and work stay in
/// proportion to the values that are there, however many came and went.
template <typename Value>
class IdList {
 public:
  using Id = std::uint32_t;

  /// A value, or the empty place that one left.
  struct Place {
    Id id = 0;
    bool live = true;
    Value value;
  };

  /// `what` names the values in messages: "mover".
  explicit IdList(std::string what) : what_(std::move(what)) {}

  /// \errors ErrorKind::out_of_range after 2^32 - 1 values.
  Id add(Value value) {
    if (next_ == std::numeric_limits<Id>::max()) {
      throw Error(ErrorKind::out_of_range, "scene: no numbers are left for another " + what_,
                  "create a new scene");
    }
    places_.push_back({next_, true, std::move(value)});
    return next_++;
  }

  /// \pre `id` is there.
  void remove(Id id) {
    Place& place = *find(id);
    Value none{};  // may throw, and then nothing is changed
    place.value = std::move(none);
    place.live = false;
    ++empty_;
    if (2 * empty_ > places_.size()) {
      std::erase_if(places_, [](const Place& p) { return !p.live; });
      places_.shrink_to_fit();
      empty_ = 0;
    }
  }

  [[nodiscard]] bool contains(Id id) const { return find_const(id) != nullptr; }

  /// \errors ErrorKind::usage for an id that is not there.
  [[nodiscard]] const Value& at(Id id) const {
    const Place* place = find_const(id);
    if (place == nullptr) {
      throw Error(ErrorKind::usage, "scene: there is no " + what_ + " " + std::to_string(id),
                  id < next_ ? "it was removed; numbers are not reused"
                             : "use a number that the scene returned when it was added");
    }
    return place->value;
  }

  [[nodiscard]] Value& at(Id id) { return const_cast<Value&>(std::as_const(*this).at(id)); }

  /// Where in `places` a value lies. \pre `id` is there.
  [[nodiscard]] std::uint32_t place_of(Id id) const {
    return static_cast<std::uint32_t>(find_const(id) - places_.data());
  }

  /// Ascending by id; some may be empty places.
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }

  [[nodiscard]] std::vector<Id> ids() const {
    std::vector<Id> ids;
    ids.reserve(places_.size() - empty_);
    for (const Place& place : places_) {
      if (place.live) {
        ids.push_back(place.id);
      }
    }
    return ids;
  }

 private:
  [[nodiscard]] const Place* find_const(Id id) const {
    // Where no place was taken back, the id is the place.
    if (id < places_.size() && places_[id].id == id) {
      return places_[id].live ? &places_[id] : nullptr;
    }
    const auto at = std::lower_bound(places_.begin(), places_.end(), id,
                                     [](const Place& place, Id value) { return place.id < value; });
    return at != places_.end() && at->id == id && at->live ? &*at : nullptr;
  }

  [[nodiscard]] Place* find(Id id) { return const_cast<Place*>(find_const(id)); }

  std::string what_;
  std::vector<Place> places_;
  std::size_t empty_ = 0;
  Id next_ = 0;
};

}  // namespace soms::detail
