/// \file
/// The nearest of all tiles, whatever is measured: the distance of a body or a point, or t on a
/// ray.
#pragma once

#include "soms/base/bracket.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/scene/detail/search/measures.h"
#include "soms/tiles/detail/tile_boxes.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace soms::detail {

/// Searches tiles in the order of their keys, and decides exactly between those that are equally
/// near as far as brackets tell. A `Question` has
/// - `Answer`, with `coverage` and `cost`;
/// - `Winner`, what is named: a triangle, or a pair; numbers are those of the whole, and the least
///   of equally near ones counts;
/// - `measure(answer)`, its bracket: the narrowest one;
/// - `key(box)`: not above what is measured anywhere in a box;
/// - `limit()`: nothing beyond it matters;
/// - `late()`: its deadline passed;
/// - `ask(body, tile, limit)`: the answer of one tile, which may leave out what is beyond `limit`;
/// - `winner(answer, tile)`, if the answer names one;
/// - `compare(body, triangles, other body, other triangles)`: the order of both, exactly, of a
///   triangle or a pair each.
template <class Question>
class NearestTile {
 public:
  using Answer = typename Question::Answer;
  using Winner = typename Question::Winner;

  struct Found {
    Answer answer;
    Winner winner;
    std::shared_ptr<const OpenTile> tile;
  };

  explicit NearestTile(const Question& question) : question_(question), limit_(question.limit()) {}

  void run(const TileBoxes& tiles, std::vector<KeyedBounds>& memory) {
    const auto key = [&](const Box& box) { return question_.key(box); };
    cost_.node_tests += tiles.boxes().search(
        key, limit_, memory,
        [&](std::uint32_t tile, double key_of_tile) { return visit(tiles, tile, key_of_tile); });
  }

  /// The nearest so far, with the tile's own numbers in its answer; nothing if none was found.
  [[nodiscard]] const std::optional<Found>& found() const { return found_; }

  [[nodiscard]] bool cut() const { return cut_; }

  /// Where the search was cut: nothing that is not found is nearer than this.
  [[nodiscard]] double at_least() const { return at_least_; }

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// What is searched up to from now on.
  double visit(const TileBoxes& tiles, std::uint32_t number, double key) {
    if (question_.late()) {
      return cut(key);
    }
    std::shared_ptr<const OpenTile> tile = tiles.open(number);
    const Body body(tile->shape, tiles.body().pose);
    Answer answer = question_.ask(body, *tile, limit_);
    cost_ += answer.cost;
    const bool is_cut = answer.coverage == Coverage::cut;
    if (std::optional<Winner> winner = question_.winner(answer, *tile);
        winner && is_nearer(answer, *winner, body, tiles.body().pose)) {
      limit_ = std::min(limit_, question_.measure(answer).upper);
      found_.emplace(Found{std::move(answer), *winner, std::move(tile)});
    }
    return is_cut ? cut(key) : limit_;
  }

  /// Ends the search at a tile of this key, and of no less key are those that follow.
  double cut(double key) {
    cut_ = true;
    at_least_ = key;
    return -kInfinity;
  }

  [[nodiscard]] bool is_nearer(const Answer& answer, const Winner& winner, const Body& body,
                               const Pose& pose) const {
    if (!found_) {
      return true;
    }
    const std::strong_ordering order =
        order_of(question_.measure(answer), question_.measure(found_->answer), [&] {
          return question_.compare(body, triangles_of(answer), Body(found_->tile->shape, pose),
                                   triangles_of(found_->answer));
        });
    return order < 0 || (order == 0 && winner < found_->winner);
  }

  /// What an answer names, by the tile's own numbers.
  [[nodiscard]] static Winner triangles_of(const Answer& answer) {
    if constexpr (requires { answer.triangles; }) {
      return *answer.triangles;
    } else {
      return *answer.triangle;
    }
  }

  const Question& question_;
  double limit_;
  std::optional<Found> found_;
  bool cut_ = false;
  double at_least_ = kInfinity;
  Cost cost_;
};

/// The tile that a question meets first, for `for_each_row`.
template <class KeyOf>
[[nodiscard]] std::uint32_t first_tile(const TileBoxes& tiles, const KeyOf& key_of) {
  std::vector<KeyedBounds> memory;
  std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
  tiles.boxes().search(key_of, std::numeric_limits<double>::max(), memory,
                       [&](std::uint32_t tile, double /*key*/) {
                         first = tile;
                         return -std::numeric_limits<double>::infinity();
                       });
  return first;
}

}  // namespace soms::detail
