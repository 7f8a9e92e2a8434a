#pragma once

#include "lab/document.h"
#include "lab/window_state.h"

/// Parameters under their heading.
struct ParameterGroup {
    std::string name;
    std::vector<const Parameter*> parameters;
};

/// Which parameters a person wants to see.
struct ParameterQuery {
    std::string words = {};  // each of them somewhere in its name, label, group, unit or help
    ParameterFilter filter = ParameterFilter::all;
    std::string pass = {};  // whose parameters ParameterFilter::of_pass lists
};

/// What is to be listed of the open look, in its order; a pass that is not there uses nothing.
std::vector<ParameterGroup> listed_parameters(const Document& document,
                                              const ParameterQuery& query);

/// What a person is told when that is nothing.
std::string why_nothing_is_listed(const ParameterQuery& query);
