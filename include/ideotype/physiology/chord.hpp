#pragma once

namespace ideotype {

//! [f(light + more) - f(light)] / more of a response that has gross() and
//! slope(), f'(light) where more is 0. Below 0.01 umol m-2 s-1 it is the slope
//! in the middle, where the difference would be mostly rounding; either is
//! within 1e-11.
template <class Response>
double chord(const Response& f, double light, double more) {
    if (more < 0.01) return f.slope(light + more / 2);
    return (f.gross(light + more) - f.gross(light)) / more;
}

}  // namespace ideotype
