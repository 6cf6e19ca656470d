/// \file
/// Poses of --pose and --pose-b, row by row.
#pragma once

#include "soms/base/error.h"
#include "soms/base/pose.h"
#include "soms/io/poses.h"

#include "apps/output/temporary_file.h"
#include "apps/rows/shard.h"

#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace soms::command {

class Console;

/// What a file without rows is: an error where a pose is needed, no poses where each row is
/// answered.
enum class NoRows { refused, no_poses };

/// Poses of one option: a single one that serves all rows, or those of a file, one at a time. Rows
/// after the first are read when they are requested: the program that writes them may wait for
/// answers.
class PoseSource {
 public:
  /// The identity, for an option that is not given.
  PoseSource() : constant_(true) {}

  /// `text` is "x y z [qw qx qy qz]" or the path of a CSV file; "-" is standard input. A file of
  /// one row counts as a single pose; a note says where one has no rows and may have none.
  /// Ctrl-C and --timeout, of `console`, end the reading of rows.
  /// \errors As `parse_pose` (the message names `option`), `PoseReader` and `check_standard_input`;
  ///         ErrorKind::bad_file for a file without rows; timed_out.
  PoseSource(const std::string& option, const std::string& text, const Console& console,
             NoRows no_rows = NoRows::refused);

  /// The same, of these rows of a file of several. Those before are passed over in an array file,
  /// and read in others; errors name rows of the whole file.
  PoseSource(const std::string& option, const std::string& text, const Console& console,
             const RowRange& part);

  /// True if the option itself has the pose, and no file.
  [[nodiscard]] bool is_stated() const { return !reader_.has_value(); }

  /// True if one pose serves all rows. Of a file this reads the second row, and waits for it.
  /// \errors ErrorKind::cancelled; others wait until the row is requested.
  [[nodiscard]] bool is_constant();

  /// The next pose, or nothing at the end. A single pose never ends.
  /// \errors As `PoseReader::next`; ErrorKind::timed_out.
  [[nodiscard]] std::optional<Pose> next();

  /// True if `next` will not wait.
  [[nodiscard]] bool ready();

  /// Of the file, or of the option that states the pose; empty where nothing is given.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  void open(const std::string& path);
  std::optional<Pose> read();
  [[noreturn]] void fail(const Error& error) const;
  [[nodiscard]] Error of_whole_file(const Error& error) const;

  std::string name_;
  std::optional<TemporaryFile> part_;  ///< the rows that are read, as a file of their own
  std::uint64_t part_begin_ = 0;       ///< the first of them in the whole file
  const Console* console_ = nullptr;   ///< none where nothing is read
  std::optional<PoseReader> reader_;
  std::optional<Pose> first_ = Pose::identity();  ///< none: the file has no rows
  bool first_given_ = false;                      ///< by `next`
  std::optional<bool> constant_;                  ///< unknown until the second row is read
  std::optional<Pose> second_;                    ///< until `next` gives it
  std::exception_ptr error_;  ///< of the second row, thrown when it is requested
};

/// The rows that the file of an option has, read to the end unless it is an array file; nothing
/// where one pose serves all rows. \errors As `PoseSource`.
[[nodiscard]] std::optional<std::uint64_t> count_poses(const std::string& option,
                                                       const std::string& text,
                                                       const Console& console);

/// Poses of both bodies, row by row: two files of equal length, or one file and a single pose; two
/// single poses are one row.
class PosePairs {
 public:
  /// At most `most` of them.
  PosePairs(PoseSource a, PoseSource b,
            std::uint64_t most = std::numeric_limits<std::uint64_t>::max())
      : a_(std::move(a)), b_(std::move(b)), most_(most) {}

  /// True if no file has a pose: there is one row.
  [[nodiscard]] bool is_stated() const { return a_.is_stated() && b_.is_stated(); }

  /// True if there is one row. Waits for the second one of files. \errors As of
  /// `PoseSource::is_constant`.
  [[nodiscard]] bool is_single() { return a_.is_constant() && b_.is_constant(); }

  /// Where A's poses come from; where none is given, where B's come from.
  [[nodiscard]] const std::string& name_a() const {
    return a_.name().empty() ? b_.name() : a_.name();
  }

  /// The same for B.
  [[nodiscard]] const std::string& name_b() const {
    return b_.name().empty() ? a_.name() : b_.name();
  }

  /// True if `next` will not wait.
  [[nodiscard]] bool ready() { return rows_ == 0 || (a_.ready() && b_.ready()); }

  /// The next row, or nothing at the end.
  /// \errors As `PoseSource::next`; ErrorKind::bad_file when one file ends before the other.
  [[nodiscard]] std::optional<std::pair<Pose, Pose>> next();

 private:
  PoseSource a_;
  PoseSource b_;
  std::uint64_t most_;
  std::uint64_t rows_ = 0;
};

}  // namespace soms::command
