#include "base/diagnostic.h"

#include "base/printable.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr std::ptrdiff_t max_per_severity = 256;

// Compares the most distinctive members first, because comparing paths is slow.
bool are_same(const Diagnostic& a, const Diagnostic& b) {
    return a.line == b.line && a.message == b.message && a.severity == b.severity &&
           a.file.native() == b.file.native();
}
}  // namespace

tl::unexpected<Diagnostics> fail(Diagnostic reason) {
    return tl::unexpected(Diagnostics{std::move(reason)});
}

tl::unexpected<Diagnostics> fail(Diagnostics reasons) {
    return tl::unexpected(std::move(reasons));
}

std::string to_string(const Diagnostic& diagnostic) {
    std::string location;
    if (!diagnostic.file.empty() && diagnostic.line > 0)
        location = fmt::format("{}:{}: ", diagnostic.file.string(), diagnostic.line);
    else if (!diagnostic.file.empty())
        location = diagnostic.file.string() + ": ";
    const char* kind = diagnostic.severity == Severity::error ? "error" : "warning";
    return printable(fmt::format("{}{}: {}", location, kind, diagnostic.message));
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

void add_new(Diagnostics& all, Diagnostic one) {
    const auto count = std::ranges::count(all, one.severity, &Diagnostic::severity);
    if (count > max_per_severity ||
        std::ranges::any_of(all, [&](const Diagnostic& known) { return are_same(known, one); }))
        return;
    if (count == max_per_severity) {
        one.line = 0;
        one.message = one.severity == Severity::error
                          ? fmt::format("more than {0} errors; only the first {0} are listed",
                                        max_per_severity)
                          : fmt::format("more than {0} warnings; only the first {0} are listed",
                                        max_per_severity);
    }
    all.push_back(std::move(one));
}

void add_new(Diagnostics& all, const Diagnostics& some) {
    for (const Diagnostic& diagnostic : some)
        add_new(all, diagnostic);
}
