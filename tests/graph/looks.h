#pragma once

#include "gpu/headless.h"
#include "gpu/objects/readback.h"
#include "graph/executor/executor.h"

#include <string>
#include <utility>
#include <vector>

/// A fragment stage with these declarations and main. All its lines map to "test.frag".
inline Stage fragment(const std::string& body) {
    Stage stage{"test.frag", "#version 410 core\nin vec2 uv;\nout vec4 color;\n" + body, {}};
    for (int line = 1; line <= 40; ++line)
        stage.lines.push_back({"test.frag", line});
    return stage;
}

/// A copy of the map in which line `index` has another origin.
inline LineMap with_line(const LineMap& lines, std::size_t index, const Location& at) {
    LineMap changed;
    for (std::size_t i = 0; i < lines.size(); ++i)
        changed.push_back(i == index ? at : lines[i]);
    return changed;
}

inline Input reads(const std::string& uniform, const std::string& pass, int frames_ago = 0,
                   Sampler sampler = {Filter::nearest, Wrap::edge, false}) {
    return {uniform, Input::From::pass, pass, frames_ago, sampler};
}

/// A fullscreen pass into a float target with the size of the viewport.
inline Pass pass(const std::string& name, const std::string& body, std::vector<Input> inputs = {}) {
    Pass made;
    made.name = name;
    made.fragment = fragment(body);
    made.format = Format::rgba32f;
    made.inputs = std::move(inputs);
    made.declared = {"look.json", 5};
    return made;
}

/// Adds one to its output of the previous frame, in red.
inline Pass counter() {
    return pass("counter",
                "uniform sampler2D previous;\n"
                "void main() { color = vec4(texture(previous, uv).r + 1.0, 0, 0, 1); }\n",
                {reads("previous", "counter", 1)});
}

inline Look look_of(std::vector<Pass> passes, std::vector<Parameter> parameters = {}) {
    Look look;
    look.name = "test";
    look.passes = std::move(passes);
    look.parameters = std::move(parameters);
    look.manifest = "look.json";
    return look;
}

inline Parameter parameter_named(const std::string& name, NumberType type, Value initial,
                                 std::vector<Binding> bindings) {
    Parameter made;
    made.name = name;
    made.type = type;
    made.initial = std::move(initial);
    made.bindings = std::move(bindings);
    return made;
}

inline Programs programs_of(const Look& look, const Programs* reuse = nullptr) {
    auto programs = build_programs(look, reuse);
    if (!programs)
        FAIL(to_string(programs.error()));
    return std::move(*programs);
}

/// An executor that is ready to draw.
inline Executor executor_of(const Look& look, Extent viewport = {4, 4}, Extent source = {}) {
    Executor executor(look, programs_of(look));
    const auto sized = executor.resize(viewport, source);
    if (!sized)
        FAIL(to_string(sized.error()));
    return executor;
}

/// Frame `number` at 60 fps.
inline Frame frame(int number) {
    Frame made;
    made.number = number;
    made.time = number / 60.0;
    made.time_delta = 1.0 / 60.0;
    made.is_first = number == 1;
    return made;
}

inline std::array<float, 4> pixel(const Executor& executor, int pass, int x = 0, int y = 0) {
    return gpu::read_pixel(executor.target(pass), x, y);
}

inline float red(const Executor& executor, int pass, int x = 0, int y = 0) {
    return pixel(executor, pass, x, y)[0];
}

using Rgba = std::array<float, 4>;
