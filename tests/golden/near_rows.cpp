// Rows of the questions about how near two bodies are and how they stand to each other, loops over
// the table of questions. Work has rows of its own, "<question> cost <pair>", since a better engine
// may change it and must not change an answer.
#include "soms/query/distance.h"

#include "tests/golden/golden.h"
#include "tests/support/truth/query_table.h"

#include <limits>

namespace soms::golden {

namespace {

void add_near_pair(const ModelPair& pair, const Inputs& inputs, const Limits& limits, Rows& rows) {
  const Shape a(inputs.models.at(pair.first), {}, limits);
  const Shape b(inputs.models.at(pair.second), {.build = {.rule = Rule::soms}}, limits);
  const Shape compact(inputs.models.at(pair.second), {.layout = Layout::compact}, limits);
  for (const test::QueryRow& row : test::query_table()) {
    if (!row.takes_length) {
      continue;  // overlap has rows of its own, of more kinds
    }
    Answered wide(row);
    Answered small(row);
    for (const Pose& pose : pair.near_poses) {
      const Body x(a, pose);
      const Bracket d = distance(x, Body(b), {}, limits).distance;
      // At both ends of the bracket the decision is exact.
      for (const double length : {0.0, d.lower, d.upper, std::numeric_limits<double>::infinity()}) {
        wide.add(row.ask(x, Body(b), {.length = length}, limits));
        small.add(row.ask(x, Body(compact), {.length = length}, limits));
      }
    }
    wide.write("", pair.name(), rows);
    small.write(" compact", pair.name(), rows);
  }
}

const Mesh& solid_named(const Inputs& inputs, const std::string& name) {
  const auto found = inputs.solids.find(name);
  return found == inputs.solids.end() ? inputs.models.at(name) : found->second;
}

}  // namespace

void add_solid_answers(const Inputs& inputs, const Limits& limits, Rows& rows) {
  const test::QueryRow& row = test::query_row("solid");
  for (const ModelPair& pair : inputs.solid_pairs) {
    const Mesh& mesh_b = solid_named(inputs, pair.second);
    const Shape a(solid_named(inputs, pair.first), {}, limits);
    const Body b(Shape(mesh_b, {.build = {.rule = Rule::soms}}, limits));
    const Body compact(Shape(mesh_b, {.layout = Layout::compact}, limits));
    Answered wide(row);
    Answered small(row);
    for (const Pose& pose : pair.near_poses) {
      wide.add(row.ask(Body(a, pose), b, {}, limits));
      small.add(row.ask(Body(a, pose), compact, {}, limits));
    }
    wide.write("", pair.name(), rows);
    small.write(" compact", pair.name(), rows);
  }
}

void add_near_answers(const Inputs& inputs, const Limits& limits, Rows& rows) {
  for (const ModelPair& pair : inputs.pairs) {
    add_near_pair(pair, inputs, limits, rows);
  }
}

}  // namespace soms::golden
