// Packing of pairs of lanes that survive, four at a time. Included inside a namespace, after
// <immintrin.h>.

/// Byte shuffles that bring the lanes of a set to the front.
struct PackTable {
  alignas(16) std::array<std::array<std::uint8_t, 16>, 16> bytes = {};

  constexpr PackTable() {
    for (std::size_t set = 0; set < 16; ++set) {
      std::size_t to = 0;
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if ((set >> lane & 1U) != 0) {
          for (std::size_t byte = 0; byte < 4; ++byte) {
            bytes[set][to++] = static_cast<std::uint8_t>(4 * lane + byte);
          }
        }
      }
    }
  }
};

inline constexpr PackTable kPack;

inline void put(std::uint32_t set, __m128i x, __m128i y, std::uint32_t* to_x, std::uint32_t* to_y) {
  const __m128i shuffle = _mm_load_si128(reinterpret_cast<const __m128i*>(kPack.bytes[set].data()));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to_x), _mm_shuffle_epi8(x, shuffle));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to_y), _mm_shuffle_epi8(y, shuffle));
}

/// Appends pairs of lanes, rotation by rotation; returns how many.
inline std::size_t put_all(std::uint32_t pairs, __m128i x, __m128i y, std::uint32_t* to_x,
                           std::uint32_t* to_y) {
  const auto number = [pairs](std::uint32_t mask) {
    return static_cast<std::size_t>(std::popcount(pairs & mask));
  };
  put(pairs & 0xf, x, y, to_x, to_y);
  std::size_t at = number(0xf);
  put(pairs >> 4 & 0xf, x, _mm_shuffle_epi32(y, 0x39), to_x + at, to_y + at);
  at = number(0xff);
  put(pairs >> 8 & 0xf, x, _mm_shuffle_epi32(y, 0x4e), to_x + at, to_y + at);
  at = number(0xfff);
  put(pairs >> 12 & 0xf, x, _mm_shuffle_epi32(y, 0x93), to_x + at, to_y + at);
  return number(0xffff);
}
