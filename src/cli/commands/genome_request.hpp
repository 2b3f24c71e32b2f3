// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "cli/formats/json.hpp"
#include "stand/stand.hpp"

namespace ideotype {

//! The case in which genomes are evaluated, and the schema of answers.
struct ServedCase {
    ServedCase(const Campaign& of, int index, const std::string& path);

    const Campaign& campaign;
    Case chosen;
    GeneSpace genes;
    Genome baseline;
    //! The schema without objectives by randomisation, since the number of
    //! randomisations depends on the tolerance of each request.
    OutcomeSchema schema;
};

//! The evaluation that a line requests.
struct GenomeRequest {
    Json id;  //!< identifier that the answer repeats; may be null
    std::uint64_t line = 0;  //!< line of the request, from 1
    Genome genome;           //!< values of all genes
    Task task{};
    std::vector<std::string>
        quantities{};  //!< quantities to report in addition to objectives
};

//! Returns the first line of output, which describes genes, objectives and
//! quantities.
Json hello(const ServedCase& served, int workers);

//! @throws Error if the text is not JSON.
Json parse_line(const std::string& text);

//! Returns the member `id` of an object, or null if there is none.
Json id_of(const Json& json);

//! @throws Error that describes the fault of the request.
GenomeRequest read_request(const Json& json, const ServedCase& served);

//! Returns the line that answers a request.
Json answer(const GenomeRequest& request, const Outcome& outcome,
            const OutcomeSchema& schema);

//! Returns the line that refuses a request.
Json refusal(const Json& id, std::uint64_t line, const std::string& message);

}  // namespace ideotype
