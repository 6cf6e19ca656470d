#include "apps/output/deflate.h"

#include "soms/base/error.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::command {

namespace {

constexpr int kWindowBits = 15;
constexpr int kMemoryLevel = 8;
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;

void check(bool good) {
  if (!good) {
    throw Error(ErrorKind::cannot_write, "zlib cannot pack a file", "free some memory");
  }
}

}  // namespace

struct Deflater::Stream {
  z_stream zlib{};
};

Deflater::Deflater(DeflateForm form)
    : stream_(new Stream, [](Stream* stream) {
        ::deflateEnd(&stream->zlib);
        delete stream;
      }) {
  const int window = form == DeflateForm::raw ? -kWindowBits : kWindowBits;
  check(::deflateInit2(&stream_->zlib, Z_DEFAULT_COMPRESSION, Z_DEFLATED, window, kMemoryLevel,
                       Z_DEFAULT_STRATEGY) == Z_OK);
}

void Deflater::run(std::string_view bytes, int flush) {
  std::array<Bytef, 1 << 16> out;
  z_stream& stream = stream_->zlib;
  // zlib declares its input without const, and does not write to it.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  do {
    stream.next_out = out.data();
    stream.avail_out = static_cast<uInt>(out.size());
    check(::deflate(&stream, flush) != Z_STREAM_ERROR);
    packed_.append(reinterpret_cast<const char*>(out.data()), out.size() - stream.avail_out);
  } while (stream.avail_out == 0);
}

void Deflater::add(std::string_view bytes) {
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kMostAtOnce))) {
    run(bytes.substr(0, kMostAtOnce), Z_NO_FLUSH);
  }
}

std::string Deflater::finish() {
  run({}, Z_FINISH);
  return std::move(packed_);
}

std::string deflated(std::string_view bytes, DeflateForm form) {
  Deflater deflater(form);
  deflater.add(bytes);
  return deflater.finish();
}

}  // namespace soms::command
