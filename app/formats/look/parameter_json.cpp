#include "formats/look/parameter_json.h"

#include "formats/json/value_json.h"

#include <nlohmann/json.hpp>

using Json = nlohmann::ordered_json;

namespace {
Json item_json(const Item& item) {
    Json json{{"value", item.value}, {"label", item.label}};
    if (!item.note.empty())
        json["note"] = item.note;
    if (item.color)
        json["color"] = *item.color;
    return json;
}

const char* scale_name(Scale scale) {
    switch (scale) {
        case Scale::linear:
            return "linear";
        case Scale::logarithmic:
            return "log";
        case Scale::half_life:
            return "half-life";
    }
    return "";
}
}  // namespace

Json parameter_json(const Parameter& parameter, const Look& look, const Values& values) {
    Json json{{"name", parameter.name},
              {"type", type_name(parameter)},
              {"default", json_of(parameter.initial, &parameter)},
              {"value", json_of(value_of(parameter, values), &parameter)},
              {"min", parameter.range.low},
              {"max", parameter.range.high},
              {"step", parameter.range.step},
              {"scale", scale_name(parameter.scale)},
              {"label", parameter.label},
              {"unit", parameter.unit},
              {"group", parameter.group},
              {"help", parameter.help},
              {"items", Json::array()},
              {"passes", Json::array()}};
    if (parameter.control == Control::color && parameter.encoding == Encoding::display)
        json["encoding"] = "display";
    if (parameter.is_constant)
        json["constant"] = true;
    if (!parameter.when.empty())
        json["when"] = parameter.when;
    if (parameter.is_fixed_in_random)
        json["random"] = false;
    for (const Range& axis : parameter.axes)
        json["axes"].push_back({{"min", axis.low}, {"max", axis.high}});
    for (const Item& item : parameter.items)
        json["items"].push_back(item_json(item));
    for (const Binding& binding : parameter.bindings) {
        const std::string& pass = look.passes[static_cast<std::size_t>(binding.pass)].name;
        if (json["passes"].empty() || json["passes"].back() != pass)
            json["passes"].push_back(pass);
    }
    return json;
}
