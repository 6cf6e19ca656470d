/// \file
/// What a step of a scene finds: who touches whom, and with which triangles; who is near whom; who
/// touched whom on the way to here.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/describe/fields.h"
#include "soms/geometry/mesh.h"
#include "soms/motion/first_contact.h"
#include "soms/query/answer.h"

#include <compare>
#include <cstdint>
#include <tuple>
#include <vector>

namespace soms {

/// Stable number of a mover or of a part of the environment; never used again after removal.
using MoverId = std::uint32_t;
using EnvironmentId = std::uint32_t;

/// A triangle of a mover touches a triangle of the environment.
struct EnvironmentContact {
  MoverId mover = 0;
  EnvironmentId part = 0;  ///< number of the body, not of a part of its mesh (see PartsOf)
  TriangleId i = 0;        ///< triangle of the mover
  TriangleId j = 0;        ///< triangle of that body

  [[nodiscard]] auto operator<=>(const EnvironmentContact&) const = default;
};

template <>
struct Fields<EnvironmentContact> {
  static constexpr const char* kName = "EnvironmentContact";
  static constexpr const char* kMeaning =
      "A triangle of a mover touches a triangle of the environment.";
  static constexpr auto kList =
      std::tuple(field("mover", &EnvironmentContact::mover, "The mover."),
                 field("part", &EnvironmentContact::part, "Number of the body of the environment."),
                 field("i", &EnvironmentContact::i, "Triangle of the mover."),
                 field("j", &EnvironmentContact::j, "Triangle of that body."));
};

/// A triangle of one mover touches a triangle of another; `a` is less than `b`.
struct MoverContact {
  MoverId a = 0;
  MoverId b = 0;
  TriangleId i = 0;  ///< triangle of a
  TriangleId j = 0;  ///< triangle of b

  [[nodiscard]] auto operator<=>(const MoverContact&) const = default;
};

template <>
struct Fields<MoverContact> {
  static constexpr const char* kName = "MoverContact";
  static constexpr const char* kMeaning = "A triangle of one mover touches a triangle of another.";
  static constexpr auto kList =
      std::tuple(field("a", &MoverContact::a, "The mover of the lesser number."),
                 field("b", &MoverContact::b, "The other mover."),
                 field("i", &MoverContact::i, "Triangle of a."),
                 field("j", &MoverContact::j, "Triangle of b."));
};

/// A mover is within the clearance of a body of the environment and does not touch it.
struct EnvironmentGap {
  MoverId mover = 0;
  EnvironmentId part = 0;  ///< number of the body, not of a part of its mesh
  TriangleId i = 0;        ///< triangle of the mover, of the pair that `Distance` names
  TriangleId j = 0;        ///< triangle of that body
  Bracket distance = {};   ///< least distance of the two, as of `Distance`; above 0
  Vec3 point_a = {};       ///< the end of a shortest segment on the mover, in world
  Vec3 point_b = {};       ///< the other end

  [[nodiscard]] bool operator==(const EnvironmentGap&) const = default;
};

template <>
struct Fields<EnvironmentGap> {
  static constexpr const char* kName = "EnvironmentGap";
  static constexpr const char* kMeaning =
      "A mover is within the clearance of a body of the environment.";
  static constexpr auto kList =
      std::tuple(field("mover", &EnvironmentGap::mover, "The mover."),
                 field("part", &EnvironmentGap::part, "Number of the body of the environment."),
                 field("i", &EnvironmentGap::i, "Triangle of the mover."),
                 field("j", &EnvironmentGap::j, "Triangle of that body."),
                 field("distance", &EnvironmentGap::distance, "The distance"),
                 field("point_a", &EnvironmentGap::point_a,
                       "The end of a shortest segment on the first, in world."),
                 field("point_b", &EnvironmentGap::point_b, "The other end."));
};

/// Two movers are within the clearance of each other and do not touch; `a` is less than `b`.
struct MoverGap {
  MoverId a = 0;
  MoverId b = 0;
  TriangleId i = 0;       ///< triangle of a, of the pair that `Distance` names
  TriangleId j = 0;       ///< triangle of b
  Bracket distance = {};  ///< least distance of the two, as of `Distance`; above 0
  Vec3 point_a = {};      ///< the end of a shortest segment on a, in world
  Vec3 point_b = {};      ///< the other end, on b

  [[nodiscard]] bool operator==(const MoverGap&) const = default;
};

template <>
struct Fields<MoverGap> {
  static constexpr const char* kName = "MoverGap";
  static constexpr const char* kMeaning = "Two movers are within the clearance of each other.";
  static constexpr auto kList = std::tuple(
      field("a", &MoverGap::a, "The mover of the lesser number."),
      field("b", &MoverGap::b, "The other mover."), field("i", &MoverGap::i, "Triangle of a."),
      field("j", &MoverGap::j, "Triangle of b."),
      field("distance", &MoverGap::distance, "The distance"),
      field("point_a", &MoverGap::point_a, "The end of a shortest segment on the first, in world."),
      field("point_b", &MoverGap::point_b, "The other end."));
};

/// A mover touches a body of the environment on the way from the last step to this one, or is not
/// proved free there.
struct EnvironmentPassage {
  MoverId mover = 0;
  EnvironmentId part = 0;  ///< number of the body, not of a part of its mesh
  TriangleId i = 0;        ///< triangle of the mover, of the pair that FirstContact names
  TriangleId j = 0;        ///< triangle of that body
  /// contact, grazing, or started, as of FirstContact. The last says that the two touched at the
  /// begin of the way and do not now.
  ContactVerdict verdict = ContactVerdict::contact;
  Bracket t = {};   ///< of the first contact, in parts of the way; as of FirstContact
  Vec3 point = {};  ///< where that is, in world

  [[nodiscard]] bool operator==(const EnvironmentPassage&) const = default;
};

template <>
struct Fields<EnvironmentPassage> {
  static constexpr const char* kName = "EnvironmentPassage";
  static constexpr const char* kMeaning =
      "A mover touches a body of the environment on the way from the last step.";
  static constexpr auto kList =
      std::tuple(field("mover", &EnvironmentPassage::mover, "The mover."),
                 field("part", &EnvironmentPassage::part, "Number of the body of the environment."),
                 field("i", &EnvironmentPassage::i, "Triangle of the mover."),
                 field("j", &EnvironmentPassage::j, "Triangle of that body."),
                 field("verdict", &EnvironmentPassage::verdict, "What is proved."),
                 field("t", &EnvironmentPassage::t, "The part of the way at the first contact"),
                 field("point", &EnvironmentPassage::point, "Where it is, in world."));
};

/// Two movers touch on their ways from the last step to this one, or are not proved free there; `a`
/// is less than `b`.
struct MoverPassage {
  MoverId a = 0;
  MoverId b = 0;
  TriangleId i = 0;                                  ///< triangle of a
  TriangleId j = 0;                                  ///< triangle of b
  ContactVerdict verdict = ContactVerdict::contact;  ///< as of EnvironmentPassage
  Bracket t = {};                                    ///< likewise
  Vec3 point = {};                                   ///< likewise

  [[nodiscard]] bool operator==(const MoverPassage&) const = default;
};

template <>
struct Fields<MoverPassage> {
  static constexpr const char* kName = "MoverPassage";
  static constexpr const char* kMeaning = "Two movers touch on their ways from the last step.";
  static constexpr auto kList =
      std::tuple(field("a", &MoverPassage::a, "The mover of the lesser number."),
                 field("b", &MoverPassage::b, "The other mover."),
                 field("i", &MoverPassage::i, "Triangle of a."),
                 field("j", &MoverPassage::j, "Triangle of b."),
                 field("verdict", &MoverPassage::verdict, "What is proved."),
                 field("t", &MoverPassage::t, "The part of the way at the first contact"),
                 field("point", &MoverPassage::point, "Where it is, in world."));
};

/// Which pairs of bodies a step compares.
enum class StepScope {
  every_pair,  ///< all whose boxes meet: every pair of bodies that touch is reported
  /// A mover that touches something is compared no further: whether each mover touches anything is
  /// reported, with one contact that shows it.
  first_contact,
};

template <>
inline constexpr auto kWords<StepScope> = words(
    "StepScope",
    "Which pairs of bodies a step compares: all, or those of a mover up to its first contact.",
    "every_pair", "first_contact");

/// What a step found: sorted lists, the same bytes for any number of threads. A pair of bodies has
/// contacts or one gap, never both.
struct StepReport {
  std::vector<EnvironmentContact> environment;
  std::vector<MoverContact> movers;
  Coverage coverage = Coverage::complete;
  Cost cost;
  std::uint64_t queries = 0;  ///< narrow-phase queries: pairs of bodies that were compared
  /// Pairs of bodies whose world boxes meet. Movers of one group and movers that ignore each other
  /// do not count.
  std::uint64_t box_pairs = 0;
  StepScope scope = StepScope::every_pair;  ///< as of StepOptions
  bool mover_mover = true;                  ///< as of StepOptions
  std::uint64_t shapes_set = 0;  ///< shapes that were set in the scene before this step, in all
  double clearance = 0;          ///< as of StepOptions
  std::vector<EnvironmentGap> environment_gaps;  ///< by mover, then part; empty without clearance
  std::vector<MoverGap> mover_gaps;              ///< by a, then b; likewise
  std::uint64_t gap_queries = 0;  ///< distances of two bodies queried; not in `queries`
  bool swept = false;             ///< as of StepOptions
  std::vector<EnvironmentPassage>
      environment_passages;                  ///< by mover, then part; empty unless swept
  std::vector<MoverPassage> mover_passages;  ///< by a, then b; likewise
  std::uint64_t passage_queries = 0;         ///< ways of two bodies queried; not in `queries`

  [[nodiscard]] bool operator==(const StepReport&) const = default;

  /// Movers that touch anything, ascending. \cost O(n log n), n contacts.
  [[nodiscard]] std::vector<MoverId> touching_movers() const;

  /// FNV-1a 64 over both lists of contacts as little-endian u32. Gaps and passages do not count, so
  /// a step with a clearance, or a swept one, has the hash of one without.
  [[nodiscard]] std::uint64_t hash() const;
};

template <>
struct Fields<StepReport> {
  static constexpr const char* kName = "StepReport";
  static constexpr const char* kMeaning =
      "What a step of a scene found: sorted arrays with named fields.";
  static constexpr auto kList = std::tuple(
      list("environment", &StepReport::environment, "n", "Movers that touch the environment."),
      list("movers", &StepReport::movers, "n", "Movers that touch each other, a < b."),
      field("coverage", &StepReport::coverage, "How much of the question is decided."),
      field("cost", &StepReport::cost, "Work done."),
      field("queries", &StepReport::queries, "Pairs of bodies that were compared."),
      field("box_pairs", &StepReport::box_pairs, "Pairs of bodies whose boxes meet."),
      field("scope", &StepReport::scope, "What was requested."),
      field("mover_mover", &StepReport::mover_mover, "Movers were compared with each other."),
      field("shapes_set", &StepReport::shapes_set,
            "Shapes that were set in the scene before this step, in all."),
      field("clearance", &StepReport::clearance, "That was requested."),
      list("environment_gaps", &StepReport::environment_gaps, "n",
           "Movers within the clearance of the environment."),
      list("mover_gaps", &StepReport::mover_gaps, "n",
           "Movers within the clearance of each other, a < b."),
      field("gap_queries", &StepReport::gap_queries,
            "Pairs of bodies whose distance was computed; not in queries."),
      field("swept", &StepReport::swept, "Ways from the last step were looked at."),
      list("environment_passages", &StepReport::environment_passages, "n",
           "Movers that touch the environment on their way."),
      list("mover_passages", &StepReport::mover_passages, "n",
           "Movers that touch each other on their way, a < b."),
      field("passage_queries", &StepReport::passage_queries,
            "Pairs of bodies whose ways were compared; not in queries."));
};

}  // namespace soms
