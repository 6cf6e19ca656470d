/// \file
/// `contains --csv`: sides of points as a table.
#pragma once

#include "soms/base/bracket.h"
#include "soms/query/contains.h"
#include "soms/query/contains_parts.h"

#include "apps/soms/answers/answer_columns.h"
#include "apps/soms/answers/answer_csv.h"
#include "apps/soms/probes/contains.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace soms::command {

/// A row for each point.
class SideCsv : public AnswerCsv {
 public:
  /// `winding`: with columns of the numbers.
  SideCsv(const std::string& path, bool winding);

  /// \errors ErrorKind::cannot_write; ClosedPipe.
  void add(std::uint64_t point, Side side, const std::optional<Bracket>& winding,
           Coverage coverage);
};

/// A row for each part that holds a point, inside or on its surface.
class PartSideCsv : public AnswerCsv {
 public:
  explicit PartSideCsv(const std::string& path);

  /// Row `k` of the answers is about `point`. \errors ErrorKind::cannot_write; ClosedPipe.
  void add(std::uint64_t point, const DividedBody& body, const ContainsPartsBatch& answers,
           std::size_t k);
};

/// Files of sides, opened before the model is read.
struct SideFiles {
  explicit SideFiles(const ContainsVerbOptions& options)
      : csv(options.csv, options.winding), columns(options.binary, options.winding) {}

  SideCsv csv;
  SideColumns columns;
};

}  // namespace soms::command
