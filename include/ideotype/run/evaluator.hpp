#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ideotype/campaign/campaign.hpp"
#include "ideotype/canopy/canopy.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/parallel/evaluator.hpp"
#include "ideotype/run/across_scenarios.hpp"

namespace ideotype {

//! How accurate a task is: finalists are evaluated more finely.
Accuracy accuracy_of(const Task& task, const Campaign& campaign);

//! The random numbers of a task: common to all candidates of a generation;
//! fresh ones for all finalists. Rows of a sensitivity study have light of
//! their own, in one field.
Randomness randomness_of(const Task& task, const Campaign& campaign,
                         const Case& chosen);

//! How many times longer the evaluation of a finalist takes, about: it has
//! more paths, and a field for each randomisation.
double final_effort(const Campaign& campaign);

//! Layers of 0.25 m, up to what the highest leaf could reach.
Layers canopy_layers(const Campaign& campaign);

//! What the plants of a case are evaluated under, or in the first of its
//! scenarios; worth keeping for all of them.
Scenario scenario_of(const Campaign& campaign, const Case& chosen);

//! How a task evaluates a plant.
//! @param scenario that of the case
CanopyRequest request_of(const Task& task, const Campaign& campaign,
                         const Case& chosen, const Scenario& scenario,
                         Plant plant);

//! The form of a case's outcomes, with this accuracy.
OutcomeSchema outcome_schema(const Campaign& campaign, const Case& chosen,
                             const Accuracy& accuracy);

//! What a report says of a plant, in the form of a case without others.
Outcome to_outcome(const Campaign& campaign, const Plant& plant,
                   const CanopyReport& report);

//! Evaluates candidates of all cases of a campaign.
class CanopyEvaluator : public Evaluator {
  public:
    //! The campaign must outlive the evaluator.
    //! @throws Error if the processor lacks the instruction set.
    CanopyEvaluator(const Campaign& campaign, const std::string& isa);

    const OutcomeSchema& schema(const Task& task) const override;
    Outcome evaluate(const Task& task, const Genome& genome) override;

  private:
    struct Prepared {
        Prepared(const Campaign& campaign, const Case& chosen);

        OutcomeSchema schema;
        OutcomeSchema final_schema;
        //! Each set up when its first candidate comes.
        std::vector<std::pair<Case, std::optional<Scenario>>> scenarios;
        std::optional<AcrossScenarios> across;  //!< of several
    };

    Outcome evaluate(const Task& task, const Campaign& campaign,
                     Prepared& prepared, const Genome& genome) const;

    const Campaign& campaign_;
    std::vector<Prepared> cases_;  //!< by case
    Device device_;
};

}  // namespace ideotype
