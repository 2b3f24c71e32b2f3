// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
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
#include "light_cue.hpp"
#include "search/outcome.hpp"
#include "season.hpp"

namespace ideotype {

//! Returns the accuracy of a task; it is higher for finalists.
//! @throws Error for wrong usage if the tolerance of the task is impossible.
Accuracy accuracy_of(const Task& task, const Campaign& campaign);

//! Returns the random numbers of a task. They are common to all candidates of a
//! generation; finalists use different ones, which are common to all finalists.
//! If each row has independent light, rows share only the field. With several
//! fields they share nothing, since standard errors then include differences
//! between fields.
Randomness randomness_of(const Task& task, const Campaign& campaign,
                         const Case& chosen);

//! The accuracy and the random numbers of an evaluation.
struct Sampling {
    Accuracy accuracy;
    Randomness randomness;
};

//! Returns the sampling of a task; an empty task gets that of generation 0.
//! @throws Error like accuracy_of()
Sampling sampling_of(const Task& task, const Campaign& campaign,
                     const Case& chosen);

//! Returns the approximate cost of evaluating a finalist, relative to an
//! evaluation in the search.
double final_effort(const Campaign& campaign);

//! Returns layers of 0.25 m up to the greatest possible height of leaves.
Layers canopy_layers(const Campaign& campaign);

//! Returns the scene of the baseline in a case, or in the first of its
//! scenarios. The scene can be reused for other plants.
Scene scene_of(const Campaign& campaign, const Case& chosen);

//! Sets a component of a scene to a plant that has responded to its
//! neighbours, full-grown or at the stage of a case.
//! @param number number of the component; 0: the main crop
void set_grown_plant(const Campaign& campaign, const Case& in,
                     std::size_t number, const Plant& plant,
                     Component& component);

//! Returns the optional details that a campaign needs for every plant.
Details details_of(const Campaign& campaign);

//! Returns the request to evaluate plants in a scene of a campaign. The list
//! contains the plant of the main crop followed by those of optimised
//! components. Components beyond the end of the list use the plants of the
//! scene.
//! @param in the case of the scene; at a stage, plants have the age, the share
//! of paths and the random numbers of the stage
CanopyRequest request_of(Sampling sampling, const Campaign& campaign,
                         const Case& in, Scene scene, const Plants& plants);

//! Returns the schema of outcomes of a case at an accuracy.
OutcomeSchema outcome_schema(const Campaign& campaign, const Case& chosen,
                             const Accuracy& accuracy);

//! Returns the schema of the rows of a search or study: that of
//! outcome_schema() without quantities whose axes depend on varied keys of the
//! campaign, such as those by row of the field if the number of rows varies.
OutcomeSchema search_schema(const Campaign& campaign, const Case& chosen,
                            const Accuracy& accuracy);

//! Returns an objective or another scalar quantity. As the campaign states, an
//! objective is for one component, weighted over components or for all plants.
//! @throws Error if the report has no quantity of this name.
Randomised measure_number(const Campaign& campaign, const std::string& name,
                          const CanopyReport& report);

//! Returns the land equivalent ratio as the objective of a campaign; its
//! standard error includes the errors of sole-crop yields.
Estimate land_equivalent_ratio(const Campaign& campaign,
                               const CanopyReport& report);

//! Returns the leaf area index of plants without within-line variation, so that
//! constraints do not depend on random numbers.
//! @param plant mesh of one plant
//! @param ground_per_plant total ground area over number of plants [m2]
double lai_of_line(const Mesh& plant, double ground_per_plant);

//! Converts a report to the outcome of a plant, in a case with one scenario or
//! at one stage.
//! @param plant plant of the main crop, to which constraints apply; that of the
//! leaf area index applies at the density of the case
Outcome to_outcome(const Campaign& campaign, const Case& chosen,
                   const Plant& plant, const CanopyReport& report);

//! An outcome with values of its quantities by randomisation.
struct RandomisedOutcome {
    Outcome outcome;
    //! Quantities [randomisation, quantity]; NaN where unknown by
    //! randomisation.
    std::vector<std::vector<double>> quantities;
};

//! The scenarios of one case, set up once for all plants to be evaluated.
class Stand {
  public:
    //! Stores a reference to the campaign, which must outlive the stand.
    Stand(const Campaign& campaign, const Case& chosen);

    //! Returns the schema of outcomes in the search or in final evaluations.
    const OutcomeSchema& schema(bool is_final) const {
        return is_final ? final_schema_ : schema_;
    }

    //! Sets up the scenes of all scenarios, the light to which plants respond,
    //! and the work that the campaign's tolerance requires for the baseline;
    //! otherwise the first evaluation does so. All plants that are evaluated
    //! with the accuracy of the search are traced with this work. After this
    //! call several threads may evaluate, each with a different device.
    void prepare(const Device& device);

    //! Returns the outcome over all scenarios, a pure function of plants and
    //! sampling.
    //! @throws Error like ideotype::evaluate()
    Outcome evaluate(const Plants& plants, const Sampling& sampling,
                     const Device& device);

    //! Returns the outcome of evaluate() with quantities by randomisation.
    //! Plants with equal sampling use common random numbers.
    RandomisedOutcome evaluate_by_randomisation(const Plants& plants,
                                                const Sampling& sampling,
                                                const Device& device);

    //! Takes a report. Those of a scenario's stages come in order.
    using TakeReport = std::function<void(const Case&, CanopyReport)>;
    struct ReportOptions {
        bool sunlit = false;  //!< see Details::sunlit
        int threads = 1;
        Clock clock{};  //!< for CanopyReport::seconds; none: not measured
    };

    //! Evaluates plants in each scenario and stage, and then reports all in
    //! order. Scenarios of draws that change neither plants nor light share
    //! their traced light.
    void report_each(const Plants& plants, const Sampling& sampling,
                     const Device& device, const TakeReport& take,
                     const ReportOptions& options);
    void report_each(const Plants& plants, const Sampling& sampling,
                     const Device& device, const TakeReport& take) {
        report_each(plants, sampling, device, take, {});
    }

    //! Returns the days of the first scenario's season with soil, for means
    //! over randomisations, see Season::run().
    std::vector<SeasonState> season(const Plants& plants,
                                    const Sampling& sampling,
                                    const Device& device,
                                    const ControlDay& control);

  private:
    void find_work(const Device& device);

    //! Returns the request to evaluate plants in a case, after they have
    //! responded to the light of earlier stages.
    CanopyRequest request(std::size_t number, const Plants& plants,
                          const Sampling& sampling,
                          LightCue::Response& response) const;

    //! Computes cases that share their light.
    std::vector<LitCanopy> light(const std::vector<std::size_t>& numbers,
                                 const Plants& plants, const Sampling& sampling,
                                 const Device& device,
                                 LightCue::Response& response,
                                 const ReportOptions& options) const;

    struct Scenario {
        std::size_t first;  //!< index of its first case
        std::size_t cases;  //!< number of stages, or 1
        Season season;
        //! The first scenario with the same light, perhaps this one.
        std::size_t light;
    };

    const Campaign& campaign_;
    std::vector<Case> cases_;    //!< cases of each scenario and stage
    std::vector<Scene> scenes_;  //!< scenes, empty until set up
    //! Work for the light of each case, if the baseline determines it; none for
    //! cases that share the light of an earlier one.
    std::vector<std::optional<LightWork>> works_{};
    std::vector<Scenario> scenarios_{};
    LightCue cue_;
    AcrossScenarios across_;
    OutcomeSchema schema_, final_schema_;
};

//! Returns whether any panels track the sun, so that each instant needs a
//! separate sky.
bool has_trackers(const Campaign& campaign);

//! Adds the panels and objects of a campaign to a scene that already has its
//! components, cell and bands.
void add_objects(Scene& scene, const Campaign& campaign,
                 const Spacing& spacing);

}  // namespace ideotype
