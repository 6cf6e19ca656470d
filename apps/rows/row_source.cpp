#include "apps/rows/row_source.h"

#include "soms/base/pose.h"
#include "soms/base/text.h"

#include "apps/cli/console.h"
#include "apps/cli/standard_input.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace soms::command {

RowSource::RowSource(const std::string& path, RowKind kind, const Console& console)
    : name_(path == "-" ? kStandardInputName : path),
      noun_(std::move(kind.noun)),
      console_(&console) {
  const std::string rows = noun_ + "s";
  if (path == "-") {
    check_standard_input(rows);
  }
  try {
    reader_.emplace(path == "-" ? std::string(kStandardInput) : path, rows, std::move(kind.headers),
                    console_->limited());
  } catch (const Error& error) {
    fail(error);
  }
}

std::optional<std::span<const double>> RowSource::read() {
  try {
    const auto row = reader_->next();
    if (!row && read_ == 0 && !reported_) {
      reported_ = true;
      console_->note(printable(name_) + ": no rows");
    }
    read_ += row ? 1U : 0U;
    return row;
  } catch (const Error& error) {
    fail(error);
  }
}

/// Throws what the reader threw, in the words of these rows.
void RowSource::fail(const Error& error) const {
  if (error.kind() == ErrorKind::cancelled && !console_->interrupted()) {
    throw Error(ErrorKind::timed_out,
                fmt::format("out of time while reading {}s from {}", noun_, name_),
                "allow more time with --timeout");
  }
  if (name_ == kStandardInputName) {
    throw of_standard_input(error);
  }
  if (error.kind() == ErrorKind::cannot_open) {
    throw Error(
        error.kind(), error.place(),
        fmt::format("name a CSV, .npy or .npz file of {}s, or - for standard input", noun_));
  }
  throw error;
}

void RowSource::refuse(ErrorKind kind, const std::string& what, const std::string& remedy) const {
  throw Error(kind, fmt::format("{}: {} {}: {}", name_, noun_, given_ - 1, what), remedy);
}

Vec3 RowSource::point_of(std::span<const double> row, std::size_t first) const {
  for (std::size_t i = first; i < first + 3; ++i) {
    if (std::abs(row[i]) > kMaxCoordinate) {
      refuse(ErrorKind::out_of_range, fmt::format("{} exceeds 2^300", reader_->columns()[i].name),
             fmt::format("scale the model and the {}s", noun_));
    }
  }
  return {row[first], row[first + 1], row[first + 2]};
}

std::optional<std::span<const double>> RowSource::next_row() {
  if (!ahead_.empty()) {
    row_ = std::move(ahead_.front());
    ahead_.pop_front();
    ++given_;
    return row_;
  }
  if (error_) {
    std::rethrow_exception(error_);
  }
  const auto row = single_.value_or(false) ? std::nullopt : read();
  given_ += row ? 1U : 0U;
  return row;
}

bool RowSource::ready() {
  return !ahead_.empty() || error_ || single_.value_or(false) || reader_->ready();
}

bool RowSource::is_single() {
  if (!single_) {
    try {
      while (ahead_.size() < 2) {
        const auto row = read();
        if (!row) {
          break;
        }
        ahead_.emplace_back(row->begin(), row->end());
      }
      single_ = ahead_.size() == 1;
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::cancelled) {
        throw;
      }
      error_ = std::current_exception();
      single_ = false;
    }
  }
  return *single_;
}

}  // namespace soms::command
