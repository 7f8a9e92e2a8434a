#include "lab/offline/output_precision.h"

#include "model/look/own_name.h"

#include <algorithm>

namespace {
bool is_few(Format format) {
    return format == Format::rgba8 || format == Format::rgb10_a2;
}

// Whether it dithers the picture, rather than what a stack's earlier look gives to the next.
bool is_dither(const Parameter& parameter, const Look& look) {
    const int last = static_cast<int>(look.passes.size()) - 1;
    return parameter.identity && own_name(parameter.name) == "dither" &&
           std::ranges::find(parameter.bindings, last, &Binding::pass) != parameter.bindings.end();
}
}  // namespace

bool has_few_bits(const Look& look) {
    return is_few(look.passes.back().format);
}

bool is_deep_film(const std::filesystem::path& file, const FilmChoice& choice) {
    const auto encoding = film_encoding(file, choice);
    return encoding && encoding->bits() > 8;
}

void raise_precision(Document& document) {
    const Look& look = document.look();
    const Pass& last = look.passes.back();
    document.amend([&](DocumentState& state) {
        const auto chosen = state.overrides.find(last.name);
        const bool is_chosen = chosen != state.overrides.end() && chosen->second.format;
        if (is_chosen && is_few(*chosen->second.format))
            return;
        if (has_few_bits(look) && !is_chosen)
            state.overrides[last.name].format = Format::rgba32f;
        for (const Parameter& parameter : look.parameters)
            if (is_dither(parameter, look))
                state.values[parameter.name] = *parameter.identity;
    });
}

Document with_precision_of(Document drawn, const Document& original) {
    drawn.amend([&](DocumentState& state) {
        state.overrides = original.state().overrides;
        for (const Parameter& parameter : original.look().parameters)
            if (is_dither(parameter, original.look())) {
                state.values.erase(parameter.name);
                if (const auto value = original.values().find(parameter.name);
                    value != original.values().end())
                    state.values.insert(*value);
            }
    });
    return drawn;
}
