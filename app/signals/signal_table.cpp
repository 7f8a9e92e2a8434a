#include "signals/signal_table.h"

#include "signals/audio/audio.h"
#include "signals/beam/beam_input_format.h"
#include "signals/drawing/path_signals.h"
#include "signals/drawing/stroke_font.h"
#include "signals/generators/harmonics.h"
#include "signals/generators/lissajous.h"
#include "signals/generators/modulation.h"
#include "signals/generators/waveform.h"
#include "signals/signal/settings.h"

#include <fmt/format.h>

#include <algorithm>

const std::vector<SignalKind>& signal_kinds() {
    static const std::vector<SignalKind> kinds{lissajous_kind(),  waveform_kind(), harmonics_kind(),
                                               am_kind(),         fm_kind(),       audio_kind(),
                                               microphone_kind(), scene_kind(),    text_kind(),
                                               drawing_kind(),    stdin_kind(),    socket_kind()};
    return kinds;
}

const SignalKind* find_kind(std::string_view kind) {
    const auto& kinds = signal_kinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const SignalKind& known) { return known.kind == kind; });
    return found == kinds.end() ? nullptr : &*found;
}

Result<Spec> parse_signal(std::string_view text) {
    return parse_spec(text, [](std::string_view kind_name, std::string_view key) {
        const SignalKind* kind = find_kind(kind_name);
        return !kind || kind->bare_setting.empty() || find_setting(*kind, key) != nullptr;
    });
}

Diagnostics notes_about(const Spec& spec) {
    const auto complete = spec.kind == "text" ? completed(spec) : fail({{}, 0, ""});
    const std::string missing =
        complete ? missing_letters(Settings(*complete).word("text")) : std::string();
    if (missing.empty())
        return {};
    return {{{},
             0,
             fmt::format("text: characters missing from the font are drawn as boxes: {}", missing),
             Severity::warning}};
}

std::string file_of(const Spec& spec) {
    const SignalKind* kind = find_kind(spec.kind);
    if (!kind || kind->file_setting.empty())
        return {};
    const auto complete = completed(spec);
    return complete ? std::string(Settings(*complete).word(kind->file_setting)) : std::string();
}

Result<std::unique_ptr<Signal>> make_signal(const Spec& spec, const SignalMedia& media) {
    const auto complete = completed(spec);
    if (!complete)
        return fail(complete.error());
    return find_kind(complete->kind)->make(Settings(*complete), media);
}
