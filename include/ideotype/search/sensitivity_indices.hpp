// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/search/sensitivity_design.hpp"

namespace ideotype {

//! An index of sensitivity.
struct SensitivityIndex {
    std::string name;
    std::string meaning;
    bool is_relative = true;  //!< no unit; else that of the quantity
};

//! Of Sobol': first and total. By Morris: mu, mu_star, sigma and
//! mu_star_of_noise.
std::vector<SensitivityIndex> sensitivity_indices(SensitivityMethod method);

//! How a quantity depends on the factors of a design.
struct QuantitySensitivity {
    double mean = 0;
    double standard_deviation = 0;  //!< without that of noise
    double noise = 0;  //!< standard deviation of noise, by the standard errors
    std::size_t samples = 0;  //!< of which all rows are known
    //! [index, factor], with standard errors by bootstrap over samples. NaN if
    //! the quantity does not vary by more than its noise.
    std::vector<std::vector<Estimate>> indices;
};

//! Indices of the variance (first order of Saltelli et al. 2010,
//! doi:10.1016/j.cpc.2009.09.018, total of Jansen 1999,
//! doi:10.1016/S0010-4655(98)00154-4), or elementary effects over the whole
//! range of a factor (Morris 1991, Campolongo et al. 2007). The noise of rows
//! is independent and of known variance, which is subtracted from variances.
//! Samples that lack a row, that is NaN, are left out.
//! @param rows the quantity, row after row of the design
QuantitySensitivity analyse(const SensitivityDesign& design,
                            const std::vector<Estimate>& rows);

}  // namespace ideotype
