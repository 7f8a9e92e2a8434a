#include "formats/look/describe.h"

#include "formats/json/json_text.h"
#include "formats/json/value_json.h"
#include "formats/look/look_names.h"
#include "formats/look/parameter_json.h"
#include "formats/preset/modulation_format.h"
#include "model/look/orbit.h"
#include "model/look/subframe.h"

#include <nlohmann/json.hpp>

using Json = nlohmann::ordered_json;

namespace {
Json described(const Input& input) {
    return {{"name", input.uniform},
            {"from", input.reference()},
            {"filter", name_of(filter_names(), input.sampler.filter)},
            {"wrap", name_of(wrap_names(), input.sampler.wrap)},
            {"mipmap", input.sampler.mipmap}};
}

Json described(const Pass& pass, const PlannedTarget& target) {
    Json json{{"name", pass.name},
              {"draw", pass.draw == Draw::quad ? "quad" : name_of(draw_names(), pass.draw)},
              {"vertex", pass.vertex.text},
              {"fragment", pass.fragment.text},
              {"format", name_of(format_names(), target.format)},
              {"width", target.extent.width},
              {"height", target.extent.height},
              {"blend", name_of(blend_names(), pass.blend)},
              {"inputs", Json::array()},
              {"set", Json::object()}};
    for (const Input& input : pass.inputs)
        json["inputs"].push_back(described(input));
    for (const auto& [uniform, value] : pass.set)
        json["set"][uniform] = json_of(value);
    return json;
}

// Adds rarely used members only where present.
void add_rarities(const Pass& pass, const Values& values, const Look& look, Json& json) {
    if (!pass.rename.empty())
        json["rename"] = pass.rename;
    if (pass.accumulate)
        json["accumulate"] = true;
    if (pass.frame_modulo > 0)
        json["frame_modulo"] = pass.frame_modulo;
    if (pass.per_source_frame)
        json["per_source_frame"] = true;
    if (pass.repeat != Count(1))
        json["repeat"] = count_of(pass.repeat, look, values);
    if (pass.converge)
        json["converge"] = count_of(*pass.converge, look, values);
}

bool is_given(const Look& look, int pass, const char* uniform) {
    return std::ranges::any_of(look.parameters, [&](const Parameter& parameter) {
        return std::ranges::find(parameter.bindings, Binding{pass, uniform}) !=
               parameter.bindings.end();
    });
}

// Adds the orbit's matrices for the pass.
void add_orbit(const Look& look, const Values& values, int pass, Json& set) {
    const Orbit orbit = orbit_of(look, values, pass);
    if (is_given(look, pass, "u_view"))
        set["u_view"] = view_matrix(orbit);
    if (is_given(look, pass, "u_camera"))
        set["u_camera"] = camera_matrix(orbit);
}

Json described(const Image& image) {
    return {{"name", image.name},
            {"file", image.file.string()},
            {"filter", name_of(filter_names(), image.sampler.filter)},
            {"wrap", name_of(wrap_names(), image.sampler.wrap)},
            {"mipmap", image.sampler.mipmap},
            {"linear", image.is_linear}};
}
}  // namespace

std::string describe_json(const Look& look, const Plan& plan, const Values& values,
                          const Modulations& modulations) {
    Json json{{"name", look.name},
              {"license", look.license},
              {"passes", Json::array()},
              {"images", Json::array()},
              {"parameters", Json::array()}};
    if (const int subframes = subframes_of(look, values); subframes > 1)
        json["subframes"] = subframes;
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        Json pass = described(look.passes[i], plan.targets[i]);
        add_rarities(look.passes[i], values, look, pass);
        add_orbit(look, values, static_cast<int>(i), pass["set"]);
        json["passes"].push_back(std::move(pass));
    }
    for (const Image& image : look.images)
        json["images"].push_back(described(image));
    for (const Parameter& parameter : look.parameters) {
        Json described_one = parameter_json(parameter, look, values);
        if (const auto moving = modulations.find(parameter.name); moving != modulations.end())
            described_one["modulation"] = json_of(moving->second);
        json["parameters"].push_back(std::move(described_one));
    }
    return json_text(json);
}
