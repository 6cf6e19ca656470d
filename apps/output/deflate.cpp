#include "apps/output/deflate.h"

#include "soms/base/error.h"

#include <zlib.h>

#include <limits>

namespace soms::command {

namespace {

constexpr int kWindowBits = 15;
constexpr int kMemoryLevel = 8;

[[noreturn]] void throw_cannot_pack() {
  throw Error(ErrorKind::cannot_write, "zlib cannot pack a member of an archive",
              "free some memory");
}

}  // namespace

std::string deflated(std::string_view bytes, DeflateForm form) {
  if (bytes.size() > std::numeric_limits<uInt>::max() / 2) {
    throw_cannot_pack();
  }
  z_stream stream{};
  const int window = form == DeflateForm::raw ? -kWindowBits : kWindowBits;
  if (::deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, window, kMemoryLevel,
                     Z_DEFAULT_STRATEGY) != Z_OK) {
    throw_cannot_pack();
  }
  std::string packed(::deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  // zlib declares its input without const, and does not write to it.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int outcome = ::deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  ::deflateEnd(&stream);
  if (outcome != Z_STREAM_END) {
    throw_cannot_pack();
  }
  return packed;
}

}  // namespace soms::command
