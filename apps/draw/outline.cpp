#include "apps/draw/outline.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace soms::command {

namespace {

/// Steps east, north, west, south.
constexpr std::array<GridPoint, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// For each corner of the grid the directions in which an edge leaves it, as bits.
std::vector<std::uint8_t> edges_of(const std::vector<std::uint8_t>& inside, std::size_t columns,
                                   std::size_t rows) {
  std::vector<std::uint8_t> edges((columns + 1) * (rows + 1), 0);
  const auto is_inside = [&](std::size_t column, std::size_t row) {
    return column < columns && row < rows && inside[row * columns + column] != 0;
  };
  const auto leave = [&](std::size_t column, std::size_t row, unsigned direction) {
    std::uint8_t& bits = edges[row * (columns + 1) + column];
    bits = static_cast<std::uint8_t>(bits | (1U << direction));
  };
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      if (!is_inside(column, row)) {
        continue;
      }
      // Below row 0 and left of column 0 the number wraps to one that is outside.
      if (!is_inside(column, row - 1)) {
        leave(column, row, 0);
      }
      if (!is_inside(column + 1, row)) {
        leave(column + 1, row, 1);
      }
      if (!is_inside(column, row + 1)) {
        leave(column + 1, row + 1, 2);
      }
      if (!is_inside(column - 1, row)) {
        leave(column, row + 1, 3);
      }
    }
  }
  return edges;
}

double distance_to_line(const GridPoint& p, const GridPoint& a, const GridPoint& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length = std::hypot(dx, dy);
  if (length == 0) {
    return std::hypot(p.x - a.x, p.y - a.y);
  }
  // Beyond an end the end is nearest: a spike that turns back must not count as straight.
  const double along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / length;
  if (along < 0 || along > length) {
    const GridPoint& end = along < 0 ? a : b;
    return std::hypot(p.x - end.x, p.y - end.y);
  }
  return std::abs((p.x - a.x) * dy - (p.y - a.y) * dx) / length;
}

}  // namespace

std::vector<Loop> outline(const std::vector<std::uint8_t>& inside, std::size_t columns,
                          std::size_t rows) {
  std::vector<std::uint8_t> edges = edges_of(inside, columns, rows);
  std::vector<Loop> loops;
  for (std::size_t start = 0; start < edges.size(); ++start) {
    while (edges[start] != 0) {
      Loop loop;
      unsigned direction = 0;
      while ((unsigned{edges[start]} >> direction & 1U) == 0) {
        ++direction;
      }
      GridPoint at{static_cast<std::int32_t>(start % (columns + 1)),
                   static_cast<std::int32_t>(start / (columns + 1))};
      unsigned before = 4;
      for (;;) {
        std::uint8_t& bits =
            edges[static_cast<std::size_t>(at.y) * (columns + 1) + static_cast<std::size_t>(at.x)];
        // Left first: two cells that meet in a corner alone get a loop each.
        if (before < 4) {
          const std::array<unsigned, 3> turns{(before + 1) % 4, before, (before + 3) % 4};
          const auto next = std::find_if(turns.begin(), turns.end(), [&](unsigned d) {
            return (unsigned{bits} >> d & 1U) != 0;
          });
          if (next == turns.end()) {
            break;
          }
          direction = *next;
        }
        bits = static_cast<std::uint8_t>(bits & ~(1U << direction));
        if (direction != before) {
          loop.push_back(at);
        }
        at = {at.x + kSteps[direction].x, at.y + kSteps[direction].y};
        before = direction;
      }
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

Loop simplified_line(const Loop& line, double tolerance) {
  if (line.size() < 3) {
    return line;
  }
  std::vector<std::uint8_t> keep(line.size(), 0);
  keep.front() = keep.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double worst = tolerance;
    std::size_t at = first;
    for (std::size_t k = first + 1; k < last; ++k) {
      const double distance = distance_to_line(line[k], line[first], line[last]);
      if (distance > worst) {
        worst = distance;
        at = k;
      }
    }
    if (at != first) {
      keep[at] = 1;
      open.emplace_back(first, at);
      open.emplace_back(at, last);
    }
  }
  Loop kept;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (keep[k] != 0) {
      kept.push_back(line[k]);
    }
  }
  return kept;
}

Loop simplified_loop(const Loop& loop, double tolerance) {
  if (loop.size() < 4) {
    return loop;
  }
  // Cut at the first point and at the one farthest from it.
  const auto farther = [&](const GridPoint& a, const GridPoint& b) {
    return std::hypot(a.x - loop[0].x, a.y - loop[0].y) <
           std::hypot(b.x - loop[0].x, b.y - loop[0].y);
  };
  const auto far = std::max_element(loop.begin(), loop.end(), farther);
  Loop back(far, loop.end());
  back.push_back(loop.front());
  Loop result = simplified_line(Loop(loop.begin(), far + 1), tolerance);
  const Loop rest = simplified_line(back, tolerance);
  result.insert(result.end(), rest.begin() + 1, rest.end() - 1);
  return result;
}

std::int64_t double_area(const Loop& loop) {
  std::int64_t area = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const GridPoint& a = loop[k];
    const GridPoint& b = loop[(k + 1) % loop.size()];
    area += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return area;
}

void PathWriter::number(std::int32_t value) {
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  if (blank_ && value >= 0) {
    path_ += ' ';
  }
  path_.append(digits.data(), end);
  blank_ = true;
}

void PathWriter::move_to(const GridPoint& to) {
  // Steps are shorter to write than places.
  path_ += path_.empty() ? 'M' : 'm';
  command_ = 'm';
  blank_ = false;
  number(to.x - at_.x);
  number(to.y - at_.y);
  at_ = to;
}

void PathWriter::line_to(const GridPoint& to) {
  const std::int32_t dx = to.x - at_.x;
  const std::int32_t dy = to.y - at_.y;
  const char wanted = dy == 0 ? 'h' : dx == 0 ? 'v' : 'l';
  if (command_ != wanted) {
    path_ += wanted;
    command_ = wanted;
    blank_ = false;
  }
  if (wanted != 'v') {
    number(dx);
  }
  if (wanted != 'h') {
    number(dy);
  }
  at_ = to;
}

void PathWriter::add(const Loop& line, bool closed) {
  if (line.empty()) {
    return;
  }
  move_to(line[0]);
  for (std::size_t k = 1; k < line.size(); ++k) {
    line_to(line[k]);
  }
  if (closed) {
    path_ += 'z';
    at_ = line[0];  // where z leads
    command_ = 'z';
  }
}

}  // namespace soms::command
