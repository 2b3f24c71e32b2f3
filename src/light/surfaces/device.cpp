// SPDX-License-Identifier: Apache-2.0
#include "ideotype/light/device.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "embree_handle.hpp"
#include "ideotype/core/error.hpp"

namespace ideotype {

void require_no_error(RTCDeviceTy* device, const std::string& action) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    throw std::runtime_error(
        fmt::format("Embree cannot {} ({})", action,
                    error == RTC_ERROR_OUT_OF_MEMORY
                        ? "not enough memory"
                        : fmt::format("error {}", static_cast<int>(error))));
}

namespace {

//! @throws std::runtime_error if creation fails. After a failure for lack of
//! memory, creating a second device would block forever in TBB 2021.8.
RTCDevice new_device(const std::string& settings) {
    RTCDevice device = rtcNewDevice(settings.c_str());
    if (!device) require_no_error(nullptr, "create a device");
    return device;
}

}  // namespace

Device::Device(const std::string& isa) : isa_(isa) {
    const std::vector<std::string> supported = supported_isas();
    if (std::find(supported.begin(), supported.end(), isa) == supported.end())
        throw Error(fmt::format(
            "this processor has no instruction set '{}' (it has {}); results "
            "depend on it, so run on a machine that has it",
            isa, fmt::join(supported, ", ")));
    device_ = new_device("threads=1,set_affinity=0,isa=" + isa);
}

Device::~Device() {
    rtcReleaseDevice(device_);
}

std::vector<std::string> Device::supported_isas() {
    std::vector<std::string> isas{"sse2"};
    __builtin_cpu_init();
    if (__builtin_cpu_supports("sse4.2")) isas.push_back("sse4.2");
    if (__builtin_cpu_supports("avx")) isas.push_back("avx");
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        isas.push_back("avx2");
    if (__builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512cd") &&
        __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512vl"))
        isas.push_back("avx512");
    return isas;
}

std::string Device::library_version() {
    // This is the version of the loaded library, which may differ from that of
    // the headers.
    RTCDevice device = new_device("threads=1");
    const auto number = [&](RTCDeviceProperty property) {
        return rtcGetDeviceProperty(device, property);
    };
    const std::string version = fmt::format(
        "Embree {}.{}.{}", number(RTC_DEVICE_PROPERTY_VERSION_MAJOR),
        number(RTC_DEVICE_PROPERTY_VERSION_MINOR),
        number(RTC_DEVICE_PROPERTY_VERSION_PATCH));
    rtcReleaseDevice(device);
    return version;
}

}  // namespace ideotype
