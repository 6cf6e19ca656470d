/// \file
/// Where each option of the runs comes from, where the thesis contradicts itself, which of its
/// statements no run judges, and where its author said the same later.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {

/// How well what was available to us of the thesis supports an option.
enum class Basis {
  stated,   ///< said in the abstract or in chapter 1
  caption,  ///< follows from a caption or a heading
  ours,     ///< what was available to us is silent: a reconstruction
};

/// "stated", "caption", "ours".
[[nodiscard]] std::string_view name(Basis basis);

/// An option of the runs and what supports its value.
struct SourcedOption {
  std::string_view group;  ///< "rules", "trees", "counts", "traversals", "tests", "times", "models"
  std::string_view option;  ///< snake_case: "midpoint"
  std::string value;        ///< as the runs use it
  Basis basis = Basis::ours;
  std::string_view where;  ///< section or caption, and what it leaves open
};

/// All of them, by group.
[[nodiscard]] std::vector<SourcedOption> sourced_options();

/// Two places of the thesis that do not go together, or one place and what is known.
struct Contradiction {
  std::string_view subject;
  std::string_view one;      ///< what one place says
  std::string_view other;    ///< what the other says
  std::string_view outcome;  ///< what this run does about it
};

[[nodiscard]] std::span<const Contradiction> contradictions();

/// A statement of the thesis for which there is no claim with a matrix.
struct UnjudgedStatement {
  std::string_view words;      ///< of the thesis
  std::string_view where;      ///< "section 1.6"
  std::string_view why;        ///< there is no matrix
  std::string_view item = {};  ///< item of a run that shows what can be shown of it; may be empty
};

/// Statements about results in the abstract and in chapter 1. What chapter 1 says of the work of
/// others is left out.
[[nodiscard]] std::span<const UnjudgedStatement> unjudged_statements();

/// A later text of the thesis' author on the same subject.
struct Restatement {
  std::string_view text;     ///< authors, title, place, year
  std::string_view says;     ///< of SOMS or of what it rests on, in our words
  std::string_view settles;  ///< of what the thesis leaves open, or that it settles nothing
};

[[nodiscard]] std::span<const Restatement> restatements();

}  // namespace soms::reproduce
