#include "formats/slang_export/simple_slang_preset.h"

#include "base/text.h"
#include "formats/slang/files.h"

#include <fmt/format.h>

#include <cmath>

namespace fs = std::filesystem;

namespace {
// Shaders use 32-bit floats, so a preset needs no more digits.
std::string shortest_number(double number) {
    const auto single = static_cast<float>(number);
    return static_cast<double>(single) == number ||
                   std::abs(number - single) <= 1e-7 * std::abs(number)
               ? format_float(single)
               : format_number(number);
}
}  // namespace

std::string simple_slang_preset(const fs::path& referred,
                                const std::map<std::string, double>& values,
                                const fs::path& saved_as) {
    const fs::path target = fs::absolute(referred).lexically_normal();
    const fs::path folder = fs::absolute(saved_as).lexically_normal().parent_path();
    const fs::path relative = target.lexically_relative(folder);
    const fs::path& written = relative.empty() ? target : relative;
    const char* const line =
        is_slang_shader(target) ? "shaders = \"1\"\nshader0 = " : "#reference ";
    std::string text = fmt::format("{}\"{}\"\n", line, written.generic_string());
    if (!values.empty())
        text += '\n';
    for (const auto& [name, number] : values)
        text += fmt::format("{} = \"{}\"\n", name, shortest_number(number));
    return text;
}
