#pragma once

#include <functional>
#include <vector>

namespace ideotype {

//! A concave, not falling response f to light with f(0) = 0, as a table of
//! straight pieces, which are short where there is little light. It is concave
//! too, and between f - error_bound() and f: because f is concave, the pieces
//! lie below it and their neighbours' extensions above it, which bounds the
//! error by nothing but values of f and f'(0). Beyond the largest light f
//! itself is evaluated.
class ResponseTable {
  public:
    using Response = std::function<double(double)>;

    //! @param slope f'(0), or more
    //! @param largest light of the table, above 0
    //! @param tolerance what the error may be, above 0; there are twice as many
    //! pieces until it is not more
    //! @throws Error if f is not concave, or takes more than a million pieces.
    ResponseTable(Response f, double slope, double largest, double tolerance);

    double operator()(double light) const;

    //! [f(light + more) - f(light)] / more, which is at most f'(0): of the
    //! table; its slope at the light where more is 0.
    double chord(double light, double more) const;

    double error_bound() const { return error_bound_; }

    std::size_t pieces() const { return knots_.size() - 1; }

  private:
    //! A piece begins here.
    struct Knot {
        double light = 0;
        double value = 0;
        double slope = 0;  //!< of the piece; 0 at the last knot
    };

    std::size_t piece(double light) const;
    void halve();
    void bound_error(double slope);

    Response f_;
    double largest_;
    double scale_;  //!< light / (light + scale) is divided evenly
    double error_bound_ = 0;
    std::vector<Knot> knots_;
};

}  // namespace ideotype
