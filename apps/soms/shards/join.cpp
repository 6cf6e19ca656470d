#include "apps/soms/shards/join.h"

#include "soms/base/error.h"
#include "soms/base/text.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/output/json.h"
#include "apps/output/output.h"
#include "apps/shards/npz_join.h"
#include "apps/shards/receipt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <tuple>
#include <vector>

namespace soms::command {

namespace {

/// True of shard-3.json.
bool is_receipt(std::string_view name) {
  constexpr std::string_view kEnd = ".json";
  if (!name.ends_with(kEnd)) {
    return false;
  }
  name.remove_suffix(kEnd.size());
  const std::size_t last = name.find_last_not_of("0123456789");
  return last != std::string_view::npos && name[last] == '-' && last + 1 < name.size();
}

/// The receipts of a folder, in the order of their rows.
std::vector<Receipt> receipts_of(const std::string& folder) {
  std::error_code failed;
  std::vector<Receipt> receipts;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    const std::string name = entry.path().filename().string();
    if (is_receipt(name)) {
      receipts.push_back(read_receipt(std::filesystem::path(folder) / name));
    }
  }
  if (failed) {
    throw Error(ErrorKind::cannot_open, folder + ": " + failed.message(),
                "give the folder that shards were written to");
  }
  if (receipts.empty()) {
    throw Error(ErrorKind::bad_file, folder + ": no receipt of a shard is there",
                "give the folder that shards were written to");
  }
  std::sort(receipts.begin(), receipts.end(), [](const Receipt& a, const Receipt& b) {
    return std::tuple(a.rows().begin, a.rows().end, a.path) <
           std::tuple(b.rows().begin, b.rows().end, b.path);
  });
  return receipts;
}

/// \errors ErrorKind::bad_file for receipts of several questions.
void check_question(std::span<const Receipt> receipts) {
  for (const Receipt& receipt : receipts.subspan(1)) {
    if (const auto key = difference(receipts.front().value, receipt.value)) {
      throw Error(ErrorKind::bad_file,
                  fmt::format("{}: is of another run than {}: its {} differs",
                              receipt.path.string(), receipts.front().path.string(), *key),
                  "give each run a folder of its own");
    }
  }
}

/// \errors ErrorKind::bad_file for rows that no shard has, and for rows that two have.
void check_rows(std::span<const Receipt> receipts, const std::string& folder) {
  const auto missing = [&](std::uint64_t begin, std::uint64_t end) {
    throw Error(ErrorKind::bad_file,
                fmt::format("{}: rows {} to {} are missing", folder, begin, end),
                "answer the shards that are missing, then join again");
  };
  std::uint64_t next = 0;
  for (const Receipt& receipt : receipts) {
    const RowRange rows = receipt.rows();
    if (rows.begin > next) {
      missing(next, rows.begin);
    }
    if (rows.begin < next || rows.end < rows.begin) {
      throw Error(ErrorKind::bad_file,
                  fmt::format("{}: rows {} to {}, some of which another shard has",
                              receipt.path.string(), rows.begin, rows.end),
                  "keep the shards of one N in the folder");
    }
    next = rows.end;
  }
  if (next != receipts.front().of()) {
    missing(next, receipts.front().of());
  }
}

/// The files of answers. \errors ErrorKind::bad_file for one that is not what its receipt says.
std::vector<std::filesystem::path> files_of(std::span<const Receipt> receipts,
                                            const std::string& kind) {
  std::vector<std::filesystem::path> files;
  for (const Receipt& receipt : receipts) {
    const std::vector<std::string> kinds = receipt.kinds();
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
      throw Error(ErrorKind::bad_file,
                  fmt::format("{}: its shard has no .{}", receipt.path.string(), kind),
                  fmt::format("join to .{}, or answer the shards with -o FILE.{}, too",
                              kinds.empty() ? "npz" : kinds.front(), kind));
    }
    if (!receipt.is_whole(kind)) {
      throw Error(ErrorKind::bad_file,
                  receipt.file(kind).string() + ": has not the bytes that its receipt states",
                  "answer this shard again");
    }
    files.push_back(receipt.file(kind));
  }
  return files;
}

/// Tables with one head.
void join_csv(std::span<const std::filesystem::path> parts, const std::string& path) {
  OutputFile out(path);
  std::string head;
  for (const std::filesystem::path& part : parts) {
    std::ifstream in(part, std::ios::binary);
    std::string line;
    std::getline(in, line);
    if (&part == &parts.front()) {
      head = line;
      out.stream() << head << '\n';
    } else if (line != head) {
      throw Error(ErrorKind::bad_file, part.string() + ": has other columns than the first shard",
                  "answer this shard again");
    }
    if (in.peek() != std::ifstream::traits_type::eof()) {
      out.stream() << in.rdbuf();
    }
  }
  out.commit();
}

}  // namespace

Action add_join(Parser& parser, Shared&) {
  const auto options = std::make_shared<JoinOptions>();
  parser.add_option("DIR", options->folder, "folder of shards")->required();
  add_output(parser, "-o,--output", options->output, "where to write the answer, .npz or .csv")
      ->required();
  parser.footer(
      "Puts together what --shard K/N of overlap, distance and within wrote: the bytes that one\n"
      "run without --shard writes. All shards must be there, whole, and of one question.\n\n"
      "Example:\n"
      "  soms generate knot --triangles 2000 -o knot.ply\n"
      "  soms generate sphere --triangles 800 -o ball.off\n"
      "  printf 'x,y,z\\n0.5,0,0\\n0,0.5,0\\n' > poses.csv\n"
      "  soms overlap knot.ply ball.off --pose poses.csv --shard 1/2 -o answers/shard.npz\n"
      "  soms overlap knot.ply ball.off --pose poses.csv --shard 2/2 -o answers/shard.npz\n"
      "  soms join answers -o answers.npz");
  return [options](Console& console) { return run_join(*options, console); };
}

int run_join(const JoinOptions& options, Console& console) {
  const std::string extension = extension_of(options.output);
  if (extension != ".npz" && extension != ".csv") {
    throw Error(ErrorKind::usage, "--output " + options.output,
                "use one of the extensions .npz, .csv");
  }
  const std::vector<Receipt> receipts = receipts_of(options.folder);
  check_question(receipts);
  check_rows(receipts, options.folder);
  const std::string kind = extension.substr(1);
  const std::vector<std::filesystem::path> files = files_of(receipts, kind);
  kind == "npz" ? join_npz(files, options.output) : join_csv(files, options.output);
  const std::uint64_t rows = receipts.front().of();
  if (console.shared().json) {
    console.print(json_line({{"schema", "soms.join/1"},
                             {"file", options.output},
                             {"rows", rows},
                             {"shards", std::uint64_t{receipts.size()}}}));
  } else {
    console.note(fmt::format("{}: {} of {}", printable(options.output), counted(rows, "row"),
                             counted(receipts.size(), "shard")));
  }
  return 0;
}

}  // namespace soms::command
