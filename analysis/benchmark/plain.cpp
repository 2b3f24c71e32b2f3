// SPDX-License-Identifier: Apache-2.0
// A second light tracer for the benchmark alone. It shares no code with the
// program, tests every face in double precision, wraps paths at the sides of
// the cell, and requires only the standard library. plain.py compiles it and
// passes a case on standard input.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using Vector = std::array<double, 3>;

Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator-(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator*(double s, const Vector& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) {
    return 1 / std::sqrt(dot(a, a)) * a;
}

struct Face {
    std::size_t group;
    double weight;  //!< of its light in the weighted sum
    std::array<Vector, 4> corners;
    double upper, lower, transmittance;
};

struct Triangle {
    Vector corner, first, second;
    std::size_t face;
};

struct Scene {
    double x, y, albedo;
    std::size_t groups;
    std::vector<Face> faces;
    std::string light;  //!< sun, uniform or overcast
    double elevation, azimuth;
    std::vector<Triangle> tile;  //!< all images that reach into the cell
    double top = 0;
};

Scene read() {
    Scene scene;
    std::size_t count = 0;
    std::cin >> scene.x >> scene.y >> scene.albedo >> scene.light >>
        scene.elevation >> scene.azimuth >> scene.groups >> count;
    scene.faces.resize(count);
    for (Face& face : scene.faces) {
        std::cin >> face.group >> face.weight >> face.upper >> face.lower >>
            face.transmittance;
        for (Vector& corner : face.corners)
            std::cin >> corner[0] >> corner[1] >> corner[2];
    }
    return scene;
}

//! Adds those images of a triangle that reach into the cell.
void add_images(Scene& scene, std::size_t face, Vector a, Vector b, Vector c) {
    const auto span = [&](int axis, double period) {
        const auto [low, high] = std::minmax({a[axis], b[axis], c[axis]});
        return std::array{
            static_cast<int>(std::ceil(-high / period - 1e-9)),
            static_cast<int>(std::floor(1 - low / period + 1e-9))};
    };
    const auto xs = span(0, scene.x), ys = span(1, scene.y);
    for (int i = xs[0]; i <= xs[1]; ++i)
        for (int j = ys[0]; j <= ys[1]; ++j)
            scene.tile.push_back(
                {a + Vector{i * scene.x, j * scene.y, 0}, b - a, c - a, face});
    scene.top = std::max({scene.top, a[2], b[2], c[2]});
}

void lay_out(Scene& scene) {
    for (std::size_t i = 0; i < scene.faces.size(); ++i) {
        const auto& c = scene.faces[i].corners;
        add_images(scene, i, c[0], c[1], c[2]);
        add_images(scene, i, c[0], c[2], c[3]);
    }
    scene.top += 1e-3;
}

struct Ray {
    Vector from, along;
};

//! Returns the distance at which a ray hits a triangle, or infinity.
double distance(const Ray& ray, const Triangle& triangle) {
    const Vector p = cross(ray.along, triangle.second);
    const double determinant = dot(triangle.first, p);
    if (std::abs(determinant) < 1e-300) return INFINITY;
    const Vector s = ray.from - triangle.corner;
    const double u = dot(s, p) / determinant;
    if (u < 0 || u > 1) return INFINITY;
    const Vector q = cross(s, triangle.first);
    const double v = dot(ray.along, q) / determinant;
    if (v < 0 || u + v > 1) return INFINITY;
    return dot(triangle.second, q) / determinant;
}

struct Hit {
    enum class On { sky, soil, face } on;
    std::size_t face = 0;
};

//! Moves a ray to the surface that it hits next.
Hit next(const Scene& scene, Ray& ray) {
    double least = 1e-10;
    for (;;) {
        // The distance to the side of the cell, the soil or the top.
        double way = INFINITY;
        int side = 2;
        for (int axis = 0; axis < 3; ++axis) {
            const double d = ray.along[axis];
            if (d == 0) continue;
            const double size = axis == 0   ? scene.x
                                : axis == 1 ? scene.y
                                            : scene.top;
            const double t = ((d > 0 ? size : 0) - ray.from[axis]) / d;
            if (t < way) {
                way = t;
                side = axis;
            }
        }
        way = std::max(way, 0.0);
        double nearest = INFINITY;
        std::size_t face = 0;
        for (const Triangle& triangle : scene.tile) {
            const double t = distance(ray, triangle);
            if (t > least && t < nearest) {
                nearest = t;
                face = triangle.face;
            }
        }
        if (nearest <= way + 1e-12) {
            ray.from = ray.from + nearest * ray.along;
            return {Hit::On::face, face};
        }
        ray.from = ray.from + way * ray.along;
        if (side == 2) return {ray.along[2] < 0 ? Hit::On::soil : Hit::On::sky};
        const double size = side == 0 ? scene.x : scene.y;
        ray.from[side] = ray.along[side] > 0 ? 0 : size;
        least = 0;
    }
}

//! Returns a cosine-distributed direction about a normal.
Vector lambertian(const Vector& normal, double u, double v) {
    const Vector side = unit(cross(
        normal, std::abs(normal[0]) > .7 ? Vector{0, 1, 0} : Vector{1, 0, 0}));
    const Vector other = cross(normal, side);
    const double r = std::sqrt(u), angle = 2 * std::numbers::pi * v;
    return r * std::cos(angle) * side + r * std::sin(angle) * other +
           std::sqrt(1 - u) * normal;
}

//! Numbers that fill the unit cube evenly: an additive recurrence (Roberts
//! 2018) with a random shift.
class Even {
  public:
    static constexpr std::size_t dimensions = 7;

    explicit Even(std::mt19937_64& random) {
        double root = 1.5;
        for (int i = 0; i < 100; ++i)
            root = std::pow(1 + root, 1. / (dimensions + 1));
        double step = 1;
        for (std::size_t i = 0; i < dimensions; ++i) {
            steps_[i] = step /= root;
            at_[i] = std::uniform_real_distribution<>()(random);
        }
    }

    const std::array<double, dimensions>& operator()() {
        for (std::size_t i = 0; i < dimensions; ++i) {
            at_[i] += steps_[i];
            at_[i] -= std::floor(at_[i]);
        }
        return at_;
    }

  private:
    std::array<double, dimensions> steps_, at_;
};

constexpr std::size_t soil = 0, reflected = 1, weighted = 2, others = 3;

void follow(const Scene& scene, const std::array<double, 7>& even,
            std::mt19937_64& random, std::vector<double>& sums) {
    std::uniform_real_distribution<> any;
    double weight = 1;
    Vector along;
    if (scene.light == "sun") {
        const double e = scene.elevation * std::numbers::pi / 180;
        const double a = scene.azimuth * std::numbers::pi / 180;
        along = {-std::cos(e) * std::sin(a), -std::cos(e) * std::cos(a),
                 -std::sin(e)};
    } else {
        along = lambertian({0, 0, -1}, even[2], even[3]);
        if (scene.light == "overcast") weight = (1 - 2 * along[2]) * 3 / 7;
    }
    Ray ray{{even[0] * scene.x, even[1] * scene.y, scene.top}, along};
    for (int bounce = 0;; ++bounce) {
        const Hit hit = next(scene, ray);
        if (hit.on == Hit::On::sky) {
            sums[reflected] += weight;
            return;
        }
        const auto draw = [&](std::size_t i) {
            return bounce == 0 ? even[4 + i] : any(random);
        };
        double scattered = scene.albedo;
        Vector normal{0, 0, 1};
        if (hit.on == Hit::On::soil) {
            sums[soil] += weight * (1 - scattered);
        } else {
            const Face& face = scene.faces[hit.face];
            normal = unit(cross(face.corners[1] - face.corners[0],
                                face.corners[2] - face.corners[0]));
            const bool is_upper = dot(normal, ray.along) < 0;
            if (!is_upper) normal = -1 * normal;
            const double r = is_upper ? face.upper : face.lower;
            scattered = r + face.transmittance;
            const double absorbed = weight * (1 - scattered);
            sums[others + face.group] += absorbed;
            sums[weighted] += absorbed * face.weight;
            if (draw(2) * scattered >= r) normal = -1 * normal;
        }
        weight *= scattered;
        if (weight == 0) return;
        if (weight < .05) {
            if (any(random) < .5) return;
            weight *= 2;
        }
        ray.along = lambertian(normal, draw(0), draw(1));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: plain PATHS REPEATS SEED < case\n");
        return 2;
    }
    const long paths = std::stol(argv[1]), repeats = std::stol(argv[2]);
    std::mt19937_64 random(std::stoull(argv[3]));
    Scene scene = read();
    if (!std::cin) {
        std::fprintf(stderr, "plain: the case is cut short\n");
        return 1;
    }
    lay_out(scene);
    const std::size_t count = others + scene.groups;
    std::vector<double> mean(count), square(count);
    for (long i = 0; i < repeats; ++i) {
        Even even(random);
        std::vector<double> sums(count);
        for (long j = 0; j < paths; ++j) follow(scene, even(), random, sums);
        for (std::size_t k = 0; k < count; ++k) {
            const double found = sums[k] / static_cast<double>(paths);
            mean[k] += found / static_cast<double>(repeats);
            square[k] += found * found / static_cast<double>(repeats);
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        const double spread = std::max(square[k] - mean[k] * mean[k], 0.);
        std::printf("%.17g %.17g\n", mean[k],
                    std::sqrt(spread / static_cast<double>(repeats - 1)));
    }
}
