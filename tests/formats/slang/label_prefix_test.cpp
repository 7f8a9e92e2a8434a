#include "formats/slang/label_prefix.h"

#include <doctest/doctest.h>

namespace {
std::vector<std::string> shortened(const std::vector<std::string>& labels,
                                   const std::string& last_group = "") {
    std::vector<Parameter> parameters(labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i)
        parameters[i].label = labels[i];
    parameters.back().group = last_group;
    drop_common_prefixes(parameters);
    std::vector<std::string> result;
    for (const Parameter& parameter : parameters)
        result.push_back(parameter.label);
    return result;
}
using Labels = std::vector<std::string>;
}  // namespace

TEST_CASE("a common prefix of all labels in a group is removed") {
    CHECK(shortened({"CRTGeom Curvature", "CRTGeom X Size", "CRTGeom Tilt", "CRTGeom: gamma"}) ==
          Labels{"Curvature", "X Size", "Tilt", "Gamma"});
    CHECK(shortened({"My CRT Mask", "My CRT Glow", "My CRT Blur", "My CRT Gain"}) ==
          Labels{"Mask", "Glow", "Blur", "Gain"});
}

TEST_CASE("labels without a common prefix, too short or too few, stay unchanged") {
    for (const Labels& labels : {Labels{"Mask size", "Mask type", "Mask gain", "Glow gain"},
                                 Labels{"Mask size", "Mask type", "Mask gain", "Mask"},
                                 Labels{"Mask size", "Mask type", "Mask gain"},
                                 Labels{"Gamma 1", "Gamma 2", "Gamma 3", "Gamma 4"},
                                 Labels{"Masks a", "Mask b", "Mask c", "Mask d"}})
        CHECK(shortened(labels) == labels);
    const Labels apart{"Mask size", "Mask type", "Mask gain", "Mask blur"};
    CHECK(shortened(apart, "Another group") == apart);
}

TEST_CASE("the full label becomes the help of a parameter without one") {
    std::vector<Parameter> parameters(4);
    for (Parameter& parameter : parameters)
        parameter.label = "CRTGeom Tilt";
    parameters[1].help = "says more";
    drop_common_prefixes(parameters);
    CHECK(parameters[0].help == "CRTGeom Tilt");
    CHECK(parameters[1].help == "says more");
}
