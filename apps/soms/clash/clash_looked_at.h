/// \file
/// What this list would have if it were still there: the rest of an older list is not resolved.
#pragma once

#include "apps/soms/clash/clash_listed.h"
#include "apps/soms/clash/clash_models.h"
#include "apps/soms/clash/clash_sets.h"

#include <optional>

namespace soms::command {

/// Tells of rows of an older list whether this run looked for them.
class LookedAt {
 public:
  /// All three must stay.
  LookedAt(const ClashModels& models, const ClashSetOptions& sets,
           const std::optional<double>& within);

  /// False of a row `near` whose gap exceeds what is near now, and of one whose parts are both
  /// there but not compared.
  [[nodiscard]] bool operator()(const Json& row) const;

 private:
  [[nodiscard]] bool is_left_out(const Json& row) const;

  const ClashModels& models_;
  const ClashSetOptions& sets_;
  const std::optional<double>& within_;
  MarkedParts of_a_;  ///< of no use where all are compared
  MarkedParts of_b_;
};

}  // namespace soms::command
