/// \file
/// `contains --csv`: sides of points as a table.
#pragma once

#include "soms/base/bracket.h"
#include "soms/query/contains.h"
#include "soms/query/contains_parts.h"
#include "soms/query/winding.h"

#include "apps/soms/answers/answer_columns.h"
#include "apps/soms/answers/answer_csv.h"
#include "apps/soms/probes/contains.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace soms::command {

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
      : csv(options.winding ? FieldCsv::of<Winding>(options.csv, "row")
                            : FieldCsv::of<Contains>(options.csv, "row")),
        columns(options.binary) {
    options.winding ? columns.begin<Winding>() : columns.begin<Contains>();
  }

  FieldCsv csv;
  AnswerArrays columns;
};

}  // namespace soms::command
