#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dataset.hpp"
#include "ideotype/history/history.hpp"

namespace ideotype {

//! /generations: what is kept of each complete generation. The flag committed
//! decides; it is written last and read first.
class Summaries {
  public:
    static void create(hid_t file, const HistoryHeader& header);

    explicit Summaries(hid_t file);

    //! Number of leading generations that are committed.
    std::uint32_t committed() const;

    //! Those of all committed generations.
    std::vector<GenerationSummary> read() const;

    //! Everything but the flag.
    void write(std::uint32_t generation, const GenerationSummary& summary);

    void set_committed(std::uint32_t generation);

  private:
    Dataset committed_;
    Dataset best_slot_;
    Dataset best_;
    Dataset best_error_;
    Dataset mean_;
    Dataset spread_;
    Dataset diversity_;
    Dataset failures_;
    Dataset evaluations_;
    Dataset wall_time_;
};

}  // namespace ideotype
