#include "base/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

tl::unexpected<Diagnostics> fail(Diagnostic reason) {
    return tl::unexpected(Diagnostics{std::move(reason)});
}

tl::unexpected<Diagnostics> fail(Diagnostics reasons) {
    return tl::unexpected(std::move(reasons));
}

std::string to_string(const Diagnostic& diagnostic) {
    std::string place;
    if (!diagnostic.file.empty() && diagnostic.line > 0)
        place = fmt::format("{}:{}: ", diagnostic.file.string(), diagnostic.line);
    else if (!diagnostic.file.empty())
        place = diagnostic.file.string() + ": ";
    const char* kind = diagnostic.severity == Severity::error ? "error" : "warning";
    return fmt::format("{}{}: {}", place, kind, diagnostic.message);
}

std::string to_string(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics)
        text += to_string(diagnostic) + '\n';
    return text;
}

bool has_errors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
}
