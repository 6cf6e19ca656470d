#include "soms/io/robot.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/io/detail/file.h"
#include "soms/io/detail/left_out.h"
#include "soms/io/detail/source.h"
#include "soms/io/encoding.h"
#ifdef SOMS_USE_PUGIXML
#include "soms/io/detail/robot/srdf.h"
#include "soms/io/detail/robot/urdf.h"
#endif

#include <cmath>
#include <new>
#include <optional>
#include <string_view>
#include <utility>

namespace soms {

namespace {

void check(const RobotReadOptions& options) {
  if (!(options.tessellation_error > 0) || !std::isfinite(options.tessellation_error)) {
    throw Error(ErrorKind::usage, "the error of round shapes is not a positive number",
                "give a length such as 0.0005");
  }
}

void refuse_xacro(const std::string& name) {
  if (name.ends_with(".xacro")) {
    throw Error(ErrorKind::unsupported, name + ": a xacro file, whose macros are not expanded",
                "run xacro on it first, and give the URDF or SRDF file that it writes");
  }
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Runs `read` and says what is missing where memory runs out.
template <class Read>
auto within_memory(const std::string& name, const Limits& limits, const Read& read) {
  try {
    check(limits);
    return read();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::out_of_memory, name + ": not enough free memory on this machine",
                "free some memory, or use smaller meshes");
  }
}

#ifdef SOMS_USE_PUGIXML

/// Of memory for shapes and for copies of meshes, beside 64 times the file.
constexpr std::uint64_t kRobotAllowance = std::uint64_t{1} << 30;

detail::Source source_of(std::string_view bytes, const std::string& name,
                         std::optional<std::filesystem::path> folder,
                         const RobotReadOptions& options, const Limits& limits) {
  const std::uint64_t limit =
      options.max_memory > 0 ? options.max_memory : kRobotAllowance + 64 * bytes.size();
  detail::Source source{.bytes = bytes,
                        .name = name,
                        .folder = std::move(folder),
                        .budget = detail::Budget(limit),
                        .limits = limits};
  refuse_utf16(bytes, name);
  detail::skip_byte_order_mark(source);
  return source;
}

void refuse_notes(const Robot& robot, const RobotReadOptions& options) {
  if (options.strict && !robot.notes.empty()) {
    throw Error(ErrorKind::bad_file, robot.source + ": " + detail::joined(robot.notes),
                "repair the file, or read it without `strict`");
  }
}

Robot read_text(std::string_view text, const std::string& name,
                std::optional<std::filesystem::path> folder, const RobotReadOptions& options,
                const Limits& limits) {
  const PlainArithmetic plain;
  check(options);
  detail::Source source = source_of(text, name, std::move(folder), options, limits);
  Robot robot = detail::read_urdf(source, options);
  if (!options.srdf.empty()) {
    read_semantics(robot, options.srdf, options, limits);
  }
  refuse_notes(robot, options);
  return robot;
}

void read_semantics_text(Robot& robot, std::string_view text, const std::string& name,
                         const RobotReadOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  detail::Source source = source_of(text, name, std::nullopt, options, limits);
  detail::read_srdf(source, robot);
  refuse_notes(robot, options);
}

#else

[[noreturn]] void refuse(const std::string& name) {
  throw Error(ErrorKind::unsupported, name + ": this build of soms reads no URDF and no SRDF",
              "build it with SOMS_USE_PUGIXML=ON");
}

Robot read_text(std::string_view, const std::string& name, std::optional<std::filesystem::path>,
                const RobotReadOptions& options, const Limits&) {
  check(options);
  refuse(name);
}

void read_semantics_text(Robot&, std::string_view, const std::string& name, const RobotReadOptions&,
                         const Limits&) {
  refuse(name);
}

#endif

}  // namespace

Robot read_robot(const std::filesystem::path& path, const RobotReadOptions& options,
                 const Limits& limits) {
  refuse_xacro(path.string());
  return within_memory(path.string(), limits, [&] {
    const detail::FileBytes bytes = detail::read_file(path, options.max_memory, limits);
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    return read_text(bytes.view(), path.string(), folder, options, limits);
  });
}

Robot read_robot(std::span<const std::byte> bytes, const std::string& name,
                 const RobotReadOptions& options, const Limits& limits) {
  return within_memory(
      name, limits, [&] { return read_text(text_of(bytes), name, std::nullopt, options, limits); });
}

void read_semantics(Robot& robot, const std::filesystem::path& path,
                    const RobotReadOptions& options, const Limits& limits) {
  refuse_xacro(path.string());
  within_memory(path.string(), limits, [&] {
    const detail::FileBytes bytes = detail::read_file(path, options.max_memory, limits);
    read_semantics_text(robot, bytes.view(), path.string(), options, limits);
  });
}

void read_semantics(Robot& robot, std::span<const std::byte> bytes, const std::string& name,
                    const RobotReadOptions& options, const Limits& limits) {
  within_memory(name, limits,
                [&] { read_semantics_text(robot, text_of(bytes), name, options, limits); });
}

}  // namespace soms
