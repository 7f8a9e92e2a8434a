#pragma once

#include <string>
#include <string_view>
#include <vector>

/// One problem that glslang reports.
struct CompilerMessage {
    int line = 0;         // of the text; 0: not known
    std::string text;     // glslang's words without their trimmings
    std::string subject;  // a name that the message is about, when it has no line
    bool is_warning = false;
    bool is_about_vertex_stage = false;  // of a link message
};

inline constexpr const char* refused_without_reason =
    "glslang rejected the shader without giving a reason";

/// Reads glslang's info log: messages without the lines that only count or close them.
std::vector<CompilerMessage> parse_compiler_log(std::string_view log);
