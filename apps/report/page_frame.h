/// \file
/// What all pages with a scene begin and end with: title, warnings, figures, notes, scripts.
#pragma once

#include "apps/report/page.h"

#include <ostream>
#include <span>
#include <string_view>

namespace soms::report {

/// From the first line of the file to the lead, in the element of the first screen, which whoever
/// calls this closes. `style` follows the rules that all pages share.
void write_head(std::ostream& out, const Page& page, std::string_view style);

/// A box for each warning.
void write_warnings(std::ostream& out, const Page& page);

void write_facts(std::ostream& out, const Page& page);

/// The figures below the first screen, which is for the answer.
void write_folded_facts(std::ostream& out, const Page& page);

/// A drawing with its caption.
void write_figure(std::ostream& out, const Plot& plot);

void write_notes(std::ostream& out, const Page& page);

/// A script element of these pieces. `opening` is its first tag.
void write_pieces(std::ostream& out, std::string_view opening,
                  std::span<const std::string_view> pieces);

}  // namespace soms::report
