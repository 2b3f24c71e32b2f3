// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/sensors.hpp"
#include "ideotype/light/device.hpp"
#include "stand/stand.hpp"

namespace ideotype::python {

//! A pool of devices, from which each evaluating thread borrows one.
class Devices {
  public:
    explicit Devices(std::string isa) : isa_(std::move(isa)) {}

    const std::string& isa() const { return isa_; }

    //! Calls a function with a device that no other thread is using.
    template <class Action>
    auto with(Action action) {
        std::unique_ptr<Device> device = take();
        struct Return {
            Devices& devices;
            std::unique_ptr<Device>& device;
            ~Return() {
                const std::lock_guard lock(devices.mutex_);
                devices.idle_.push_back(std::move(device));
            }
        } give_back{*this, device};
        return action(*device);
    }

  private:
    std::unique_ptr<Device> take() {
        const std::lock_guard lock(mutex_);
        if (idle_.empty()) return std::make_unique<Device>(isa_);
        std::unique_ptr<Device> device = std::move(idle_.back());
        idle_.pop_back();
        return device;
    }

    std::string isa_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Device>> idle_;
};

//! The stand of one case of a campaign. Several threads may evaluate at a time.
//! Genomes are like those in histories: values of varied campaign keys may
//! follow the traits.
class CaseStand {
  public:
    //! @param isa instruction set; "": the widest that this processor supports
    //! @throws Error if the case does not exist.
    CaseStand(Campaign campaign, const Case& chosen, const std::string& isa);
    CaseStand(const CaseStand&) = delete;
    CaseStand& operator=(const CaseStand&) = delete;

    const Campaign& campaign() const { return campaign_; }
    const Case& chosen() const { return chosen_; }
    const std::string& isa() const { return devices_.isa(); }
    const OutcomeSchema& schema() const { return stand_.schema(false); }

    //! Returns the plants of a genome, in which values of varied keys may
    //! follow the traits.
    Plants grown(const Genome& genome) const;

    //! Evaluates a plant. Values of varied keys may follow the traits in its
    //! genome. If the evaluation fails, the outcome states the reason.
    //! @throws Error if the task is impossible.
    Outcome evaluate(const Genome& genome, const Task& task);

    //! Returns the mesh of a component's plant at the origin, with y along the
    //! row [m].
    //! @param thermal_time time since emergence [deg C d]; nothing: full-grown
    //! @throws Error if a time is given but plants of the component do not grow
    Mesh mesh(const Genome& genome, std::size_t component,
              std::optional<double> thermal_time) const;

    //! Returns the mesh of the first field that evaluations with this seed
    //! draw: one periodic cell, with within-line variation.
    Mesh field_mesh(const Genome& genome) const;

    //! Computes the light on sensors among the plants of a genome at each
    //! instant by light_on_sensors(), averaged over a number of fields.
    std::vector<std::vector<Estimate>> light_on_sensors(
        const Genome& genome, const std::vector<Sensor>& sensors, int fields,
        int points);

    //! Returns the days of the first scenario's season, see Stand::season().
    //! @throws Error if the campaign has no soil.
    std::vector<SeasonState> season(const Genome& genome,
                                    const ControlDay& control);

    //! Returns the light series of the case, or of its first scenario.
    LightSeries light() const;

  protected:
    //! Returns a stand in which the varied keys are set from the end of a
    //! genome, and removes their values from the genome. Returns null if the
    //! genome contains no keys.
    std::unique_ptr<CaseStand> at_own_keys(Genome& genome) const;

    Campaign campaign_;
    Case chosen_;
    Stand stand_;
    Devices devices_;
};

}  // namespace ideotype::python
