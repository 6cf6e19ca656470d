#include "apps/output/sha256.h"

#include <sha2.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

namespace soms::command {

namespace {

/// Takes bytes piece by piece.
class Sha256 {
 public:
  Sha256() { SHA256Init(&state_); }

  void add(std::string_view bytes) {
    SHA256Update(&state_, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }

  /// Of all that was added. Call once.
  std::string digits() {
    std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
    SHA256End(&state_, text.data());
    return text.data();
  }

 private:
  SHA2_CTX state_{};
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.digits();
}

std::string sha256_of_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  Sha256 hash;
  std::vector<char> piece(std::size_t{1} << 20U);
  while (in) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    hash.add({piece.data(), static_cast<std::size_t>(in.gcount())});
  }
  return in.eof() ? hash.digits() : std::string();
}

}  // namespace soms::command
