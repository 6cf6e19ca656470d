/// \file
/// Hashes of what the library makes and answers: equal on every machine, compiler, optimization,
/// instruction set and number of threads.
#pragma once

#include "soms/base/hash.h"
#include "soms/base/limits.h"
#include "soms/base/portable.h"
#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"
#include "soms/query/overlap.h"
#include "soms/tree/layout/detail/wide_tree.h"
#include "soms/tree/shape.h"

#include "tests/support/truth/answer_row.h"
#include "tests/support/truth/probe_table.h"

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace soms::golden {

/// Names of what was hashed, with the hashes.
using Rows = std::map<std::string, std::uint64_t>;

template <class T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <class T>
concept Range = requires(const T& range) {
  range.begin();
};

/// A hash of values, one after the other.
class Hash {
 public:
  template <Scalar T>
  Hash& operator<<(T value) {
    if constexpr (std::is_same_v<T, float>) {
      hash_.add(bit_cast<std::uint32_t>(value));
    } else if constexpr (std::is_same_v<T, double>) {
      hash_.add(value);
    } else if constexpr (std::is_same_v<T, char>) {  // signed on x86, unsigned on ARM
      hash_.add(static_cast<std::uint64_t>(static_cast<signed char>(value)));
    } else {
      hash_.add(static_cast<std::uint64_t>(value));
    }
    return *this;
  }

  Hash& operator<<(std::string_view text);
  Hash& operator<<(const Vec3& v);
  Hash& operator<<(const Box& box);
  Hash& operator<<(const Pose& pose);
  Hash& operator<<(const Cost& cost);
  Hash& operator<<(const TrianglePair& pair);
  Hash& operator<<(const Mesh& mesh);
  Hash& operator<<(const Overlap& answer);
  Hash& operator<<(const WideTree& tree);

  template <Range T>
  Hash& operator<<(const T& range) {
    for (const auto& value : range) {
      *this << value;
    }
    return *this;
  }

  [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

 private:
  Fnv1a hash_;
};

/// Two models whose rows are made.
struct ModelPair {
  std::string first;
  std::string second;
  std::vector<Pose>
      near_poses;  ///< of the first, for questions of nearness; the last leave it free

  [[nodiscard]] std::string name() const { return first + "-" + second; }
};

/// A model at a pose, and what is queried about it there.
struct ProbedModel {
  std::string model;
  Pose pose;
  test::Probes probes;
};

/// What rows are made from that this program calculates itself.
struct Inputs {
  explicit Inputs(std::filesystem::path folder);

  std::filesystem::path data;          ///< tests/data
  std::vector<Vec3> points;            ///< nearly in one plane, four by four, at all scales
  std::vector<Triangle> triangles;     ///< two by two, on a small lattice and beside it
  std::vector<Pose> poses;             ///< near enough for models of size 1 to touch
  std::map<std::string, Mesh> models;  ///< small ones, of all scales
  std::vector<ModelPair> pairs;        ///< of the models
  std::vector<ProbedModel> probed;     ///< of the models, those of one model in a row
  std::map<std::string, Mesh> solids;  ///< closed bodies that touch in faces, edges and corners
  std::vector<ModelPair> solid_pairs;  ///< of these and closed models
  Mesh bent;                           ///< models["ring"], moved unevenly
};

/// All rows. Calls of the library only: what the host's settings would spoil stands in `Inputs`.
[[nodiscard]] Rows all_rows(const Inputs& inputs, int threads);

/// False in builds without pugixml, which lack the rows of COLLADA files.
[[nodiscard]] bool reads_collada();

/// The answers to one question, with all their bits, and what they cost.
class Answered {
 public:
  explicit Answered(const test::AnswerRow& row) : row_(row) {}

  void add(const test::Answer& answer) {
    row_.add_to(answers_, answer);
    costs_ << test::cost_of(answer);
  }

  /// Adds the rows "<question><kind> <subject>" and "<question><kind> cost <subject>".
  void write(const std::string& kind, const std::string& subject, Rows& rows) const {
    const std::string name = std::string(row_.name) + kind;
    rows[name + ' ' + subject] = answers_.value();
    rows[name + " cost " + subject] = costs_.value();
  }

 private:
  const test::AnswerRow& row_;
  Fnv1a answers_;
  Hash costs_;
};

/// The parts of `all_rows`.
void add_geometry(const Inputs& inputs, Rows& rows);
void add_files(const Inputs& inputs, Rows& rows);
void add_trees(const Inputs& inputs, const Limits& limits, Rows& rows);
void add_answers(const Inputs& inputs, const Limits& limits, Rows& rows);
void add_near_answers(const Inputs& inputs, const Limits& limits, Rows& rows);
void add_solid_answers(const Inputs& inputs, const Limits& limits, Rows& rows);
void add_probe_answers(const Inputs& inputs, const Limits& limits, Rows& rows);
void add_scene(const Limits& limits, Rows& rows);

}  // namespace soms::golden
