/// \file
/// How other libraries find which parts of two sets touch.
#pragma once

#include "bench/peers/libraries/library.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soms::bench {

/// A part of the first set and one of the second.
using PartPairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Two sets of parts, in the hands of one library. Its constructor does what is done once: trees of
/// parts and over parts.
class ClashPeer {
 public:
  virtual ~ClashPeer() = default;

  /// Appends the pairs whose surfaces share a point, in any order.
  virtual void find(PartPairs& pairs) = 0;
};

/// A library's way to find them.
struct ClashPeerMaker {
  std::string name;
  std::unique_ptr<ClashPeer> (*make)(std::span<const FloatMesh> a, std::span<const FloatMesh> b,
                                     const Loan& loan) = nullptr;
};

// Each adds what its library offers; they lie in a shared library of their own.
void add_fcl_clash(std::vector<ClashPeerMaker>& makers);
void add_occt_clash(std::vector<ClashPeerMaker>& makers);

}  // namespace soms::bench

/// All peers that were found when this was built.
extern "C" void soms_bench_clash_peers(std::vector<soms::bench::ClashPeerMaker>& makers);
