#pragma once

#include "model/preset/preset.h"

/// A look with a parameter of every type, and a preset for it.
inline Look sample_look() {
    const auto parameter = [](std::string name, NumberType type, Value initial) {
        Parameter made;
        made.name = made.label = std::move(name);
        made.type = type;
        made.initial = std::move(initial);
        return made;
    };
    Look look;
    look.id = "phosphor";
    look.name = "Phosphor";
    look.parameters = {
        parameter("decay", {}, 0.92),
        parameter("bloom_intensity", {}, 0.5),
        parameter("points", {Scalar::integer}, 4096.0),
        parameter("as_written", {Scalar::boolean}, 0.0),
        parameter("tone_map", {Scalar::integer}, 1.0),
        parameter("beam_color", {Scalar::floating, 3}, Value({0.2, 1.0, 0.3})),
        parameter("noise", {}, Value::of_path("noise.png")),
    };
    look.parameters[0].limit = Limit{0.0, 1.0};
    look.parameters[1].was = "bloom_strength";
    look.parameters[4].control = Control::list;
    look.parameters[4].items = {{0, "Clamp"}, {1, "Reinhard"}, {2, "ACES"}};
    look.parameters[5].control = Control::color;
    look.parameters[6].control = Control::image;
    return look;
}

inline Preset sample_preset() {
    Preset preset;
    preset.look = "phosphor";
    preset.digest = "8c1f02aa";
    preset.name = "P31 bench scope";
    preset.signal = Spec{"lissajous", {{"x", 3.0}, {"y", 2.0}}};
    preset.values = {{"bloom_intensity", 0.8}, {"decay", 0.94}};
    return preset;
}
