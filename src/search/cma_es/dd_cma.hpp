// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Dense>

namespace ideotype {

//! Returns the weights of the points of a generation, best first, before
//! normalisation. Those of the worse half are negative.
std::vector<double> make_raw_weights(std::size_t population);

//! The multivariate normal distribution of dd-CMA-ES (Akimoto and Hansen 2019,
//! doi:10.1162/evco_a_00260). Its covariance is step_size^2 D C D, with D
//! diagonal and C a correlation matrix. D has separate learning rates, so it
//! adapts to the scales of coordinates long before C is known. The step size is
//! controlled by cumulative step-size adaptation. Points worse than the median
//! have negative weights.
class DdCma {
  public:
    //! Makes a distribution of independent coordinates.
    //! @param mean means of n >= 1 coordinates
    //! @param deviations standard deviations of the coordinates, > 0
    //! @param population number of points in a generation, >= 4
    DdCma(Eigen::VectorXd mean, Eigen::VectorXd deviations,
          std::size_t population);

    //! Transforms a standard normal vector to a point of the distribution.
    Eigen::VectorXd sample(const Eigen::VectorXd& normal) const;

    //! Sets the number of points in the next generations, >= 4.
    void set_population(std::size_t population);

    //! Updates the distribution with the points of a generation [n,
    //! population], best first.
    void update(const Eigen::MatrixXd& ranked);

    //! Sets the mean and the standard deviation of a coordinate, as integers
    //! need after an update.
    //! @param deviation standard deviation, > 0
    void set_marginal(std::size_t coordinate, double mean, double deviation);

    const Eigen::VectorXd& mean() const { return mean_; }
    //! Returns the standard deviation of each coordinate.
    Eigen::VectorXd deviations() const { return step_size_ * scales_; }
    //! Returns the correlations of the coordinates [n, n].
    const Eigen::MatrixXd& correlation() const { return correlation_; }

  private:
    //! The learning rates and weights for updates of D or C.
    struct Rates {
        double rank_one = 0, rank_mu = 0, path = 0;
        Eigen::VectorXd weights{};
    };
    static Rates compute_rates(double n, double degrees_of_freedom,
                               const std::vector<double>& raw_weights);

    //! An evolution path, and the fraction of its stationary variance that it
    //! has reached.
    struct Path {
        Eigen::VectorXd steps;
        double share = 0;

        void add(const Eigen::VectorXd& step, double rate,
                 double effective_parents, bool is_usual);
    };

    void decompose();

    double effective_parents_ = 0;
    std::size_t parents_ = 0;
    Rates correlation_rates_, scale_rates_;
    double step_rate_ = 0, step_damping_ = 0;
    double usual_length_;  //!< expected length of a standard normal vector

    Eigen::VectorXd mean_;
    double step_size_ = 1;
    Eigen::VectorXd scales_;
    Eigen::MatrixXd correlation_;
    Path step_path_, correlation_path_, scale_path_;
    Eigen::MatrixXd root_, inverse_root_;  //!< symmetric roots of C
    double correlation_condition_ = 1;
};

}  // namespace ideotype
