// SPDX-License-Identifier: Apache-2.0
//! Measures how many rays Embree alone can trace in this scene: it has the
//! faces of the cell and of its neighbours, but rays are not wrapped, scattered
//! or counted. This is the only file outside src/light that uses Embree.
#include <cmath>
#include <type_traits>
#include <vector>

#include <benchmark/benchmark.h>

#include "stand.hpp"
#include "surfaces/embree_handle.hpp"

namespace ideotype {

namespace {

//! The faces of the cell, and those faces of neighbouring cells that reach into
//! it.
class RawScene {
  public:
    RawScene(const Field& field, RTCSceneFlags flags, RTCBuildQuality quality)
        : device_(rtcNewDevice("threads=1,set_affinity=0")),
          scene_(rtcNewScene(device_)) {
        for (const auto& face : field.mesh.faces)
            for (int i = -1; i <= 1; ++i)
                for (int j = -1; j <= 1; ++j) add(field, face, i, j);
        rtcSetSceneFlags(scene_, flags);
        rtcSetSceneBuildQuality(scene_, quality);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_QUAD);
        rtcSetGeometryBuildQuality(geometry, quality);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                   RTC_FORMAT_FLOAT3, corners_.data(), 0,
                                   sizeof corners_[0], corners_.size());
        auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
            4 * sizeof(unsigned), corners_.size() / 4));
        for (unsigned i = 0; i < corners_.size(); ++i) indices[i] = i;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~RawScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    RawScene(const RawScene&) = delete;
    RawScene& operator=(const RawScene&) = delete;

    RTCScene scene() const { return scene_; }

  private:
    void add(const Field& field, const std::array<std::uint32_t, 4>& face,
             int i, int j) {
        std::array<std::array<float, 4>, 4> quad{};
        bool is_inside[4] = {};
        for (std::size_t k = 0; k < 4; ++k) {
            const glm::dvec3& v = field.mesh.vertices[face[k]];
            const double x = v.x + i * field.cell.period_x;
            const double y = v.y + j * field.cell.period_y;
            quad[k] = {static_cast<float>(x), static_cast<float>(y),
                       static_cast<float>(v.z), 0};
            is_inside[0] |= x >= 0;
            is_inside[1] |= x <= field.cell.period_x;
            is_inside[2] |= y >= 0;
            is_inside[3] |= y <= field.cell.period_y;
        }
        if (is_inside[0] && is_inside[1] && is_inside[2] && is_inside[3])
            corners_.insert(corners_.end(), quad.begin(), quad.end());
    }

    RTCDevice device_;
    RTCScene scene_;
    std::vector<std::array<float, 4>> corners_;
};

//! Traces parallel sunrays, in tiles of 4 x 4, that enter through a square at
//! the top.
struct Rays {
    static constexpr int side = 512;

    explicit Rays(const Field& field) {
        constexpr int tile = 4;
        for (int b = 0; b < side * side / (tile * tile); ++b)
            for (int t = 0; t < tile * tile; ++t) {
                const int x = b % (side / tile) * tile + t % tile;
                const int y = b / (side / tile) * tile + t / tile;
                origins.push_back(
                    {static_cast<float>((x + 0.5) / side * field.cell.period_x),
                     static_cast<float>((y + 0.5) / side *
                                        field.cell.period_y)});
            }
    }

    static constexpr float top = 2.5f;
    std::array<float, 3> direction{0.28f, 0.21f, -0.94f};
    std::vector<std::array<float, 2>> origins;
};

//! Writes the ray with the given number into a lane of a packet.
template <class RayHit>
void set_lane(RayHit& packet, std::size_t lane, const Rays& rays,
              std::size_t number) {
    auto& ray = packet.ray;
    ray.org_x[lane] = rays.origins[number][0];
    ray.org_y[lane] = rays.origins[number][1];
    ray.org_z[lane] = Rays::top;
    ray.dir_x[lane] = rays.direction[0];
    ray.dir_y[lane] = rays.direction[1];
    ray.dir_z[lane] = rays.direction[2];
    ray.tnear[lane] = 0;
    ray.tfar[lane] = 10;
    ray.time[lane] = 0;
    ray.mask[lane] = ~0u;
    ray.id[lane] = 0;
    ray.flags[lane] = 0;
    packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
}

//! Traces a packet of rays that are neighbours in space.
template <class RayHit>
void intersect_packet(const int* valid, RTCScene scene, RayHit& packet) {
    constexpr bool is_of_8 = std::is_same_v<RayHit, RTCRayHit8>;
#if IDEOTYPE_EMBREE >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    if constexpr (is_of_8)
        rtcIntersect8(valid, scene, &packet, &arguments);
    else
        rtcIntersect16(valid, scene, &packet, &arguments);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    if constexpr (is_of_8)
        rtcIntersect8(valid, scene, &context, &packet);
    else
        rtcIntersect16(valid, scene, &context, &packet);
#endif
}

template <class RayHit>
void trace_packets(benchmark::State& state) {
    constexpr std::size_t lanes = sizeof(RayHit::ray.org_x) / sizeof(float);
    const BenchStand stand(BenchStand::ames());
    const Field field = stand.field(stand.baseline);
    const RawScene raw(field, RTC_SCENE_FLAG_ROBUST, RTC_BUILD_QUALITY_MEDIUM);
    const Rays rays(field);
    alignas(64) int valid[lanes];
    std::fill(valid, valid + lanes, -1);
    for (auto _ : state)
        for (std::size_t i = 0; i < rays.origins.size(); i += lanes) {
            alignas(64) RayHit packet;
            for (std::size_t l = 0; l < lanes; ++l)
                set_lane(packet, l, rays, i + l);
            intersect_packet(valid, raw.scene(), packet);
            benchmark::DoNotOptimize(packet);
        }
    state.counters["rays"] =
        benchmark::Counter(static_cast<double>(rays.origins.size()),
                           benchmark::Counter::kIsIterationInvariantRate);
}

void raw_packets_8(benchmark::State& state) {
    trace_packets<RTCRayHit8>(state);
}
BENCHMARK(raw_packets_8)->Unit(benchmark::kMillisecond);

void raw_packets_16(benchmark::State& state) {
    trace_packets<RTCRayHit16>(state);
}
BENCHMARK(raw_packets_16)->Unit(benchmark::kMillisecond);

//! The order in which rays are traced. In tiles, consecutive rays are
//! neighbours in space.
enum class Order { tiles, shuffled };

void trace_single(benchmark::State& state, RTCSceneFlags flags,
                  RTCBuildQuality quality, Order order) {
    const BenchStand stand(BenchStand::ames());
    const Field field = stand.field(stand.baseline);
    const RawScene raw(field, flags, quality);
    const Rays rays(field);
    // The stride is coprime to the number of rays, so that each ray is visited
    // exactly once.
    const std::size_t stride = order == Order::tiles ? 1 : 100003;
    for (auto _ : state)
        for (std::size_t i = 0; i < rays.origins.size(); ++i) {
            const auto& origin = rays.origins[i * stride % rays.origins.size()];
            RTCRayHit query{};
            query.ray = {origin[0],
                         origin[1],
                         Rays::top,
                         0,
                         rays.direction[0],
                         rays.direction[1],
                         rays.direction[2],
                         0,
                         10,
                         ~0u,
                         0,
                         0};
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            intersect_first(raw.scene(), query);
            benchmark::DoNotOptimize(query);
        }
    state.counters["rays"] =
        benchmark::Counter(static_cast<double>(rays.origins.size()),
                           benchmark::Counter::kIsIterationInvariantRate);
}

constexpr auto medium = RTC_BUILD_QUALITY_MEDIUM;
constexpr auto robust = RTC_SCENE_FLAG_ROBUST;
constexpr auto robust_compact = static_cast<RTCSceneFlags>(
    int{RTC_SCENE_FLAG_ROBUST} | int{RTC_SCENE_FLAG_COMPACT});

BENCHMARK_CAPTURE(trace_single, tiles, robust, medium, Order::tiles)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace_single, shuffled, robust, medium, Order::shuffled)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace_single, shuffled_low, robust, RTC_BUILD_QUALITY_LOW,
                  Order::shuffled)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace_single, shuffled_high, robust, RTC_BUILD_QUALITY_HIGH,
                  Order::shuffled)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace_single, shuffled_not_robust, RTC_SCENE_FLAG_NONE,
                  medium, Order::shuffled)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trace_single, shuffled_compact, robust_compact, medium,
                  Order::shuffled)
    ->Unit(benchmark::kMillisecond);

template <RTCBuildQuality quality>
void raw_build(benchmark::State& state) {
    const BenchStand stand(BenchStand::ames());
    const Field field = stand.field(stand.baseline);
    for (auto _ : state)
        benchmark::DoNotOptimize(RawScene(field, robust, quality).scene());
}
BENCHMARK(raw_build<RTC_BUILD_QUALITY_LOW>)->Unit(benchmark::kMillisecond);
BENCHMARK(raw_build<RTC_BUILD_QUALITY_MEDIUM>)->Unit(benchmark::kMillisecond);
BENCHMARK(raw_build<RTC_BUILD_QUALITY_HIGH>)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace ideotype
