// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Dense>

namespace ideotype {

//! The multivariate normal distribution of the CMA-ES of Hansen
//! (arXiv:1604.00772, version of 2023), with negative weights, cumulation and,
//! if asked for, the learning rates that the signal in its steps allows (Nomura
//! et al. 2023, doi:10.1145/3583131.3590358). Equations are of the first.
class Cma {
  public:
    //! @param mean n >= 1 coordinates
    //! @param step_size > 0
    //! @param population of a generation, >= 4
    Cma(Eigen::VectorXd mean, double step_size, std::size_t population,
        bool adapts_learning_rates);

    //! The point that a standard normal vector is moved to (eq. 38 to 40).
    Eigen::VectorXd sample(const Eigen::VectorXd& normal) const;

    //! Takes the points of a generation [n, population], best first (eq. 41 to
    //! 47).
    void update(const Eigen::MatrixXd& ranked);

    const Eigen::VectorXd& mean() const { return mean_; }
    double step_size() const { return step_size_; }
    const Eigen::MatrixXd& covariance() const { return covariance_; }
    //! Largest standard deviation along any axis.
    double widest() const { return step_size_ * deviations_.maxCoeff(); }
    //! Of the covariance matrix.
    double condition() const;

  private:
    //! How the signal in the changes of a parameter compares to their noise.
    struct LearningRate {
        double smoothing;  //!< of the averages
        Eigen::MatrixXd mean_change{};
        double mean_square = 0;
        double rate = 1;

        void adapt(const Eigen::MatrixXd& change);
    };

    //! Where the distribution was before a generation.
    struct Before {
        Eigen::VectorXd mean;
        double step_size;
        Eigen::MatrixXd covariance;
        Eigen::MatrixXd whitening;
    };

    void damp(const Before& before);
    void decompose();

    // Settings (table 1).
    std::vector<double> weights_;
    std::size_t parents_;
    double effective_parents_;
    double path_rate_, step_rate_, step_damping_;
    double rank_one_rate_, rank_mu_rate_;
    double usual_length_;  //!< of a standard normal vector
    bool adapts_learning_rates_;

    Eigen::VectorXd mean_;
    double step_size_;
    Eigen::MatrixXd covariance_;
    Eigen::VectorXd path_, step_path_;
    int updates_ = 0;
    // covariance = axes * deviations^2 * axes^T
    Eigen::MatrixXd axes_;
    Eigen::VectorXd deviations_;
    LearningRate mean_learning_{0.1}, covariance_learning_{0.03};
};

}  // namespace ideotype
