// SPDX-License-Identifier: Apache-2.0
// Arguments: sobol or morris, genes, genes in each group (1: no groups),
// samples, levels. Prints the rows of the design over unit ranges.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "search/sensitivity_design.hpp"

using namespace ideotype;

int main(int, char** words) {
    const bool is_sobol = std::string(words[1]) == "sobol";
    const int genes = std::atoi(words[2]), together = std::atoi(words[3]);
    SearchSpace space;
    for (int i = 0; i < genes; ++i) {
        space.genes.push_back({"gene" + std::to_string(i), "1", 0, 1, false,
                               true, std::to_string(i / together)});
        space.baseline.push_back(0);
    }
    const SensitivityDesign design(
        {is_sobol ? SensitivityMethod::sobol : SensitivityMethod::morris,
         std::atoi(words[4]), std::atoi(words[5]),
         together > 1 ? Grouping::trait : Grouping::gene},
        space, 1);
    for (std::uint32_t i = 0; i < design.samples(); ++i)
        for (std::size_t k = 0; k < design.rows_per_sample(); ++k) {
            for (const double x : design.make_row(i, k))
                std::printf("%.17g ", x);
            std::printf("\n");
        }
    return 0;
}
