/// \file
/// One Embree device for all: one thread, its memory counted.
#pragma once

#include <embree3/rtcore.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace soms::bench {

class EmbreeDevice {
 public:
  EmbreeDevice() : device_(rtcNewDevice("threads=1,set_affinity=0")) {
    rtcSetDeviceMemoryMonitorFunction(
        device_,
        [](void* self, ssize_t bytes, bool) {
          static_cast<EmbreeDevice*>(self)->bytes_ += bytes;
          return true;
        },
        this);
  }

  ~EmbreeDevice() { rtcReleaseDevice(device_); }

  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  [[nodiscard]] RTCDevice get() const { return device_; }

  [[nodiscard]] std::ptrdiff_t bytes() const { return bytes_; }

  static EmbreeDevice& shared() {
    static EmbreeDevice device;
    return device;
  }

 private:
  RTCDevice device_;
  std::atomic<std::ptrdiff_t> bytes_{0};
};

/// Bytes that Embree takes from its making on and that malloc does not know of.
class UnseenBytes {
 public:
  [[nodiscard]] std::size_t taken() const {
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, unseen() - before_));
  }

 private:
  static std::ptrdiff_t unseen() {
    const auto info = mallinfo2();
    return EmbreeDevice::shared().bytes() -
           static_cast<std::ptrdiff_t>(info.uordblks + info.hblkhd);
  }

  std::ptrdiff_t before_ = unseen();
};

}  // namespace soms::bench
