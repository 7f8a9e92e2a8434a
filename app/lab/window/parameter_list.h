#pragma once

#include "lab/document/document.h"
#include "lab/window/window_state.h"

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

/// What the panel lists.
ParameterQuery query_of(const WindowState& window);

/// The number that stands `by` lines below (above, where negative) another one in that list, held
/// within it: each part of a vector has a line of its own. From one that is not listed, the first
/// or the last; none where nothing is listed.
std::optional<Pointed> listed_beside(const std::vector<ParameterGroup>& groups,
                                     const Pointed& present, int by);

/// What a person is told when that is nothing.
std::string why_nothing_is_listed(const ParameterQuery& query);
