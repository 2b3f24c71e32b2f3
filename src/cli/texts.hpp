// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ideotype {

//! The form of a campaign file, from verbs/campaign_form.txt. A key without
//! value gets its default, and a key without note its meaning.
extern const char* const campaign_form;

//! The verbs that Python answers, from verbs.txt of the Python package: in each
//! line the name, the function that answers, and what the verb does.
extern const char* const python_verbs_text;

}  // namespace ideotype
