#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A message of glslang.
struct CompilerMessage {
    int line = 0;         // of the text; 0: unknown
    std::string text;     // glslang's message without decoration
    std::string subject;  // a name in a message without a line
    bool is_warning = false;
    bool is_about_vertex_stage = false;  // for link messages
};

inline constexpr const char* refused_without_reason =
    "glslang rejected the shader without giving a reason";

/// Parses glslang's info log, without summary lines.
std::vector<CompilerMessage> parse_compiler_log(std::string_view log);
