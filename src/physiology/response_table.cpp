#include "ideotype/physiology/response_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ideotype/core/error.hpp"

namespace ideotype {

ResponseTable::ResponseTable(Response f, double slope, double largest,
                             double tolerance)
    : f_(std::move(f)), largest_(largest) {
    if (!(largest > 0) || !(tolerance > 0))
        throw Error(
            "a table of a response to light has no range or no tolerance "
            "(both must be above 0)");
    const double last = f_(largest);
    // The light that would saturate a response that did not bend before.
    scale_ = slope > 0 && last > 0 ? last / slope : largest;
    knots_ = {{0, f_(0), 0}, {largest, last, 0}};
    constexpr std::size_t most = std::size_t{1} << 20;
    do {
        if (pieces() >= most)
            throw Error(
                "a response to light takes too many pieces (its curvature is "
                "almost a kink, or the tolerance is too small)");
        halve();
        bound_error(slope);
    } while (error_bound_ > tolerance);
}

void ResponseTable::halve() {
    std::vector<Knot> finer;
    finer.reserve(2 * knots_.size() - 1);
    const double part =
        largest_ / (largest_ + scale_) / static_cast<double>(2 * pieces());
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        if (i > 0) {
            const double u = static_cast<double>(2 * i - 1) * part;
            const double light = scale_ * u / (1 - u);
            finer.push_back({light, f_(light), 0});
        }
        finer.push_back(knots_[i]);
    }
    knots_ = std::move(finer);
    for (std::size_t i = 0; i < pieces(); ++i)
        knots_[i].slope = (knots_[i + 1].value - knots_[i].value) /
                          (knots_[i + 1].light - knots_[i].light);
}

void ResponseTable::bound_error(double slope) {
    error_bound_ = 0;
    for (std::size_t i = 0; i < pieces(); ++i) {
        const double length = knots_[i + 1].light - knots_[i].light;
        const double here = knots_[i].slope;
        const double before = i == 0 ? slope : knots_[i - 1].slope;
        const double after = knots_[i + 1].slope;
        // What rounding makes of slopes that are the same.
        const double noise =
            1e-15 * std::abs(knots_.back().value) / length + 1e-12 * slope;
        if (before < here - noise || here < after - noise)
            throw Error(
                "a response to light is not concave and rising (a table of it "
                "would have no known error)");
        const double left = std::max(before - here, 0.0);
        const double right = std::max(here - after, 0.0);
        if (left > 0 && right > 0)
            error_bound_ =
                std::max(error_bound_, length * left * right / (left + right));
    }
}

std::size_t ResponseTable::piece(double light) const {
    const double u = light / (light + scale_) * (largest_ + scale_) / largest_;
    return std::min(static_cast<std::size_t>(u * static_cast<double>(pieces())),
                    pieces() - 1);
}

double ResponseTable::operator()(double light) const {
    if (light > largest_) return f_(light);
    const Knot& knot = knots_[piece(light)];
    return knot.value + knot.slope * (light - knot.light);
}

double ResponseTable::chord(double light, double more) const {
    // Within a piece the difference of two values would be mostly rounding.
    if (light + more <= largest_ && piece(light) == piece(light + more))
        return knots_[piece(light)].slope;
    return ((*this)(light + more) - (*this)(light)) / more;
}

}  // namespace ideotype
