// SPDX-License-Identifier: Apache-2.0
//! Runs the real loop, dispatcher and messages of the master on a simulated
//! cluster, see README.md.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <mpi.h>
#include <simgrid/s4u.hpp>
#include <smpi/smpi.h>

#include "fake_evaluator.hpp"
#include "ideotype/core/stop_flag.hpp"
#include "options.hpp"
#include "run/evolve_case.hpp"
#include "run/job/masters.hpp"
#include "run/provenance.hpp"

namespace ideotype {

namespace {

namespace s4u = simgrid::s4u;

//! A master that also spends the simulated time of rank 0's computations.
class Master : public Director, public Watcher {
  public:
    Master(const Options& options, const Campaign& campaign,
           Dispatcher& dispatcher, const RankClock& clock,
           const HistoryHeader& header, std::vector<Case> cases)
        : options_(options),
          campaign_(campaign),
          dispatcher_(dispatcher),
          clock_(clock),
          header_(header),
          cases_(std::move(cases)) {}

    bool start_next() override {
        if (started_.size() == cases_.size()) return false;
        started_.emplace_back(*this, cases_[started_.size()]);
        started_.back().routine->start();
        return true;
    }
    void on_silence(const Task&, const std::string& what) override {
        throw Error(what);
    }
    void on_stop(int) override {}

    void on_evaluation(const Task&, const Outcome&) override {
        spend(options_.master_per_evaluation);
        ++evaluations;
    }
    void on_generation(std::uint32_t, std::uint32_t,
                       const GenerationSummary& rows) override {
        spend(options_.master_per_row * rows.evaluations);
        if (clock_.now() - synchronized_ < 1) return;
        spend(options_.master_per_second);
        synchronized_ = clock_.now();
    }
    void on_final(const std::string&) override { ended = clock_.now(); }

    long evaluations = 0;
    double busy = 0;   //!< time of computing [s]
    double ended = 0;  //!< time when the last case came to its finalists [s]

    void spend(double seconds) {
        SimulatedClock::spend(seconds);
        busy += seconds;
    }

  private:
    //! An optimizer that takes simulated time.
    class SlowOptimizer : public Optimizer {
      public:
        SlowOptimizer(Master& master, const Case& chosen)
            : master_(master),
              fast_(make_optimizer(master.campaign_.search,
                                   search_space(master.campaign_, chosen),
                                   chosen.seed)) {}

        std::size_t size(std::uint32_t generation) const override {
            return fast_->size(generation);
        }
        std::uint64_t needs(std::uint32_t generation) const override {
            return fast_->needs(generation);
        }
        Candidate propose(std::uint32_t generation,
                          std::uint32_t slot) override {
            master_.spend(master_.options_.master_per_proposal);
            return fast_->propose(generation, slot);
        }
        void learn(Individual row) override {
            // The time of learning is spent at the end of a generation, when
            // plants are ranked.
            if (++rows_ == fast_->size(generation_)) {
                master_.spend(master_.options_.master_per_candidate *
                              static_cast<double>(rows_));
                rows_ = 0;
                ++generation_;
            }
            fast_->learn(std::move(row));
        }
        std::vector<Candidate> best(std::size_t count) const override {
            return fast_->best(count);
        }

      private:
        Master& master_;
        std::unique_ptr<Optimizer> fast_;
        std::size_t rows_ = 0;  //!< rows learnt of this generation
        std::uint32_t generation_ = 0;
    };

    struct EvolvingCase {
        EvolvingCase(Master& master, const Case& chosen)
            : history(History::create(
                  fmt::format("{}/{}.h5", master.options_.folder, chosen.index),
                  master.header_)),
              optimizer(master, chosen) {
            routine = std::make_unique<Routine<Ending>>(evolve_case(
                {master.campaign_, chosen, optimizer, master.dispatcher_,
                 master, [&master] { return master.clock_.now(); }},
                history));
        }

        History history;
        SlowOptimizer optimizer;
        std::unique_ptr<Routine<Ending>> routine;
    };

    const Options& options_;
    const Campaign& campaign_;
    Dispatcher& dispatcher_;
    const RankClock& clock_;
    const HistoryHeader& header_;
    std::vector<Case> cases_;
    std::list<EvolvingCase> started_;
    double synchronized_ = 0;  //!< time when the disk had all data [s]
};

//! The data that all ranks of a simulation share.
struct SimulatedRun {
    explicit SimulatedRun(const Options& its_options)
        : options(its_options),
          campaign(read_campaign(IDEOTYPE_CAMPAIGNS "/ames.toml",
                                 {"search.optimizer=" + options.optimizer})) {
        campaign.search.population = options.population;
        campaign.search.streams = options.streams;
        campaign.stop.generations = options.generations;
        cases.assign(static_cast<std::size_t>(options.cases),
                     ideotype::cases(campaign).front());
        for (int i = 0; i < options.cases; ++i) {
            Case& simulated = cases[static_cast<std::size_t>(i)];
            simulated.index = i;
            simulated.seed += static_cast<std::uint64_t>(i);
        }
        header = header_of(campaign, cases.front(), "none");
        evaluator =
            std::make_unique<FakeEvaluator>(header.schema, options.evaluation);
    }

    //! Runs the loop of one master.
    void direct(const Session& crew, int part, int parts) {
        const auto dispatcher = make_dispatcher(crew, {evaluator.get()}, stop);
        const Share share = dealt(options.cases, part, parts);
        const auto first =
            cases.begin() + static_cast<std::ptrdiff_t>(share.first);
        Master master(
            options, campaign, *dispatcher, clock, header,
            {first, first + static_cast<std::ptrdiff_t>(share.count)});
        began = clock.now();
        dispatcher->run(master);
        if (!dispatcher->dismiss()) throw Error("a worker does not answer");
        ended = std::max(ended, master.ended);
        busiest = std::max(busiest, master.busy);
        evaluations += master.evaluations;
    }

    //! Prints one line; returns whether the efficiency reaches the limit.
    bool report() const {
        const double seconds = ended - began;
        const double efficiency = evaluator->total() / options.ranks / seconds;
        fmt::print(
            "{:>6} {:>6} {:>7} {:>10} {:>8.0f} {:>9.2f} {:>11.0f} "
            "{:>10.1f}\n",
            options.ranks, options.cases,
            masters(options.masters, options.ranks, options.cases),
            options.population, 1e3 * options.evaluation, seconds,
            100 * busiest / seconds, 100 * efficiency);
        return efficiency >= options.least;
    }

    Options options;
    SimulatedClock clock{options.nap_slack};
    StopFlag stop;
    Campaign campaign;
    HistoryHeader header;
    std::unique_ptr<FakeEvaluator> evaluator;
    std::vector<Case> cases;
    double began = 0;
    double ended = 0;
    double busiest = 0;  //!< computing time of the busiest master [s]
    long evaluations = 0;
};

void live(SimulatedRun& simulation) try {
    const Session session(simulation.clock);
    const int parts = masters(simulation.options.masters, session.size(),
                              simulation.options.cases);
    const int part = part_of(session.rank(), session.size(),
                             simulation.options.cases, parts);
    const Session crew = session.split(part);
    if (crew.rank() == 0)
        simulation.direct(crew, part, parts);
    else
        serve(crew, {simulation.evaluator.get()});
} catch (const std::exception& error) {
    fmt::print(stderr, "scale: {}\n", error.what());
    std::exit(1);
}

void simulate(s4u::Engine& engine, SimulatedRun& simulation) {
    const char* name = "ideotype";
    const int ranks = simulation.options.ranks;
    engine.load_platform(IDEOTYPE_CLUSTER);
    const std::vector<s4u::Host*> nodes = engine.get_all_hosts();
    SMPI_app_instance_register(name, nullptr, ranks);
    SMPI_init();
    for (int rank = 0; rank < ranks; ++rank) {
        const std::string number = std::to_string(rank);
        s4u::Host* node = nodes.at(
            static_cast<std::size_t>(rank / simulation.options.ranks_per_node));
        const auto actor = s4u::Actor::init("rank" + number, node);
        actor->set_property("instance_id", name);
        actor->set_property("rank", number);
        actor->start([&simulation] { live(simulation); });
    }
    engine.run();
    SMPI_finalize();
}

}  // namespace

}  // namespace ideotype

int main(int argc, char** argv) {
    using namespace ideotype;
    s4u::Engine engine(&argc, argv);
    // Computations of ranks take no simulated time unless spend() is called,
    // and an eager message is sent as soon as it is posted.
    for (const char* setting :
         {"smpi/simulate-computation:no", "smpi/iprobe:0", "smpi/test:0",
          "smpi/async-small-thresh:65536", "contexts/stack-size:512"})
        s4u::Engine::set_config(setting);
    const Options options = read_options(argc, argv);
    std::filesystem::create_directories(options.folder);
    SimulatedRun simulation(options);
    simulate(engine, simulation);
    std::filesystem::remove_all(options.folder);
    return simulation.report() ? 0 : 1;
}
