/// \file
/// A traversal taken apart: its tests in order, each in words.
#pragma once

#include "soms/base/box.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversal_options.h"

#include "apps/view/scene/touch.h"
#include "apps/view/scene/view_scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace soms::view {

/// What follows from the test of two nodes' boxes.
enum class LessonStep : std::uint8_t {
  ends,    ///< they are apart: nothing below them can touch
  enters,  ///< they overlap: what is below them is tested
  passes,  ///< they are apart, but without pruning what is below them is tested all the same
  leaves,  ///< they overlap, and both are leaves: their triangles are compared
};

struct LessonTest {
  NodePair nodes;
  LessonStep step = LessonStep::ends;

  [[nodiscard]] bool operator==(const LessonTest&) const = default;
};

/// The first box tests of a traversal, in order.
/// \errors As `traverse`.
[[nodiscard]] std::vector<LessonTest> lesson_tests(const PosedTree& a, const PosedTree& b,
                                                   const TraversalOptions& options,
                                                   std::size_t most = 100'000);

/// How a traversal goes, in a sentence.
[[nodiscard]] std::string in_a_sentence(const TraversalOptions& options);

/// The traversal of a scene's pair at its present poses, test by test.
class Lesson {
 public:
  /// Takes the traversal apart again if the pair, a pose, a tree or an option changed since.
  /// Without a pair, and for Traversal::fast (see `FastLesson`), there are no tests. \errors As
  /// `traverse`.
  void update(ViewScene& scene);

  [[nodiscard]] const std::vector<LessonTest>& tests() const { return tests_; }

  /// What a test is and what follows, in sentences. \pre `update`; `test` is one of `tests`.
  [[nodiscard]] std::vector<std::string> sentences(ViewScene& scene, std::size_t test) const;

 private:
  /// What the tests depend on.
  struct Key {
    std::pair<BodyRef, BodyRef> pair;
    Pose pose_a;
    Pose pose_b;
    std::uint64_t trees = 0;
    TraversalOptions options;

    [[nodiscard]] bool operator==(const Key&) const = default;
  };

  std::optional<Key> key_;
  std::vector<LessonTest> tests_;
};

}  // namespace soms::view
