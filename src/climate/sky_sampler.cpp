// SPDX-License-Identifier: Apache-2.0
#include "ideotype/climate/sky_sampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

using std::numbers::pi;

//! The two factors of the CIE clear sky, see relative_radiance().

//! The scattering indicatrix: relative radiance at an angle from the sun [rad].
double indicatrix(double to_sun) {
    const double c = std::cos(to_sun);
    return 0.91 + 10 * std::exp(-3 * to_sun) + 0.45 * c * c;
}

//! The gradation: relative radiance from the zenith to the horizon.
double gradation(double cos_zenith) {
    return cos_zenith > 0 ? 1 - std::exp(-0.32 / cos_zenith) : 1;
}

//! Returns the direction of travel from a point of the sky.
glm::dvec3 make_travel(double cos_zenith, double sin_zenith, double azimuth) {
    return {sin_zenith * std::cos(azimuth), -sin_zenith * std::sin(azimuth),
            -cos_zenith};
}

//! Inverts (3 m^2 + 4 m^3) / 7, the share of an overcast sky's irradiance that
//! comes from points with cos z < m. With m = (2 w - 1) / 4 the cubic becomes
//! the Chebyshev polynomial 4 w^3 - 3 w = 56 share - 1.
double invert_overcast(double share) {
    const double k = 56 * share - 1;
    const double w =
        k < 1 ? std::cos(std::acos(k) / 3) : std::cosh(std::acosh(k) / 3);
    return std::clamp((2 * w - 1) / 4, 0.0, 1.0);
}

}  // namespace

double relative_radiance(const SkyRadiance& sky, const glm::dvec3& travel) {
    const double cos_zenith = -travel.z;
    if (cos_zenith < 0) return 0;
    switch (sky.model) {
        case SkyModel::uniform:
            return 1;
        case SkyModel::overcast:
            return (1 + 2 * cos_zenith) / 3;
        case SkyModel::clear:
            break;
    }
    const glm::dvec3 sun = beam_direction(sky.sun);
    const double cos_to_sun = std::clamp(glm::dot(travel, sun), -1.0, 1.0);
    return indicatrix(std::acos(cos_to_sun)) * gradation(cos_zenith);
}

//! A density on [0, 1] that is smooth within each of several equal panels. In
//! each panel a polynomial through Gauss-Legendre nodes approximates the
//! density. Its integral is known in closed form and is inverted to rounding
//! precision.
template <std::size_t panels>
class PiecewiseDensity {
  public:
    template <class Density>
    explicit PiecewiseDensity(const Density& density) {
        double sum = 0;
        for (std::size_t p = 0; p < panels; ++p) {
            for (std::size_t j = 0; j < order; ++j) {
                values_[p][j] = density(map(p, nodes[j]));
                sum += weights[j] * values_[p][j] / (2 * panels);
            }
            integrals_[p] = sum;
        }
    }

    //! Returns the integral over [0, 1].
    double total() const { return integrals_.back(); }

    //! Returns the point at which the integral from 0 equals a share of the
    //! total.
    double quantile(double share) const {
        const double target = share * total();
        const auto panel =
            std::lower_bound(integrals_.begin(), integrals_.end() - 1, target);
        const auto p = static_cast<std::size_t>(panel - integrals_.begin());
        const double before = p == 0 ? 0 : integrals_[p - 1];
        return map(p, solve(values_[p], (target - before) * 2 * panels));
    }

  private:
    static constexpr std::size_t order = 6;
    using Values = std::array<double, order>;
    static constexpr Values nodes{-0.932469514203152028, -0.661209386466264514,
                                  -0.238619186083196909, 0.238619186083196909,
                                  0.661209386466264514,  0.932469514203152028};
    static constexpr Values weights{0.171324492379170345, 0.360761573048138608,
                                    0.467913934572691047, 0.467913934572691047,
                                    0.360761573048138608, 0.171324492379170345};

    //! Maps x in [-1, 1] to a point of a panel.
    static double map(std::size_t panel, double x) {
        return (static_cast<double>(panel) + (1 + x) / 2) / panels;
    }

    //! Returns the Legendre polynomials of degrees 0 to order.
    static std::array<double, order + 1> legendre(double x) {
        std::array<double, order + 1> p{1, x};
        for (std::size_t k = 1; k < order; ++k) {
            const auto n = static_cast<double>(k);
            p[k + 1] = ((2 * n + 1) * x * p[k] - n * p[k - 1]) / (n + 1);
        }
        return p;
    }

    //! Finds the point of [-1, 1] at which the integral from -1 equals an
    //! amount. It uses Newton's method, and bisection where a Newton step
    //! leaves the bracket.
    static double solve(const Values& values, double amount) {
        // Coefficients of the Legendre series of the density, divided by 2 k +
        // 1 for degree k. The integral of the series is the sum of c_k (P_{k+1}
        // - P_{k-1}).
        Values c{};
        for (std::size_t j = 0; j < order; ++j) {
            const auto p = legendre(nodes[j]);
            for (std::size_t k = 0; k < order; ++k)
                c[k] += weights[j] * values[j] * p[k] / 2;
        }
        double low = -1, high = 1;
        // A panel with an integral of zero is reached only by shares of 0 and
        // 1.
        if (!(c[0] > 0)) return low;
        double x = std::clamp(amount / c[0] - 1, low, high);
        // Newton's method on the integral, safeguarded by [low, high].
        for (int i = 0; i < 60; ++i) {
            const auto p = legendre(x);
            double density = c[0];
            double integral = c[0] * (x + 1);
            for (std::size_t k = 1; k < order; ++k) {
                density += static_cast<double>(2 * k + 1) * c[k] * p[k];
                integral += c[k] * (p[k + 1] - p[k - 1]);
            }
            (integral < amount ? low : high) = x;
            double next = x - (integral - amount) / density;
            if (!(next >= low && next <= high)) next = (low + high) / 2;
            const double step = std::abs(next - x);
            x = next;
            if (step < 1e-15) break;
        }
        return x;
    }

    std::array<Values, panels> values_{};
    std::array<double, panels> integrals_{};
};

//! Samples the clear sky in polar coordinates about the sun, which avoid
//! singularities: one factor of the radiance depends only on the angle to the
//! sun, and the other varies smoothly along circles about the sun. The
//! distribution of the angle is tabulated; the distribution of the position on
//! a circle is integrated for each direction. The mean relative error of the
//! sampled density is at most 3e-7.
class SkySampler::ClearSky {
  public:
    explicit ClearSky(const SunPosition& sun)
        : sun_zenith_(sun.zenith * degree),
          sun_azimuth_(sun.azimuth * degree),
          cos_sun_(std::max(0.0, std::cos(sun_zenith_))),
          sin_sun_(std::sin(sun_zenith_)),
          angles_([this](double t) {
              const Angle a = angle_at(t);
              return a.rate * indicatrix(a.to_sun) * std::sin(a.to_sun) *
                     Circle(*this, a.to_sun).irradiance();
          }) {}

    double irradiance() const { return angles_.total(); }

    glm::dvec3 sample(double u, double v) const {
        const double to_sun = angle_at(angles_.quantile(u)).to_sun;
        const double side = 2 * v - 1;
        const double around =
            std::copysign(Circle(*this, to_sun).quantile(std::abs(side)), side);
        // Components of the direction: towards the sun, perpendicular to it on
        // the side of the zenith, and horizontal.
        const double s = std::cos(to_sun);
        const double t = std::sin(to_sun) * std::cos(around);
        const double b = std::sin(to_sun) * std::sin(around);
        const double sin_azimuth = std::sin(sun_azimuth_);
        const double cos_azimuth = std::cos(sun_azimuth_);
        const double outward = s * sin_sun_ - t * cos_sun_;
        return {-(outward * sin_azimuth + b * cos_azimuth),
                -(outward * cos_azimuth - b * sin_azimuth),
                -std::max(0.0, s * cos_sun_ + t * sin_sun_)};
    }

  private:
    //! The points above the horizon at one angle to the sun. The position angle
    //! along the circle is 0 on the side of the zenith.
    class Circle {
      public:
        Circle(const ClearSky& sky, double to_sun)
            : end_(find_end(std::cos(to_sun) * sky.cos_sun_,
                            std::sin(to_sun) * sky.sin_sun_)),
              half_([this, a = std::cos(to_sun) * sky.cos_sun_,
                     b = std::sin(to_sun) * sky.sin_sun_](double x) {
                  const double cos_zenith =
                      std::max(0.0, a + b * std::cos(position(x)));
                  return 2 * (1 - x) * cos_zenith * gradation(cos_zenith);
              }) {}

        double irradiance() const { return 2 * end_ * half_.total(); }

        //! Returns the position angle up to which the integral is a share of
        //! the half-circle's total.
        double quantile(double share) const {
            return position(half_.quantile(share));
        }

      private:
        //! Returns the angle at which cos z = a + b cos x becomes zero.
        static double find_end(double a, double b) {
            return a >= b ? pi : a <= -b ? 0 : std::acos(-a / b);
        }

        //! Maps x in [0, 1] to a position angle. Angles are denser towards the
        //! horizon, where the radiance changes fastest.
        double position(double x) const { return end_ * x * (2 - x); }

        double end_;
        PiecewiseDensity<8> half_;
    };

    struct Angle {
        double to_sun;
        double rate;  //!< derivative of the angle
    };

    //! Maps t in [0, 1] to an angle to the sun: the first half to whole
    //! circles, the second to circles that the horizon cuts. The cosine removes
    //! the square-root singularities at both ends of the second half.
    Angle angle_at(double t) const {
        const double cut = std::max(0.0, pi / 2 - sun_zenith_);
        const double begin = t < 0.5 ? 0 : cut;
        const double span = t < 0.5 ? cut : 2 * std::min(sun_zenith_, pi / 2);
        const double x = pi * (t < 0.5 ? 2 * t : 2 * t - 1);
        return {begin + span * (1 - std::cos(x)) / 2, span * pi * std::sin(x)};
    }

    double sun_zenith_, sun_azimuth_;
    double cos_sun_, sin_sun_;
    PiecewiseDensity<32> angles_;
};

SkySampler::SkySampler(const SkyRadiance& sky) : radiance_(sky) {
    if (sky.model != SkyModel::clear) return;
    if (!(sky.sun.zenith >= 0 && sky.sun.zenith <= 90))
        throw Error(
            "a clear sky needs a sun above the horizon; choose another time");
    clear_ = std::make_shared<ClearSky>(sky.sun);
}

glm::dvec3 SkySampler::sample(double u, double v) const {
    if (clear_) return clear_->sample(u, v);
    if (radiance_.model == SkyModel::uniform)
        return make_travel(std::sqrt(1 - u), std::sqrt(u), 2 * pi * v);
    const double cos_zenith = invert_overcast(1 - u);
    return make_travel(cos_zenith, std::sqrt(1 - cos_zenith * cos_zenith),
                       2 * pi * v);
}

double SkySampler::horizontal_irradiance() const {
    if (clear_) return clear_->irradiance();
    return radiance_.model == SkyModel::uniform ? pi : 7 * pi / 9;
}

double SkySampler::relative_brightness(const glm::dvec3& travel) const {
    return relative_radiance(radiance_, travel) * pi / horizontal_irradiance();
}

}  // namespace ideotype
