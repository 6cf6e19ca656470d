// Rows of the questions that ask how near two bodies are, a loop over the table of questions. Every
// number stands in them with all its bits. Work has rows of its own, "<question> cost <pair>",
// since a better engine may change it and must not change an answer.
#include "soms/query/distance.h"

#include "tests/golden/golden.h"
#include "tests/support/query_table.h"

#include <limits>

namespace soms::golden {

namespace {

/// The answers to one question at all poses, and their costs.
class Answered {
 public:
  Answered(const test::QueryRow& row, const Parallel& parallel) : row_(row), parallel_(parallel) {}

  void ask(const Body& a, const Body& b, double length) {
    const test::Answer answer = row_.ask(a, b, {.length = length}, parallel_);
    row_.add_to(answers_, answer);
    costs_ << test::cost_of(answer);
  }

  void write(const std::string& kind, const std::string& pair, Rows& rows) const {
    const std::string name = std::string(row_.name) + kind;
    rows[name + ' ' + pair] = answers_.value();
    rows[name + " cost " + pair] = costs_.value();
  }

 private:
  const test::QueryRow& row_;
  Parallel parallel_;
  Fnv1a answers_;
  Hash costs_;
};

void add_near_pair(const ModelPair& pair, const Inputs& inputs, const Parallel& parallel,
                   Rows& rows) {
  const Shape a(inputs.models.at(pair.first), {}, parallel);
  const Shape b(inputs.models.at(pair.second), {.build = {.rule = Rule::soms}}, parallel);
  const Shape compact(inputs.models.at(pair.second), {.layout = Layout::compact}, parallel);
  for (const test::QueryRow& row : test::query_table()) {
    if (!row.takes_length) {
      continue;  // overlap has rows of its own, of more kinds
    }
    Answered wide(row, parallel);
    Answered small(row, parallel);
    for (const Pose& pose : pair.near_poses) {
      const Body x(a, pose);
      const Bracket d = distance(x, Body(b), {}, parallel).distance;
      // At both ends of the bracket the decision is exact.
      for (const double length : {0.0, d.lower, d.upper, std::numeric_limits<double>::infinity()}) {
        wide.ask(x, Body(b), length);
        small.ask(x, Body(compact), length);
      }
    }
    wide.write("", pair.name(), rows);
    small.write(" compact", pair.name(), rows);
  }
}

}  // namespace

void add_near_answers(const Inputs& inputs, const Parallel& parallel, Rows& rows) {
  for (const ModelPair& pair : inputs.pairs) {
    add_near_pair(pair, inputs, parallel, rows);
  }
}

}  // namespace soms::golden
