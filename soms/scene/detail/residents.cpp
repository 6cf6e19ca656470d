#include "soms/scene/detail/residents.h"

#include "soms/base/error.h"
#include "soms/motion/detail/moved_bounds.h"
#include "soms/scene/detail/kept_memory.h"

#include <algorithm>
#include <string>

namespace soms::detail {

namespace {

/// Least bytes that a list of ignored bodies gives back: there may be many lists.
constexpr std::size_t kLeastOfAList = 64;

void insert(std::vector<std::uint32_t>& sorted, std::uint32_t id) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), id);
  if (at == sorted.end() || *at != id) {
    sorted.insert(at, id);
  }
}

}  // namespace

std::size_t memory_of(const Residents& residents) {
  std::size_t size = bytes(residents.places());
  for (const auto& place : residents.places()) {
    size += bytes(place.value.ignored_movers) + bytes(place.value.ignored_others);
  }
  return size;
}

void collect_boxes(const Residents& residents, std::vector<Box>& boxes) {
  boxes.clear();
  for (const auto& resident : residents.places()) {
    boxes.push_back(resident.value.box);
  }
}

Box world_box(const Body& body, const Shape& shape, const Pose& pose, std::string_view what,
              std::optional<std::uint32_t> id) {
  try {
    check(pose);
    check_range(pose, shape.bounds());
  } catch (const Error& error) {
    std::string subject(what);
    if (id) {
      subject += " " + std::to_string(*id);
    }
    if (!body.name.empty()) {
      subject += " (" + body.name + ")";
    }
    throw Error(error.kind(), subject + ": " + error.place(), error.remedy());
  }
  return moved_bounds(pose, shape.bounds());
}

bool holds(const std::vector<std::uint32_t>& sorted, std::uint32_t id) {
  return std::binary_search(sorted.begin(), sorted.end(), id);
}

bool insert_mutually(std::vector<std::uint32_t>& list_a, std::uint32_t b,
                     std::vector<std::uint32_t>& list_b, std::uint32_t a) {
  if (holds(list_a, b)) {
    return false;
  }
  const auto make_room = [](std::vector<std::uint32_t>& list) {
    if (list.size() == list.capacity()) {
      list.reserve(2 * list.size() + 1);
    }
  };
  make_room(list_a);
  make_room(list_b);
  insert(list_a, b);
  insert(list_b, a);
  return true;
}

bool erase(std::vector<std::uint32_t>& sorted, std::uint32_t id) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), id);
  if (at == sorted.end() || *at != id) {
    return false;
  }
  sorted.erase(at);
  give_back(sorted, sorted.size(), kLeastOfAList);
  return true;
}

}  // namespace soms::detail
