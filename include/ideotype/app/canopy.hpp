#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/campaign/campaign.hpp"
#include "ideotype/core/mesh.hpp"
#include "ideotype/evolve/evaluation.hpp"
#include "ideotype/light/device.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/report.hpp"
#include "ideotype/light/transport.hpp"
#include "ideotype/plant/field.hpp"
#include "ideotype/sky/day.hpp"

namespace ideotype {

//! Which random numbers an estimate uses, and how many.
struct Draws {
    std::uint64_t seed = 0;
    std::uint32_t generation = 0;
    Sampling sampling;
    //! One field for all randomisations makes candidates comparable at least
    //! cost; a new one for each makes the standard error include the jitter.
    enum class Fields { one, each } fields = Fields::one;
};

//! The draws of a task: common to all candidates of a generation; fresh and
//! finer ones for all finalists.
Draws draws_of(const Task& task, const Campaign& campaign, const Case& chosen);

//! How many times longer the evaluation of a finalist takes, about: it has
//! more paths, and a field for each randomisation.
double final_effort(const Campaign& campaign);

//! The light of a case; worth keeping for all its evaluations.
DayIllumination light_of(const Campaign& campaign, const Case& chosen);

//! genome -> plant.
Mesh build_plant(const Campaign& campaign, const Genome& genome);

//! genome -> plant -> field, with the turns of one draw.
Field build_field(const Campaign& campaign, const Case& chosen,
                  const Genome& genome, const Draws& draws, std::uint32_t draw);

//! Visits the fields of an estimate one by one, each with the part of the
//! sampling that falls to it and its random numbers.
void for_each_field(const Campaign& campaign, const Case& chosen,
                    const Mesh& plant, const Draws& draws,
                    const std::function<void(const Field&, const Sampling&,
                                             const Randomness&)>& visit);

//! What light does in one canopy.
struct CanopyReport {
    DayReport light;
    std::uint64_t paths = 0;    //!< that the light is the mean of
    bool is_capped = false;     //!< more would be needed to meet the tolerance
    std::vector<Group> groups;  //!< that light was counted for
    Layers layers;
    double lai = 0;          //!< one-sided leaf area over ground [m2 m-2]
    double ground_area = 0;  //!< that all figures refer to [m2]
    Boundary boundary = Boundary::periodic;
};

//! Enough points to know a sunlit fraction to some 0.2 %.
Sampling sunlit_sampling(const Sampling& sampling);

//! Layers of 0.25 m, up to what the highest leaf could reach.
Layers canopy_layers(const Campaign& campaign);

//! The sunlit leaf area costs more rays and changes no fitness: histories go
//! without it.
enum class Detail { history, full };

//! field -> light -> report.
//! @param light of the case
CanopyReport study(const Campaign& campaign, const Case& chosen,
                   const DayIllumination& light, const Device& device,
                   const Genome& genome, const Draws& draws, Detail detail);

//! The columns of a case's outcomes.
OutcomeSchema outcome_schema(const Campaign& campaign, const Day& day);

//! The columns' values, in their order.
Outcome to_outcome(const Campaign& campaign, const Genome& genome,
                   const CanopyReport& report);

//! What evolution selects by: the objective, or, of a plant that fails its
//! constraints, how far it does, as a negative number. Objectives are never
//! negative, so this is the feasibility rule of Deb 2000
//! (doi:10.1016/S0045-7825(99)00389-8), without weights to tune. Minus infinity
//! if the evaluation failed.
double fitness_of(const Outcome& outcome, const OutcomeSchema& schema);

//! Evaluates candidates of all cases of a campaign.
class CanopyEvaluator : public Evaluator {
  public:
    //! The campaign must outlive the evaluator.
    //! @throws Error if the processor lacks the instruction set.
    CanopyEvaluator(const Campaign& campaign, const std::string& isa);

    const OutcomeSchema& schema(const Task& task) const override;
    Outcome evaluate(const Task& task, const Genome& genome) override;

  private:
    const Campaign& campaign_;
    std::vector<Case> cases_;
    //! By case; set up when its first candidate comes.
    std::vector<std::optional<DayIllumination>> lights_;
    std::vector<OutcomeSchema> schemas_;  //!< by case
    Device device_;
};

}  // namespace ideotype
