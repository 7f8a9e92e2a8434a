#pragma once

#include "lab/document/document.h"
#include "lab/window/window_state.h"

/// Parameters under a common heading.
struct ParameterGroup {
    std::string name;
    std::vector<const Parameter*> parameters;
};

/// The filter of the parameter list.
struct ParameterQuery {
    std::string search = {};  // each word must occur in name, label, group, unit or help
    ParameterFilter filter = ParameterFilter::all;
    std::string pass = {};  // for ParameterFilter::of_pass
};

/// The listed parameters of the open look, in its order. An unknown pass uses no parameters.
std::vector<ParameterGroup> listed_parameters(const Document& document,
                                              const ParameterQuery& query);

/// The filter of the parameters panel.
ParameterQuery query_of(const WindowState& window);

/// The number `by` lines below `current` in the list (negative: above), limited to the list. Each
/// component of a vector has its own line. If `current` is not listed, the first or last number.
/// nullopt: the list is empty.
std::optional<Pointed> listed_neighbour(const std::vector<ParameterGroup>& groups,
                                        const Pointed& current, int by);

/// The message for an empty list.
std::string empty_list_text(const ParameterQuery& query);
