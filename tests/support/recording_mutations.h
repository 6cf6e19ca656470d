/// \file
/// Recordings that were changed in their structure: numbers at limits, chunks that lack or double
/// something. All checksums are good, so that the content is read.
#pragma once

#include "soms/base/random.h"
#include "soms/scene/detail/recording_format.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {

/// A chunk of a recording, without checksums.
struct RecordedChunk {
  std::string tag;
  std::uint32_t frames = 0;
  std::uint64_t first = 0;
  std::string content;
};

/// The chunks of a whole recording.
[[nodiscard]] inline std::vector<RecordedChunk> chunks_of(const std::string& bytes) {
  std::vector<RecordedChunk> chunks;
  for (std::size_t at = detail::kFileHeadSize; at < bytes.size();) {
    const char* const head = bytes.data() + at;
    const auto length = static_cast<std::size_t>(detail::get<std::uint64_t>(head + 16));
    chunks.push_back({bytes.substr(at, 4), detail::get<std::uint32_t>(head + 4),
                      detail::get<std::uint64_t>(head + 8),
                      bytes.substr(at + detail::kChunkHeadSize, length)});
    at += detail::kChunkHeadSize + length + detail::kCheckSize;
  }
  return chunks;
}

/// A recording of these chunks, with the head of the file `whole`.
[[nodiscard]] inline std::string recording_of(const std::string& whole,
                                              const std::vector<RecordedChunk>& chunks) {
  std::string bytes = whole.substr(0, detail::kFileHeadSize);
  for (const RecordedChunk& chunk : chunks) {
    std::string head = chunk.tag;
    detail::put(head, chunk.frames);
    detail::put(head, chunk.first);
    detail::put(head, static_cast<std::uint64_t>(chunk.content.size()));
    detail::put(head, detail::hash_of(head));
    bytes += head + chunk.content;
    detail::put(bytes, detail::hash_of(chunk.content));
  }
  return bytes;
}

/// Where the numbers of a chunk's content stand: first byte and size.
using NumberPlaces = std::vector<std::pair<std::size_t, std::size_t>>;

/// Goes through a content that is whole.
class NumberCursor {
 public:
  explicit NumberCursor(const std::string& content) : content_(content) {}

  [[nodiscard]] bool at_end() const { return at_ >= content_.size(); }

  [[nodiscard]] NumberPlaces places() && { return std::move(places_); }

  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t k = size; k-- > 0;) {
      value = value << 8 | static_cast<unsigned char>(content_.at(at_ + k));
    }
    places_.emplace_back(at_, size);
    at_ += size;
    return value;
  }

  void numbers(std::uint64_t count, std::size_t size) {
    for (; count > 0; --count) {
      number(size);
    }
  }

  void text() { at_ += static_cast<std::size_t>(number(4)); }

  void mesh() {
    text();
    numbers(2, 1);
    text();
    numbers(7, 8);
  }

 private:
  const std::string& content_;
  std::size_t at_ = 0;
  NumberPlaces places_;
};

/// The numbers of a head, as docs/recording.md describes it.
[[nodiscard]] inline NumberPlaces numbers_of_head(const std::string& content) {
  NumberCursor cursor(content);
  cursor.text();
  cursor.numbers(2, 8);
  for (std::uint64_t bodies = cursor.number(4); bodies > 0; --bodies) {
    cursor.mesh();
    cursor.numbers(12, 8);
  }
  for (std::uint64_t models = cursor.number(4); models > 0; --models) {
    cursor.mesh();
  }
  cursor.numbers(cursor.number(4), 4);
  if (!cursor.at_end()) {
    cursor.number(8);
  }
  return std::move(cursor).places();
}

/// The numbers of frames, of so many movers.
[[nodiscard]] inline NumberPlaces numbers_of_frames(const std::string& content, std::size_t movers,
                                                    bool gaps, bool passages) {
  NumberCursor cursor(content);
  while (!cursor.at_end()) {
    for (std::size_t k = 0; k < movers; ++k) {
      for (std::uint64_t changed = cursor.number(2); changed != 0; changed &= changed - 1) {
        cursor.number(8);
      }
    }
    for (int k = 0; k < 2; ++k) {
      cursor.numbers(4 * cursor.number(8), 4);
    }
    for (int k = 0; gaps && k < 2; ++k) {
      for (std::uint64_t count = cursor.number(8); count > 0; --count) {
        cursor.numbers(4, 4);
        cursor.numbers(8, 8);
      }
    }
    for (int k = 0; passages && k < 2; ++k) {
      for (std::uint64_t count = cursor.number(8); count > 0; --count) {
        cursor.numbers(4, 4);
        cursor.number(1);
        cursor.numbers(5, 8);
      }
    }
  }
  return std::move(cursor).places();
}

/// A number that is at a limit of whole numbers, of doubles, or of counts in a small file.
[[nodiscard]] inline std::uint64_t any_number(Rng& rng) {
  using Limits = std::numeric_limits<double>;
  constexpr std::array kReals{0.0,
                              -0.0,
                              1.0,
                              -1.0,
                              0.5,
                              Limits::denorm_min(),
                              Limits::max(),
                              1e300,
                              1e-3,
                              60.0,
                              Limits::infinity(),
                              Limits::quiet_NaN()};
  constexpr std::array<std::uint64_t, 10> kWhole{
      0, 1, 2, 3, 0x7f, 0xff, 0x7fffffff, 0xffffffffU, std::uint64_t{1} << 63, ~std::uint64_t{0}};
  return rng.below(2) == 0 ? bit_cast<std::uint64_t>(kReals[rng.below(kReals.size())])
                           : kWhole[rng.below(kWhole.size())];
}

/// Gives a number of a content another value, or one that is a little off.
inline void mutate_number(std::string& content, const NumberPlaces& places, Rng& rng) {
  if (places.empty()) {
    return;
  }
  const auto& [at, size] = places[rng.below(places.size())];
  std::uint64_t value = any_number(rng);
  if (rng.below(3) == 0) {
    value = static_cast<unsigned char>(content[at]) ^ (1U << rng.below(8));
    for (std::size_t k = 1; k < size; ++k) {
      value |= std::uint64_t{static_cast<unsigned char>(content[at + k])} << (8 * k);
    }
  }
  for (std::size_t k = 0; k < size; ++k) {
    content[at + k] = static_cast<char>(static_cast<unsigned char>(value >> (8 * k)));
  }
}

/// Bytes left out, doubled or put in.
inline void mutate_bytes(std::string& content, Rng& rng) {
  if (content.empty()) {
    content.assign(1 + rng.below(8), static_cast<char>(rng.below(256)));
    return;
  }
  const std::size_t at = rng.below(content.size());
  switch (rng.below(3)) {
    case 0:
      content.erase(at, 1 + rng.below(16));
      break;
    case 1:
      content.insert(at, content.substr(at, 1 + rng.below(16)));
      break;
    default:
      content[at] = static_cast<char>(rng.below(256));
  }
}

/// A chunk left out, doubled, exchanged with the next one, or saying something else of itself.
inline void mutate_chunks(std::vector<RecordedChunk>& chunks, Rng& rng) {
  const std::size_t at = rng.below(chunks.size());
  switch (rng.below(6)) {
    case 0:
      chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      chunks.insert(chunks.begin() + static_cast<std::ptrdiff_t>(at), RecordedChunk(chunks[at]));
      break;
    case 2:
      std::swap(chunks[at], chunks[(at + 1) % chunks.size()]);
      break;
    case 3:
      chunks[at].frames = static_cast<std::uint32_t>(any_number(rng));
      break;
    case 4:
      chunks[at].first = any_number(rng);
      break;
    default:
      chunks[at].tag = chunks[rng.below(chunks.size())].tag;
  }
}

/// A recording with one to three changes. `places` are the numbers of each chunk's content.
[[nodiscard]] inline std::string changed_recording(const std::string& whole,
                                                   const std::vector<NumberPlaces>& places,
                                                   Rng& rng) {
  std::vector<RecordedChunk> chunks = chunks_of(whole);
  for (std::uint64_t changes = 1 + rng.below(3); changes > 0; --changes) {
    const std::size_t at = rng.below(chunks.size());
    mutate_number(chunks[at].content, places[at], rng);
  }
  if (rng.below(6) == 0) {
    mutate_bytes(chunks[rng.below(chunks.size())].content, rng);
  }
  if (rng.below(6) == 0) {
    mutate_chunks(chunks, rng);
  }
  std::string bytes = recording_of(whole, chunks);
  if (rng.below(8) == 0) {
    mutate_bytes(bytes, rng);
  }
  return bytes;
}

}  // namespace soms::test
