/// \file
/// --only and --ignore: which parts of the models take part.
#pragma once

#include "soms/base/error.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace soms::command {

class Console;
class Parser;

/// A model without the parts that are left out.
struct PartsLeft {
  Mesh mesh;                        ///< parts have the numbers of the file; some have no triangles
  std::vector<TriangleId> numbers;  ///< in the file, of each triangle; ascending
  std::vector<std::uint32_t> vertices;  ///< likewise of each vertex
};

/// Patterns of shells (* ? [a-z]) for parts. A pattern fits a part by its name, id, type or path of
/// names ("storey/wall"), or if it fits a part around it. The filter takes the models of a verb one
/// by one, and then says how much is left.
class PartFilter {
 public:
  /// What is done with a model in which no pattern of --only fits.
  enum class Unnamed : std::uint8_t {
    left_out,  ///< as one of many files of one set
    whole      ///< as one of two models, of which the patterns name parts of the other
  };

  void keep_only(const std::string& pattern) { patterns_.push_back({pattern, true}); }

  void ignore(const std::string& pattern) { patterns_.push_back({pattern, false}); }

  void treat_unnamed(Unnamed unnamed) { unnamed_ = unnamed; }

  [[nodiscard]] bool is_given() const { return !patterns_.empty(); }

  /// The names of the options that were given: "--only and --ignore".
  [[nodiscard]] std::string options() const;

  /// The patterns of --only, or those of --ignore.
  [[nodiscard]] std::vector<std::string> patterns(bool only) const;

  /// The options as they are written: "--only a* --ignore b".
  [[nodiscard]] std::string text() const;

  /// What is left of a model; nothing if all of it is.
  [[nodiscard]] std::optional<PartsLeft> left_of(const MeshView& mesh);

  /// The same where nothing names triangles.
  [[nodiscard]] Mesh left(Mesh mesh);

  /// After the last model: says on standard error how much is left.
  /// \errors ErrorKind::usage for a pattern that fits nothing, and where nothing is left.
  void finish(const Console& console) const;

 private:
  struct Pattern {
    std::string text;
    bool only = false;
    bool used = false;
  };

  [[nodiscard]] std::vector<bool> fitting(const MeshView& mesh, bool only);
  [[nodiscard]] std::vector<TriangleId> numbers_left(const MeshView& mesh);
  [[nodiscard]] Error no_part_fits(const Pattern& pattern) const;

  std::vector<Pattern> patterns_;
  std::set<std::string> names_;  ///< of the parts of all models
  std::uint64_t triangles_ = 0;  ///< of all models
  std::uint64_t left_ = 0;
  Unnamed unnamed_ = Unnamed::left_out;
};

/// Drops parts that have no triangles, also none in parts inside of them.
void drop_empty_parts(Mesh& mesh);

/// Adds --only and --ignore; `whose` parts, as "the city".
void add_part_filter(Parser& parser, std::shared_ptr<PartFilter>& filter, const std::string& whose);

}  // namespace soms::command
