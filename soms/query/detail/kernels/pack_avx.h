// Packing of pairs of lanes that survive, eight at a time. Included inside a namespace, after
// <immintrin.h>.

/// Which lanes of a set of eight come first, a byte each.
struct PackTable {
  std::array<std::uint64_t, 256> lanes = {};

  constexpr PackTable() {
    for (std::uint32_t set = 0; set < 256; ++set) {
      std::uint32_t to = 0;
      for (std::uint64_t lane = 0; lane < 8; ++lane) {
        if ((set >> lane & 1U) != 0) {
          lanes[set] |= lane << to;
          to += 8;
        }
      }
    }
  }
};

inline constexpr PackTable kPack;

inline void put(std::uint32_t set, __m256i x, __m256i y, std::uint32_t* to_x, std::uint32_t* to_y) {
  const __m256i lanes = _mm256_cvtepu8_epi32(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kPack.lanes.data() + set)));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to_x), _mm256_permutevar8x32_epi32(x, lanes));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to_y), _mm256_permutevar8x32_epi32(y, lanes));
}

/// Appends pairs of lanes, rotation by rotation; returns how many.
inline std::size_t put_all(std::uint32_t pairs, __m128i x, __m128i y, std::uint32_t* to_x,
                           std::uint32_t* to_y) {
  const __m256i twice_x = _mm256_broadcastsi128_si256(x);
  const __m256i turned01 = _mm256_setr_epi32(0, 1, 2, 3, 1, 2, 3, 0);
  const __m256i y01 = _mm256_permutevar8x32_epi32(_mm256_castsi128_si256(y), turned01);
  const std::uint32_t set01 = pairs & 0xff;
  put(set01, twice_x, y01, to_x, to_y);
  const auto at = static_cast<std::size_t>(std::popcount(set01));
  put(pairs >> 8, twice_x, _mm256_shuffle_epi32(y01, 0x4e), to_x + at, to_y + at);
  return static_cast<std::size_t>(std::popcount(pairs));
}
