#include "apps/soms/simulate/map_marks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace soms::command {

namespace {

/// "1-3, 5" of increasing numbers.
std::string runs_of(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t last = k;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) {
      ++last;
    }
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[k]);
    if (last > k) {
      text += (last == k + 1 ? ", " : "-") + std::to_string(numbers[last]);
    }
    k = last + 1;
  }
  return text;
}

/// What the contacts of one square sum up to.
struct Square {
  double x = 0;
  double y = 0;
  std::uint64_t contacts = 0;
};

}  // namespace

std::vector<Mark> find_marks(const World& world, const Outcome& outcome, double cell) {
  std::map<std::pair<std::int64_t, std::int64_t>, Square> squares;
  for (const Contact& contact : outcome.contacts.contacts()) {
    const MoverRoute& mover_route = world.routes[contact.mover];
    const Vec3 at = mover_route.at(contact.begin).apply(world.models[mover_route.model].foot);
    Square& square = squares[{static_cast<std::int64_t>(std::floor(at.x / cell)),
                              static_cast<std::int64_t>(std::floor(at.y / cell))}];
    square.x += at.x;
    square.y += at.y;
    ++square.contacts;
  }
  std::vector<Mark> marks;
  for (const auto& [place, square] : squares) {
    const auto count = static_cast<double>(square.contacts);
    marks.push_back({square.x / count, square.y / count, square.contacts});
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return a.contacts > b.contacts; });
  return marks;
}

double mark_radius(std::uint64_t contacts) {
  return std::min(2.2 + 0.9 * std::sqrt(static_cast<double>(contacts)), 13.0);
}

std::vector<NumberedPlace> numbered_places(const std::vector<Label>& places, double apart) {
  std::vector<Label> firsts;
  std::vector<std::vector<std::size_t>> numbers;
  for (std::size_t k = 0; k < places.size(); ++k) {
    std::size_t at = 0;
    while (at < firsts.size() &&
           std::hypot(firsts[at].x - places[k].x, firsts[at].y - places[k].y) >= apart) {
      ++at;
    }
    if (at == firsts.size()) {
      firsts.push_back(places[k]);
      numbers.emplace_back();
    }
    numbers[at].push_back(k + 1);
  }
  std::vector<NumberedPlace> numbered;
  for (std::size_t k = 0; k < firsts.size(); ++k) {
    numbered.push_back({firsts[k], runs_of(numbers[k])});
  }
  return numbered;
}

std::vector<std::size_t> labels_with_room(const std::vector<Label>& labels,
                                          const std::vector<Label>& taken, double width,
                                          double height, std::size_t most) {
  std::vector<std::size_t> written;
  const auto apart = [&](const Label& a, const Label& b) {
    return std::abs(a.x - b.x) >= width || std::abs(a.y - b.y) >= height;
  };
  for (std::size_t k = 0; k < labels.size() && written.size() < most; ++k) {
    if (std::all_of(taken.begin(), taken.end(),
                    [&](const Label& other) { return apart(labels[k], other); }) &&
        std::all_of(written.begin(), written.end(),
                    [&](std::size_t other) { return apart(labels[k], labels[other]); })) {
      written.push_back(k);
    }
  }
  return written;
}

}  // namespace soms::command
