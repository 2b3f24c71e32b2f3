// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "cli/formats/json.hpp"
#include "stand/stand.hpp"

namespace ideotype {

//! The case that evaluates sent genomes, and the figures of each answer.
struct ServedCase {
    ServedCase(const Campaign& of, int index, const std::string& path);

    const Campaign& campaign;
    Case chosen;
    GeneSpace genes;
    Genome baseline;
    //! The schema without objectives by randomisation, whose number depends on
    //! each request's tolerance.
    OutcomeSchema schema;
};

//! The evaluation that a line asks for.
struct GenomeRequest {
    Json id;  //!< identity of the request for the answer; may be null
    std::uint64_t line = 0;  //!< line of the request, from 1
    Genome genome;           //!< values of all genes
    Task task{};
    std::vector<std::string> quantities{};  //!< told besides the objectives
};

//! Returns the first line of the output: genes, objectives and quantities.
Json hello(const ServedCase& served, int workers);

//! @throws Error if the text is no JSON.
Json parse_line(const std::string& text);

//! Returns the member `id` of an object, or null if there is none.
Json id_of(const Json& json);

//! @throws Error that tells the fault of the request.
GenomeRequest read_request(const Json& json, const ServedCase& served);

//! Returns the line about an outcome of a request.
Json answer(const GenomeRequest& request, const Outcome& outcome,
            const OutcomeSchema& schema);

//! Returns the line about a request that cannot be evaluated.
Json refusal(const Json& id, std::uint64_t line, const std::string& message);

}  // namespace ideotype
