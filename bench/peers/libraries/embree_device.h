/// \file
/// One Embree device for all: one thread, its memory counted.
#pragma once

#include <embree3/rtcore.h>

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

}  // namespace soms::bench
