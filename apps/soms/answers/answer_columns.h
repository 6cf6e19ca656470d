/// \file
/// Answers as columns of numbers, in a file of NumPy arrays: one row of a column for each answer.
///
/// Where an answer has none, a triangle is -1 and a coordinate nan. A list of each row's hits is
/// kept as its parts: row i has the hits from offsets[i] to before offsets[i + 1].
#pragma once

#include "soms/base/bracket.h"
#include "soms/geometry/georeference.h"
#include "soms/query/contains.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/solid.h"
#include "soms/query/within.h"

#include "apps/cli/verb.h"
#include "apps/output/npz_file.h"
#include "apps/soms/answers/answer_fields.h"
#include "apps/soms/pairs/overlap_parts.h"
#include "apps/soms/probes/closest_output.h"
#include "apps/soms/probes/ray_output.h"
#include "apps/soms/solid/solid_parts.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace soms::command {

/// Adds --binary.
void add_binary(Parser& parser, std::string& target);

/// A file of columns, if one is wanted.
class AnswerColumns {
 public:
  /// Opens the file, unless `path` is empty. \errors ErrorKind::cannot_write.
  explicit AnswerColumns(const std::string& path) {
    if (!path.empty()) {
      file_.emplace(path);
    }
  }

  /// Adds the array "georeference" of one text, as in CSV, if one is stated.
  void state(const Georeference& georeference) {
    if (file_ && !georeference.empty()) {
      file_->text("georeference", describe(georeference));
    }
  }

  /// Makes the file appear. \errors ErrorKind::cannot_write; ClosedPipe.
  void finish() {
    if (file_) {
      file_->finish();
    }
  }

 protected:
  using Kind = NpzColumn::Kind;

  std::optional<NpzFile> file_;
};

/// Nearest points of a model.
class PointColumns : public AnswerColumns {
 public:
  using AnswerColumns::AnswerColumns;

  /// Chooses the columns: those of lists, or of the nearest triangle; sides too.
  void begin(bool lists, bool sides);

  void add(const PointAnswer& answer);

 private:
  void add_list(const PointAnswer& answer);

  FieldColumns fields_;  ///< without lists
  NpzColumn* side_ = nullptr;
  NpzColumn* offsets_ = nullptr;
  NpzColumn* lower_ = nullptr;
  NpzColumn* upper_ = nullptr;
  NpzColumn* triangle_ = nullptr;
  NpzColumn* coverage_ = nullptr;
  std::int64_t hits_ = 0;
};

/// What rays hit.
class RayColumns : public AnswerColumns {
 public:
  using AnswerColumns::AnswerColumns;

  /// Chooses the columns of answers like this one.
  void begin(const RayAnswer& like);

  void add(const RayAnswer& answer);

 private:
  void add_row(const ClosestHit& hit);
  void add_row(const AnyHit& hit);
  void add_row(const Crossings& hits);

  FieldColumns fields_;  ///< of a hit
  NpzColumn* hit_ = nullptr;
  NpzColumn* offsets_ = nullptr;
  NpzColumn* lower_ = nullptr;
  NpzColumn* upper_ = nullptr;
  NpzColumn* kind_ = nullptr;
  NpzColumn* triangle_offsets_ = nullptr;
  NpzColumn* triangle_ = nullptr;
  NpzColumn* coverage_ = nullptr;
  std::int64_t crossings_ = 0;
  std::int64_t triangles_ = 0;
};

/// Answers whose arrays are their fields.
class AnswerArrays : public AnswerColumns {
 public:
  using AnswerColumns::AnswerColumns;

  /// Chooses the columns: the fields of T.
  template <Described T>
  void begin() {
    if (file_) {
      fields_.begin<T>(*file_);
    }
  }

  template <Described T>
  void add(const T& answer) {
    if (file_) {
      fields_.add(answer);
    }
  }

 private:
  FieldColumns fields_;
};

/// Relations of the parts of two models: a list a row, of those that are not clear.
class SolidPartColumns : public AnswerColumns {
 public:
  explicit SolidPartColumns(const std::string& path);

  /// The answer of a pose; `cut` by the deadline.
  void add(std::span<const SolidPair> pairs, bool cut);

 private:
  NpzColumn* offsets_ = nullptr;
  NpzColumn* parts_ = nullptr;
  NpzColumn* relation_ = nullptr;
  NpzColumn* surfaces_meet_ = nullptr;
  NpzColumn* why_ = nullptr;
  NpzColumn* coverage_ = nullptr;
  std::int64_t pairs_ = 0;
};

/// Which triangles or parts of two models overlap.
class OverlapColumns : public AnswerColumns {
 public:
  enum class List { none, triangles, parts };

  using AnswerColumns::AnswerColumns;

  /// Chooses the columns: of pairs of triangles, of parts, or of their number alone.
  void begin(List list);

  /// `parts` are those of the answer, where they are listed.
  void add(const Overlap& answer, std::span<const PartPair> parts);

 private:
  void add_triangles(const Overlap& answer);
  void add_parts(std::span<const PartPair> parts);

  List list_ = List::none;
  NpzColumn* any_ = nullptr;
  NpzColumn* offsets_ = nullptr;
  NpzColumn* pairs_ = nullptr;
  NpzColumn* parts_ = nullptr;
  NpzColumn* count_ = nullptr;
  NpzColumn* first_ = nullptr;
  NpzColumn* coverage_ = nullptr;
  std::int64_t listed_ = 0;
};

}  // namespace soms::command
