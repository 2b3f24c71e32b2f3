// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

struct RTCDeviceTy;

namespace ideotype {

//! The ray tracer, on one thread and with one instruction set. Whether a ray
//! that grazes an edge hits it may depend on the instruction set, which
//! histories record.
class Device {
  public:
    //! Starts the ray tracer. @throws Error if the processor lacks the
    //! instruction set.
    explicit Device(const std::string& isa);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    const std::string& isa() const { return isa_; }

    //! Returns the instruction sets that this processor supports, narrowest
    //! first: some of sse2, sse4.2, avx, avx2, avx512.
    static std::vector<std::string> supported_isas();

    //! Returns the name and version of the ray tracing library.
    static std::string library_version();

  private:
    friend class RayScene;
    std::string isa_;
    RTCDeviceTy* device_ = nullptr;
};

}  // namespace ideotype
