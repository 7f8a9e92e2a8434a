#include "model/spec.h"

#include "base/text.h"

namespace {
Spec::Setting setting_from(std::string_view text) {
    if (const auto number = parse_number(text))
        return *number;
    return std::string(text);
}

std::string to_string(const Spec::Setting& setting) {
    if (const double* number = std::get_if<double>(&setting))
        return format_number(*number);
    return std::get<std::string>(setting);
}
}  // namespace

Result<Spec> parse_spec(std::string_view text) {
    const std::size_t colon = text.find(':');
    Spec spec{std::string(trim(text.substr(0, colon))), {}};
    if (spec.kind.empty())
        return fail({{}, 0, "a signal starts with its kind, as in 'lissajous:x=3,y=2'"});
    if (colon == std::string_view::npos)
        return spec;
    bool first = true;
    for (const std::string_view piece : split(text.substr(colon + 1), ',')) {
        const std::size_t equals = piece.find('=');
        if (equals == std::string_view::npos && first)
            spec.settings[""] = std::string(piece);
        else if (equals == std::string_view::npos)
            return fail({{}, 0, "'" + std::string(piece) + "' is not of the form key=value"});
        else
            spec.settings[std::string(trim(piece.substr(0, equals)))] =
                setting_from(trim(piece.substr(equals + 1)));
        first = false;
    }
    return spec;
}

std::string to_string(const Spec& spec) {
    std::string text = spec.kind;
    char separator = ':';
    for (const auto& [key, setting] : spec.settings) {
        text += separator + (key.empty() ? "" : key + '=') + to_string(setting);
        separator = ',';
    }
    return text;
}
