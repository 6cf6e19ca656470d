#include "soms/thesis/named_overlap.h"

#include "soms/base/error.h"
#include "soms/query/reference/overlap.h"
#include "soms/thesis/overlap.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/support.h"
#include "tests/thesis/cases.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

Shape shape(const Mesh& mesh, const BuildOptions& build) {
  return Shape(mesh, {.build = build, .keep_tree = true});
}

/// Options of any rule that make trees of any kind, children without triangles included.
BuildOptions any_tree(Rng& rng) {
  BuildOptions options = thesis_options(rules()[rng.below(rules().size())].rule, 8);
  options.empty_side = static_cast<EmptySide>(rng.below(4));
  options.per_leaf = 1 + static_cast<int>(rng.below(4));
  return without_idle(options);
}

/// Every traversal, with boxes moved either way.
std::vector<TraversalOptions> named_traversal_options() {
  std::vector<TraversalOptions> out = test::every_traversal_options();
  const std::size_t n = out.size();
  for (std::size_t i = 0; i < n; ++i) {
    out.push_back(out[i]);
    out.back().update = BoxUpdate::rebox;
  }
  return out;
}

/// Two random bodies and the truth about them.
struct Case {
  explicit Case(Rng& rng, std::size_t most = 25)
      : kind(test::kKinds[rng.below(test::kKinds.size())]),
        a(shape(test::body(rng, kind, 1 + rng.below(most)), any_tree(rng)), test::pose(rng, kind)),
        b(shape(test::body(rng, kind, 1 + rng.below(most)), any_tree(rng)), test::pose(rng, kind)),
        truth(reference::overlap(a.shape.mesh(), a.pose, b.shape.mesh(), b.pose)) {}

  test::Kind kind;
  Body a;
  Body b;
  Overlap truth;
};

TEST(NamedOverlap, EqualsBruteForceByEveryWay) {
  const std::vector<TraversalOptions> all = named_traversal_options();
  test::for_each_case("named/answers", 60, [&](Rng& rng) {
    const Case c(rng);
    for (const TraversalOptions& settings : all) {
      const Overlap answer = thesis::overlap(c.a, c.b, settings).answer;
      EXPECT_EQ(answer.pairs, c.truth.pairs) << test::describe(settings);
      EXPECT_EQ(answer.any, c.truth.any);
      EXPECT_EQ(answer.coverage, Coverage::complete);
      EXPECT_LE(answer.cost.triangle_tests, c.truth.cost.triangle_tests);
      EXPECT_EQ(answer.cost.exact_tests, c.truth.cost.exact_tests) << test::describe(settings);
    }
  });
}

TEST(NamedOverlap, AnswersTheSameWhenMovedBefore) {
  test::for_each_case("named/moved", 20, [](Rng& rng) {
    const Case c(rng);
    for (const TraversalOptions& settings : named_traversal_options()) {
      thesis::NamedOverlap at_once(c.a.shape, c.b.shape, settings);
      thesis::NamedOverlap in_steps(c.a.shape, c.b.shape, settings);
      in_steps.move(c.a.pose, c.b.pose);
      EXPECT_EQ(in_steps.counts(), TraversalCounts{});
      EXPECT_EQ(in_steps(c.a.pose, c.b.pose, {}, {}).pairs,
                at_once(c.a.pose, c.b.pose, {}, {}).pairs);
      EXPECT_EQ(in_steps.counts(), at_once.counts()) << test::describe(settings);
    }
  });
}

TEST(NamedOverlap, TellsTheCountsOfItsTraversal) {
  test::for_each_case("named/counts", 20, [](Rng& rng) {
    const Case c(rng);
    PosedBoxes a(c.a.shape.mesh(), *c.a.shape.tree());
    PosedBoxes b(c.b.shape.mesh(), *c.b.shape.tree());
    a.move(c.a.pose);
    b.move(c.b.pose);
    for (const TraversalOptions& settings : test::every_traversal_options()) {
      thesis::NamedOverlap session(c.a.shape, c.b.shape, settings);
      const Overlap answer = session(c.a.pose, c.b.pose, {}, {});
      EXPECT_EQ(session.counts(), traverse(a.view(), b.view(), settings))
          << test::describe(settings);
      EXPECT_EQ(session.counts().box_tests, answer.cost.node_tests);
      EXPECT_EQ(thesis::overlap(c.a, c.b, settings),
                (thesis::CountedOverlap{answer, session.counts()}));
      const auto batch = thesis::overlap(c.a.shape, std::vector<Pose>{c.a.pose}, c.b, settings);
      ASSERT_EQ(batch.size(), 1U);
      EXPECT_EQ(batch[0], (thesis::CountedOverlap{answer, session.counts()}));
    }
  });
}

TEST(NamedOverlap, SwapsColumnsWhenBodiesAreSwapped) {
  test::for_each_case("named/swapped", 40, [](Rng& rng) {
    const Case c(rng);
    for (const TraversalOptions& settings : test::every_traversal_options()) {
      std::vector<TrianglePair> swapped;
      for (const auto& [j, i] : thesis::overlap(c.b, c.a, settings).answer.pairs) {
        swapped.emplace_back(i, j);
      }
      std::sort(swapped.begin(), swapped.end());
      EXPECT_EQ(swapped, c.truth.pairs) << test::describe(settings);
    }
  });
}

TEST(NamedOverlap, StopsAtAnyHitAndFindsTheLeastPair) {
  test::for_each_case("named/modes", 60, [](Rng& rng) {
    const Case c(rng);
    for (const TraversalOptions& settings : test::every_traversal_options()) {
      SCOPED_TRACE(test::describe(settings));
      const Overlap any = thesis::overlap(c.a, c.b, settings, {.mode = OverlapMode::any}).answer;
      const Overlap first =
          thesis::overlap(c.a, c.b, settings, {.mode = OverlapMode::first}).answer;
      EXPECT_EQ(any.any, c.truth.any);
      EXPECT_EQ(first.any, c.truth.any);
      const Coverage expected = c.truth.any ? Coverage::first : Coverage::complete;
      EXPECT_EQ(any.coverage, expected);
      EXPECT_EQ(first.coverage, expected);
      ASSERT_EQ(any.pairs.size(), c.truth.any ? 1U : 0U);
      ASSERT_EQ(first.pairs.size(), any.pairs.size());
      if (c.truth.any) {
        EXPECT_TRUE(std::binary_search(c.truth.pairs.begin(), c.truth.pairs.end(), any.pairs[0]));
        EXPECT_EQ(first.pairs[0], c.truth.pairs[0]);
      }
    }
  });
}

TEST(NamedOverlap, CutsAtTheLimitAndSaysSo) {
  test::for_each_case("named/limit", 40, [](Rng& rng) {
    const Case c(rng);
    for (const TraversalOptions& settings : test::every_traversal_options()) {
      for (const std::uint64_t limit :
           {std::uint64_t{0}, std::uint64_t{1}, rng.below(9), c.truth.pairs.size()}) {
        const Overlap answer = thesis::overlap(c.a, c.b, settings, {.limit = limit}).answer;
        const bool cut = limit < c.truth.pairs.size();
        EXPECT_EQ(answer.pairs.size(), std::min<std::size_t>(limit, c.truth.pairs.size()));
        EXPECT_EQ(answer.coverage, cut ? Coverage::cut : Coverage::complete);
        EXPECT_EQ(answer.any, c.truth.any);
        EXPECT_TRUE(std::includes(c.truth.pairs.begin(), c.truth.pairs.end(), answer.pairs.begin(),
                                  answer.pairs.end()));
      }
    }
  });
}

TEST(NamedOverlap, AnswersABatchAsSingleQueries) {
  test::for_each_case("named/batch", 20, [](Rng& rng) {
    const Case c(rng, 15);
    std::vector<Pose> poses;
    for (int i = 0; i < 6; ++i) {
      poses.push_back(test::pose(rng, c.kind));
    }
    poses.push_back(poses.back());
    for (const TraversalOptions& settings : named_traversal_options()) {
      const auto batch = thesis::overlap(c.a.shape, poses, c.b, settings);
      ASSERT_EQ(batch.size(), poses.size());
      for (std::size_t k = 0; k < poses.size(); ++k) {
        const Overlap twin =
            reference::overlap(c.a.shape.mesh(), poses[k], c.b.shape.mesh(), c.b.pose);
        EXPECT_EQ(batch[k].answer.pairs, twin.pairs) << test::describe(settings) << ", pose " << k;
      }
    }
  });
}

// A batch of the default traversal is cut into blocks of 256 poses; what one front sees is not.
TEST(NamedOverlap, GoesOnFromItsFrontThroughABatchOfAnySize) {
  Rng rng(13);
  const test::Kind kind = test::Kind::random;
  const Body fixed(shape(test::body(rng, kind, 12), {}));
  const Shape mover = shape(test::body(rng, kind, 12), {});
  std::vector<Pose> poses;
  while (poses.size() < 600) {
    poses.push_back(test::pose(rng, kind, 0.5));
  }
  const TraversalOptions settings{.traversal = Traversal::e_node_front};
  const auto batch = thesis::overlap(mover, poses, fixed, settings, {}, {.threads = 2});
  ASSERT_EQ(batch.size(), poses.size());
  thesis::NamedOverlap session(mover, fixed.shape, settings);
  std::size_t otherwise = 0;  // frames whose counts tell that the front went on
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Overlap answer = session(poses[k], fixed.pose, {}, {});
    ASSERT_EQ(batch[k].answer.pairs, answer.pairs) << k;
    ASSERT_EQ(batch[k].counts, session.counts()) << k;
    const auto alone = thesis::overlap(Body(mover, poses[k]), fixed, settings);
    otherwise += alone.counts == batch[k].counts ? 0U : 1U;
  }
  EXPECT_GT(otherwise, 500U);
}

TEST(NamedOverlap, OfAnEmptyMeshIsEmpty) {
  Rng rng(1);
  const Body full(shape(test::body(rng, test::Kind::random, 5), {}));
  const Body none(shape(Mesh{}, {}));
  for (const TraversalOptions& settings : named_traversal_options()) {
    EXPECT_FALSE(thesis::overlap(full, none, settings).answer.any);
    EXPECT_FALSE(thesis::overlap(none, full, settings).answer.any);
    EXPECT_EQ(thesis::overlap(none, none, settings).answer.cost, Cost{});
  }
}

ErrorKind kind_of(const Body& a, const Body& b, const TraversalOptions& settings) {
  try {
    (void)thesis::overlap(a, b, settings).answer;
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::cancelled;
}

TEST(NamedOverlap, OfTheDefaultTraversalIsOverlap) {
  test::for_each_case("named/default", 20, [](Rng& rng) {
    const Case c(rng);
    const std::vector<Pose> poses(3, c.a.pose);
    const thesis::CountedOverlap expected{overlap(c.a, c.b), {}};
    EXPECT_EQ(thesis::overlap(c.a, c.b, {}), expected);
    EXPECT_EQ(thesis::overlap(c.a.shape, poses, c.b, {}), std::vector(3, expected));
  });
}

TEST(NamedOverlap, NamesThePoseOfABatchThatIsAtFault) {
  Rng rng(1);
  const Body body(shape(test::body(rng, test::Kind::random, 5), {}));
  std::vector<Pose> poses(3);
  poses[2].m[0] = 2;
  try {
    (void)thesis::overlap(body.shape, poses, body, {.traversal = Traversal::larger});
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_rigid);
    EXPECT_NE(error.place().find("pose 2"), std::string::npos) << error.place();
  }
}

TEST(NamedOverlap, NeedsKeptTrees) {
  Rng rng(1);
  const Mesh mesh = test::body(rng, test::Kind::random, 5);
  const Body kept(shape(mesh, {}));
  const Body bare(mesh);
  const TraversalOptions settings{.traversal = Traversal::e_node};
  EXPECT_EQ(kind_of(kept, bare, settings), ErrorKind::usage);
  EXPECT_EQ(kind_of(bare, kept, settings), ErrorKind::usage);
  EXPECT_THROW(thesis::NamedOverlap(kept.shape, kept.shape, {}), Error);
  try {
    (void)thesis::overlap(bare, kept, settings).answer;
  } catch (const Error& error) {
    EXPECT_EQ(error.place(), "traversal e_node: a shape without its canonical tree");
    EXPECT_EQ(error.remedy(),
              "make the shape with ShapeOptions{.keep_tree = true}, or use traversal fast");
  }
}

TEST(NamedOverlap, RefusesPosesAndOptionsThatMakeNoSense) {
  Rng rng(1);
  Body a(shape(test::body(rng, test::Kind::random, 5), {}));
  const Body b = a;
  EXPECT_EQ(kind_of(a, b, {.traversal = Traversal::e_node_front, .descent = Descent::cross}),
            ErrorKind::usage);
  const TraversalOptions settings{.traversal = Traversal::larger};
  a.pose.m[0] = 2;
  EXPECT_EQ(kind_of(a, b, settings), ErrorKind::not_rigid);
  EXPECT_EQ(kind_of(b, a, settings), ErrorKind::not_rigid);
  a.pose = Pose::translation(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_EQ(kind_of(a, b, settings), ErrorKind::not_finite);
  a.pose = Pose::translation(0x1p301, 0, 0);
  EXPECT_EQ(kind_of(b, a, settings), ErrorKind::out_of_range);
}

TEST(NamedOverlap, IsCutByADeadlineAndEndedByAStop) {
  Rng rng(1);
  const Body body(shape(test::body(rng, test::Kind::coincident, 3000), {}));
  std::stop_source source;
  source.request_stop();
  for (const Traversal traversal :
       {Traversal::larger, Traversal::e_node, Traversal::e_node_front}) {
    const TraversalOptions settings{.traversal = traversal};
    Limits limits;
    EXPECT_THROW((void)thesis::overlap(body, body, settings, {}, {.stop = source.get_token()}),
                 Error);
    limits.deadline = std::chrono::steady_clock::now();
    const Overlap late = thesis::overlap(body, body, settings, {}, limits).answer;
    EXPECT_EQ(late.coverage, Coverage::cut);
    EXPECT_EQ(late.cost, Cost{});
    Overlap cut;
    // On a slow machine the deadline may pass before the first box test.
    for (auto time = std::chrono::milliseconds(20); cut.cost == Cost{}; time *= 2) {
      limits.deadline = std::chrono::steady_clock::now() + time;
      cut = thesis::overlap(body, body, settings, {}, limits).answer;
    }
    EXPECT_EQ(cut.coverage, Coverage::cut);
    EXPECT_GT(cut.cost.node_tests, 0U);
  }
}

/// Triangles in a row along x, a quarter wide, and three quarters from one to the next.
Mesh row_of(std::uint32_t count, double from) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = from + i;
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {x + 0.25, 0, 0}, {x, 1, 0}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

// Both trees are one leaf of 20,000 triangles whose boxes are apart, so no triangles are decided
// and one box test of nodes is made: the clock must be looked at within the leaf pair.
TEST(NamedOverlap, IsCutByADeadlineWithinAPairOfLeaves) {
  const Body body(shape(row_of(20000, 0), thesis_options(Rule::soms, 1)));
  Body other = body;
  other.pose = Pose::translation(0.5, 0, 0);
  const TraversalOptions settings{.traversal = Traversal::larger};
  Limits limits;
  Overlap cut;
  // On a slow machine the deadline may pass while the boxes are moved, before the leaf pair.
  for (auto time = std::chrono::milliseconds(20); cut.cost == Cost{}; time *= 2) {
    limits.deadline = std::chrono::steady_clock::now() + time;
    cut = thesis::overlap(body, other, settings, {}, limits).answer;
  }
  EXPECT_EQ(cut.coverage, Coverage::cut);
  EXPECT_EQ(cut.cost, (Cost{1, 0, 0}));
}

// 500 small leaves lie in the gaps of one leaf of 20,000 triangles: fewer box tests than there are
// between two looks at the clock, and nothing to decide. The time goes into the large leaf.
TEST(NamedOverlap, IsCutByADeadlineWhereALargeLeafLeavesNothingToDecide) {
  const Body small(shape(row_of(500, 10000.5), thesis_options(Rule::soms)));
  const Body large(shape(row_of(20000, 0), thesis_options(Rule::soms, 1)));
  const TraversalOptions settings{.traversal = Traversal::larger};
  for (const auto& [a, b] : {std::pair(&small, &large), std::pair(&large, &small)}) {
    ASSERT_EQ(thesis::overlap(*a, *b, settings).answer.cost, (Cost{999, 0, 0}));
    Limits hurried;
    Overlap cut;
    // On a slow machine the deadline may pass while the boxes are moved, before the first leaf.
    for (auto time = std::chrono::milliseconds(2); cut.cost == Cost{}; time *= 2) {
      hurried.deadline = std::chrono::steady_clock::now() + time;
      cut = thesis::overlap(*a, *b, settings, {}, hurried).answer;
    }
    EXPECT_EQ(cut.coverage, Coverage::cut);
    EXPECT_LT(cut.cost.node_tests, 999U);
  }
}

TEST(NamedOverlap, KeepsBodiesThatGoOutOfScope) {
  Rng rng(1);
  const Mesh mesh = test::body(rng, test::Kind::random, 40);
  const Overlap truth = reference::overlap(mesh, {}, mesh, {});
  const auto session = [&] {
    const Shape a = shape(mesh, {});
    const Shape b = shape(mesh, {});
    return thesis::NamedOverlap(a, b, {.traversal = Traversal::e_node_front});
  };
  thesis::NamedOverlap moved = session();
  EXPECT_EQ(moved({}, {}, {}, {}).pairs, truth.pairs);
  EXPECT_EQ(moved({}, {}, {}, {}).pairs, truth.pairs);
}

}  // namespace
}  // namespace soms
