// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Dense>

namespace ideotype {

//! Points evaluated with common random numbers.
struct SurfaceRows {
    Eigen::MatrixXd points;  //!< coordinates [n, rows]
    Eigen::VectorXd values;  //!< values to maximise [rows]
    double weight = 1;       //!< reciprocal of the relative noise variance
};

//! A second-order response surface (Box and Wilson 1951,
//! doi:10.1111/j.2517-6161.1951.tb00067.x) about u = 0, without interactions:
//! y = sum_i (g_i u_i + h_i u_i^2 / 2).
struct ResponseSurface {
    Eigen::VectorXd slopes;      //!< g [n]
    Eigen::VectorXd curvatures;  //!< h [n]

    //! Returns the value at a point, relative to the value at u = 0.
    double at(const Eigen::VectorXd& u) const;

    //! Returns the point within a distance > 0 of u = 0 with the highest value
    //! (More and Sorensen 1983, doi:10.1137/0904038), or u = 0 if all slopes
    //! are 0.
    Eigen::VectorXd maximise(double radius) const;
};

//! Fits a response surface by weighted ridge regression. Each generation has an
//! intercept, which removes the noise that its rows share. The ridge has the
//! highest marginal likelihood (MacKay 1992, doi:10.1162/neco.1992.4.3.415), so
//! that coefficients shrink as the noise requires. Before the data, slopes and
//! curvatures have equal standard deviations.
//! @param generations one or more, of two or more rows each
ResponseSurface fit_surface(const std::vector<SurfaceRows>& generations);

}  // namespace ideotype
