#include "apps/soms/simulate/simulate_picture.h"

#include "soms/base/error.h"

#include "apps/cli/child.h"
#include "apps/output/output.h"
#include "apps/soms/shell/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace soms::command {

void check_picture_frame(const SimulateOptions& options) {
  const std::uint64_t frame = options.picture_frame.value_or(0);
  if (!options.picture.empty() && frame >= options.frames) {
    throw Error(ErrorKind::usage, fmt::format("picture of frame {} of {}", frame, options.frames),
                "frames count from 0");
  }
}

Picture::Picture(const SimulateOptions& options) : options_(options), recording_(options.record) {
  if (options.picture.empty()) {
    if (options.picture_frame) {
      throw Error(ErrorKind::usage, "--picture-frame without -o FILE.png", "give -o FILE.png");
    }
    return;
  }
  const bool kept = !recording_.empty() && recording_ != "/dev/null";
  std::error_code ignored;
  const std::filesystem::file_status there = std::filesystem::status(recording_, ignored);
  if (kept && std::filesystem::exists(there) && !std::filesystem::is_regular_file(there)) {
    throw Error(ErrorKind::usage,
                fmt::format("--record {} is not a regular file, which a picture needs", recording_),
                "record to a file, or leave one of the two out");
  }
  (void)viewer_program();
  { const OutputFile probe(options.picture); }
  if (!kept) {
    folder_.emplace("recording");
    recording_ = (folder_->path() / "run.somsrec").string();
  }
}

std::optional<int> Picture::draw(const Outcome& outcome, const Console& console) const {
  if (options_.picture.empty()) {
    return std::nullopt;
  }
  if (outcome.ending == Ending::interrupted || outcome.frames == 0) {
    console.note(outcome.ending == Ending::interrupted ? "no picture: interrupted"
                                                       : "no picture: out of time");
    return std::nullopt;
  }
  const std::uint64_t frame =
      std::min(options_.picture_frame.value_or(outcome.frames - 1), outcome.frames - 1);
  return draw_frame(recording_, frame, options_.picture, console);
}

}  // namespace soms::command
