#include "signals/kinds.h"

#include "signals/audio.h"
#include "signals/harmonics.h"
#include "signals/lissajous.h"
#include "signals/modulation.h"
#include "signals/settings.h"
#include "signals/waveform.h"

#include <algorithm>

const std::vector<SignalKind>& signal_kinds() {
    static const std::vector<SignalKind> kinds{lissajous_kind(), waveform_kind(), harmonics_kind(),
                                               am_kind(),        fm_kind(),       audio_kind()};
    return kinds;
}

const SignalKind* find_kind(std::string_view kind) {
    const auto& kinds = signal_kinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const SignalKind& known) { return known.kind == kind; });
    return found == kinds.end() ? nullptr : &*found;
}

const SettingFacts* find_setting(const SignalKind& kind, std::string_view key) {
    const auto found = std::find_if(kind.settings.begin(), kind.settings.end(),
                                    [&](const SettingFacts& known) { return known.key == key; });
    return found == kind.settings.end() ? nullptr : &*found;
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
