// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "across_scenarios.hpp"
#include "campaign/campaign.hpp"
#include "ideotype/canopy/canopy.hpp"
#include "ideotype/canopy/quantities.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/core/random.hpp"
#include "ideotype/light/accuracy.hpp"
#include "ideotype/light/device.hpp"
#include "search/outcome.hpp"

namespace ideotype {

//! Returns the accuracy of a task: finalists are evaluated more accurately.
//! @throws Error of wrong usage if the tolerance of the task is impossible.
Accuracy accuracy_of(const Task& task, const Campaign& campaign);

//! Returns the random numbers of a task: common to all candidates of a
//! generation; fresh numbers for all finalists. If each row has light of its
//! own, rows share only the field, or nothing with several fields, since their
//! differences are part of standard errors then.
Randomness randomness_of(const Task& task, const Campaign& campaign,
                         const Case& chosen);

//! The accuracy and the random numbers that a plant is evaluated with.
struct Sampling {
    Accuracy accuracy;
    Randomness randomness;
};

//! Returns the sampling of a task. An empty task gives that of generation 0.
//! @throws Error as accuracy_of()
Sampling sampling_of(const Task& task, const Campaign& campaign,
                     const Case& chosen);

//! Returns about how many times longer the evaluation of a finalist takes, with
//! more paths and a field for each randomisation.
double final_effort(const Campaign& campaign);

//! Returns layers of 0.25 m up to the height that the highest leaf could reach.
Layers canopy_layers(const Campaign& campaign);

//! Returns the scene of the baseline in a case, or in the first of its
//! scenarios; the scene can be kept for all other plants.
Scene scene_of(const Campaign& campaign, const Case& chosen);

//! Returns the details that are wanted of all plants of a campaign.
Details details_of(const Campaign& campaign);

//! Returns the request to evaluate plants in a scene of a campaign: the plant
//! of the crop, then those of bred components. Components beyond the end of the
//! list keep the plants of the scene.
//! @param in the case of the scene; at a stage, plants have the age, the share
//! of work and the random numbers of the stage
CanopyRequest request_of(Sampling sampling, const Campaign& campaign,
                         const Case& in, Scene scene, const Plants& plants);

//! Returns the form of a case's outcomes at a certain accuracy.
OutcomeSchema outcome_schema(const Campaign& campaign, const Case& chosen,
                             const Accuracy& accuracy);

//! Returns an objective, which may be that of one component, weighted or of all
//! plants together as the campaign tells, or another quantity without axes.
//! @throws Error if the report has no quantity of this name.
Randomised measure_number(const Campaign& campaign, const std::string& name,
                          const CanopyReport& report);

//! Returns the land equivalent ratio that is a campaign's objective, with a
//! standard error that includes the errors of the sole crops' yields.
Estimate land_equivalent_ratio(const Campaign& campaign,
                               const CanopyReport& report);

//! Returns the leaf area index of plants that do not deviate from their line,
//! so that random numbers do not decide whether constraints are met.
//! @param plant mesh of one plant
//! @param ground_per_plant all ground over all plants [m2]
double lai_of_line(const Mesh& plant, double ground_per_plant);

//! Returns the outcome that a report tells of a plant, in the form of a case
//! with one scenario, or of one stage.
//! @param plant plant of the campaign's crop, which constraints limit
Outcome to_outcome(const Campaign& campaign, const Plant& plant,
                   const CanopyReport& report);

//! An outcome with each of its quantities by randomisation.
struct RandomisedOutcome {
    Outcome outcome;
    //! Quantities [randomisation, quantity]; NaN where a quantity is not known
    //! by randomisation.
    std::vector<std::vector<double>> quantities;
};

//! The scenarios of one case, set up once for all plants that are evaluated.
class Stand {
  public:
    //! Refers to the campaign, which must outlive the stand.
    Stand(const Campaign& campaign, const Case& chosen);

    //! Returns the form of outcomes with the accuracy of the search or of the
    //! final evaluations.
    const OutcomeSchema& schema(bool is_final) const {
        return is_final ? final_schema_ : schema_;
    }

    //! Sets up the light of all scenarios, which otherwise the first evaluation
    //! does. Several threads may then evaluate, each with a device of its own.
    void prepare();

    //! Returns the outcome in all scenarios, a pure function of plants and
    //! sampling.
    //! @throws Error as ideotype::evaluate()
    Outcome evaluate(const Plants& plants, const Sampling& sampling,
                     const Device& device);

    //! Returns the outcome of evaluate() with its quantities by randomisation;
    //! plants with equal sampling share the random numbers.
    RandomisedOutcome evaluate_by_randomisation(const Plants& plants,
                                                const Sampling& sampling,
                                                const Device& device);

  private:
    template <class Take>
    void evaluate_each(const Plants& plants, const Sampling& sampling,
                       const Device& device, Take take);

    const Campaign& campaign_;
    std::vector<Case> cases_;    //!< cases of each scenario and stage
    std::vector<Scene> scenes_;  //!< scenes, empty until set up
    AcrossScenarios across_;
    OutcomeSchema schema_, final_schema_;
};

//! Returns whether any panels track the sun, so that each instant needs a sky
//! of its own.
bool has_trackers(const Campaign& campaign);

//! Adds the panels and objects of a campaign to a scene that already has its
//! components, cell and bands.
void add_objects(Scene& scene, const Campaign& campaign,
                 const Spacing& spacing);

}  // namespace ideotype
