#include "model/look/shader_limits.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

Result<void> set_limit(ShaderLimits& limits, std::string_view text) {
    constexpr double maximum = 1e12;
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string_view name = text.substr(0, equals);
    const auto limit = std::ranges::find(shader_limits, name, &ShaderLimit::name);
    if (limit == shader_limits.end()) {
        std::vector<std::string> names;
        for (const ShaderLimit& known : shader_limits)
            names.emplace_back(known.name);
        return fail(
            {{},
             0,
             fmt::format("unknown limit '{}'; use one of: {}", name, fmt::join(names, ", "))});
    }
    const auto value = parse_number(text.substr(std::min(equals + 1, text.size())));
    if (!value || *value < 1.0 || *value > maximum ||
        *value != static_cast<double>(static_cast<long long>(*value)))
        return fail({{}, 0, fmt::format("'{}' must be a whole number from 1 to 1e12", name)});
    limits.*limit->value = *value;
    return {};
}

std::string to_string(const ShaderLimits& limits) {
    std::string text;
    for (const ShaderLimit& limit : shader_limits)
        text += fmt::format("{}={:.0f} ", limit.name, limits.*limit.value);
    return text;
}
