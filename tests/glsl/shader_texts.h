#pragma once

#include "glsl/compile/check.h"
#include "glsl/text/include.h"
#include "model/look/look.h"

#include <filesystem>
#include <string>

/// A stage whose lines are all from one file, as if it had been loaded.
inline Stage stage_of(const std::string& file, const std::string& text) {
    Stage stage = builtin_stage(text);
    stage.file = file;
    const std::size_t count = stage.lines.size();
    stage.lines = {};
    stage.lines.append({file, 1}, count);
    return stage;
}

/// A fragment shader with these lines after its #version.
inline Stage fragment_with(const std::string& lines, const std::string& file = "a.frag") {
    return stage_of(file, "#version 410 core\n" + lines +
                              "\nout vec4 color;\nvoid main() { color = vec4(1.0); }\n");
}

inline Pass pass_of(const std::string& name, const Stage& fragment) {
    Pass pass;
    pass.name = name;
    pass.fragment = fragment;
    pass.declared = {"look.json", 7};
    return pass;
}

/// A look with one pass and these uniforms.
inline Look look_with(const std::string& lines) {
    Look look;
    look.passes.push_back(pass_of("main", fragment_with(lines)));
    return look;
}
