/// \file
/// A clash list as a BCF archive: a topic a clash, with a viewpoint and a picture.
#pragma once

#include "apps/soms/clash/bcf_xml.h"
#include "apps/soms/clash/clash_rows.h"

#include <cstdint>
#include <ostream>
#include <string>

namespace soms::command {

class Console;

struct ClashBcfOptions {
  BcfVersion version = BcfVersion::v2_1;
  bool snapshots = true;
};

/// When an archive is said to be created, in seconds since 1970: SOURCE_DATE_EPOCH, where the
/// environment has it; else when the newest of the models was changed; 0 where nobody knows.
/// \errors ErrorKind::usage for a SOURCE_DATE_EPOCH that is no whole number of seconds.
[[nodiscard]] std::int64_t creation_time(const ClashModels& models);

/// As XML writes it: "1970-01-01T00:00:00Z".
[[nodiscard]] std::string xml_time(std::int64_t seconds);

/// Writes the archive, a few topics at a time. The same report, options and creation time give the
/// same bytes, whatever the number of threads.
/// \errors ErrorKind::cancelled; those of `creation_time`.
void write_clashes_as_bcf(const ClashReport& report, const ClashBcfOptions& options,
                          Console& console, std::ostream& out);

}  // namespace soms::command
