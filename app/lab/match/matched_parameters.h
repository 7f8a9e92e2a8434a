#pragma once

#include "lab/document/document.h"
#include "lab/match/unknown.h"

#include <set>
#include <string>
#include <vector>

/// What the user says about the parameters to find. Names as in `--set`.
struct MatchChoice {
    std::vector<std::string> locked = {};  // keep their values
    std::vector<std::string> fitted = {};  // also found, or alone if the look has no @photo
};

/// The parameters to find, in the order of the look.
struct MatchedParameters {
    std::vector<const Parameter*> shape = {};
    std::vector<const Parameter*> pitch = {};
    std::vector<const Parameter*> lines = {};
    std::vector<const Parameter*> types = {};
    std::vector<const Parameter*> amounts = {};
    std::vector<const Parameter*> starts = {};  // not to be found
    std::vector<const Parameter*> hidden = {};  // drawn with their identity
    std::vector<const Parameter*> tubes = {};   // lists, only in videos
    std::vector<const Parameter*> decays = {};  // only in videos

    bool is_empty() const;
};

/// The parameters with a role in photos that are not locked and have an effect with these values,
/// and those that the user wants, as amounts if they have no role. Fails for unknown names, and for
/// parameters that are no plain numbers.
Result<MatchedParameters> matched_parameters(const Document& document, const MatchChoice& choice);

/// The lists of tubes and the decays, and what the user wants as amounts, for a video of fading
/// light. Fails for unknown names, for parameters that are not one number, and if there is nothing
/// to find.
Result<MatchedParameters> decay_parameters(const Document& document, const MatchChoice& choice);

/// The names of the numbers to find.
std::set<std::string> names_of_numbers(const MatchedParameters& parameters);

/// The unknowns of these parameters, with the ranges of their sliders.
std::vector<Unknown> unknowns_of(const std::vector<const Parameter*>& parameters);

/// The values that a fit begins with: the document's, except those with a start of their own in the
/// look, and the identity of hidden ones. An amount that turns a pattern off is raised, because
/// nothing else about the pattern would show.
Values starting_values(const Document& document, const MatchedParameters& parameters);
