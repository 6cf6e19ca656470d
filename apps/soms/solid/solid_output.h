/// \file
/// `solid --csv`: relations as a table.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/query/solid.h"

#include "apps/soms/answers/answer_columns.h"
#include "apps/soms/answers/answer_csv.h"
#include "apps/soms/solid/solid_parts.h"

#include <cstdint>
#include <span>
#include <string>

namespace soms::command {

/// A row for each pair of parts that is not clear.
class SolidPartCsv : public AnswerCsv {
 public:
  explicit SolidPartCsv(const std::string& path);

  /// \errors ErrorKind::cannot_write; ClosedPipe.
  void add(std::uint64_t pose, const MeshView& a, const MeshView& b,
           std::span<const SolidPair> pairs);
};

/// Files of relations, opened before the models are read.
struct SolidFiles {
  FieldCsv csv;
  AnswerArrays columns;
};

/// The same of parts.
struct SolidPartFiles {
  SolidPartCsv csv;
  SolidPartColumns columns;
};

}  // namespace soms::command
