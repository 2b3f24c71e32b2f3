#pragma once

#include <cstdint>
#include <string>

#include "ideotype/app/evolve_case.hpp"
#include "ideotype/campaign/campaign.hpp"
#include "ideotype/core/estimate.hpp"

namespace ideotype {

//! Tells how a case evolves: one live line on a terminal, one line per
//! generation in a log file.
class ProgressLine : public Watcher {
  public:
    ProgressLine(const Campaign& campaign, const Case& chosen);
    ~ProgressLine() override;

    void on_evaluation(std::uint32_t generation) override;
    void on_generation(std::uint32_t generation,
                       const GenerationSummary& summary) override;
    void on_final(const std::string& reason) override;

  private:
    std::string text(std::uint32_t generation) const;
    void show(const std::string& line);

    const Campaign& campaign_;
    std::string name_;
    bool is_terminal_;
    double started_;
    double shown_ = 0;
    int evaluations_ = 0;             //!< of this session
    int evaluations_generation_ = 0;  //!< of the current generation
    std::string best_ = "-";
};

//! "12.345 +- 0.006": as many digits as the standard error allows.
std::string format(Estimate x);

//! "1:02:03" or "2:03".
std::string format_duration(double seconds);

//! Seconds of a steady clock.
double now();

}  // namespace ideotype
