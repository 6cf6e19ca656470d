#include "apps/soms/map_marks.h"

#include "soms/base/text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace soms::command {

namespace {

std::string touched_name(const World& world, const Contact& contact) {
  if (contact.part == Contact::kMover) {
    const auto name = [&](MoverId mover) { return world.models[world.ways[mover].model].name; };
    return name(contact.mover) + " and " + name(contact.other);
  }
  const Body& body = world.city[contact.part];
  const std::string part = part_name(world, contact.part, contact.other);
  // Without parts the triangle says more than the city's name.
  return part == body.name ? "triangle " + std::to_string(contact.other) : part;
}

/// What the contacts of one square sum up to.
struct Square {
  double x = 0;
  double y = 0;
  std::uint64_t contacts = 0;
  std::map<std::pair<EnvironmentId, std::uint32_t>, std::pair<std::uint64_t, const Contact*>> what;
};

}  // namespace

std::vector<Mark> find_marks(const World& world, const Outcome& outcome, double cell) {
  std::map<std::pair<std::int64_t, std::int64_t>, Square> squares;
  for (const Contact& contact : outcome.contacts.contacts()) {
    const Way& way = world.ways[contact.mover];
    const Vec3 at = way.at(contact.begin).apply(world.models[way.model].foot);
    Square& square = squares[{static_cast<std::int64_t>(std::floor(at.x / cell)),
                              static_cast<std::int64_t>(std::floor(at.y / cell))}];
    square.x += at.x;
    square.y += at.y;
    ++square.contacts;
    // Between movers all count as one kind; triangles count by the part they belong to.
    std::uint32_t key = 0;
    if (contact.part != Contact::kMover) {
      const Mesh& mesh = world.city[contact.part].shape.mesh();
      key = part_of(mesh, contact.other);
      key = key == Part::kNoParent ? contact.other : key;
    }
    auto& [count, example] = square.what[{contact.part, key}];
    ++count;
    example = example == nullptr ? &contact : example;
  }
  std::vector<Mark> marks;
  for (const auto& [place, square] : squares) {
    const auto most = std::max_element(
        square.what.begin(), square.what.end(),
        [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
    const auto count = static_cast<double>(square.contacts);
    marks.push_back({square.x / count, square.y / count, square.contacts,
                     touched_name(world, *most->second.second)});
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return a.contacts > b.contacts; });
  return marks;
}

double mark_radius(std::uint64_t contacts) {
  return std::min(2.2 + 0.9 * std::sqrt(static_cast<double>(contacts)), 13.0);
}

double round_length(double meters) {
  const double power = std::pow(10, std::floor(std::log10(meters)));
  const double digits = meters / power;
  return power * (digits >= 5 ? 5 : digits >= 2 ? 2 : 1);
}

std::string shortened(std::string_view words, std::size_t most) {
  if (words.size() <= most) {
    return std::string(words);
  }
  std::size_t end = 0;
  for (std::size_t size = 1; end < words.size() && size > 0 && end + size <= most; end += size) {
    size = std::max<std::size_t>(1, utf8_character(words, end));
    if (end + size > most) {
      break;
    }
  }
  return std::string(words.substr(0, end)) + "...";
}

}  // namespace soms::command
