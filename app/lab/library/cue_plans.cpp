#include "lab/library/cue_plans.h"

#include "base/file.h"
#include "formats/preset/modulation_format.h"
#include "formats/preset/preset_format.h"
#include "lab/document/naming.h"
#include "lab/library/open.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace {
// The goals of all parameters that a cue can change: the preset's values and otherwise defaults.
Result<CueAction> preset_action(const Cue& cue, const Look& look,
                                const Result<OpenRequest>& request) {
    if (!request)
        return fail(request.error());
    const Preset& preset = *request->preset;
    if (preset.look != look.id)
        return fail({{},
                     0,
                     fmt::format("'{}' is a preset for '{}', not for '{}'", cue.name, preset.look,
                                 look.id)});
    if (look.has_other_driver && preset.source.empty() == (look.driven_by == Driver::picture))
        return fail({{},
                     0,
                     fmt::format("'{}' is for a {}, but a {} drives the look. A cue can't change "
                                 "that.",
                                 cue.name, preset.source.empty() ? "signal" : "source picture",
                                 preset.source.empty() ? "source picture" : "signal")});
    const auto values = fitted_values(look, preset, request->preset_file);
    if (!values)
        return fail(values.error());
    const auto modulations = fitted_modulations(look, preset, request->preset_file);
    if (!modulations)
        return fail(modulations.error());
    CueAction action{.seconds = cue.seconds, .over = cue.over, .modulations = *modulations};
    for (const Parameter& parameter : look.parameters)
        if (cue_refusal(parameter).empty())
            action.values[parameter.name] = clamped(parameter, value_of(parameter, *values));
    return action;
}

Result<CueAction> parameter_action(const Cue& cue, const Look& look) {
    const auto parameter = resolve_parameter(cue.name, look);
    if (!parameter)
        return fail(parameter.error());
    if (std::string reason = cue_refusal(**parameter); !reason.empty())
        return fail({{}, 0, std::move(reason)});
    auto value = parse_value(**parameter, cue.value);
    if (!value)
        return fail(value.error());
    return CueAction{.seconds = cue.seconds,
                     .over = cue.over,
                     .values = {{(*parameter)->name, clamped(**parameter, std::move(*value))}}};
}

/// The presets of the cues. Each is read once.
class CuePresets {
public:
    CuePresets(const Look& look, const Library& library) : m_look(look), m_library(library) {}

    const Result<OpenRequest>& find(const std::string& name) {
        const auto found = m_presets.find(name);
        return found != m_presets.end()
                   ? found->second
                   : m_presets.emplace(name, resolve_preset(name, m_look.id, m_library))
                         .first->second;
    }
    std::vector<std::filesystem::path> files() const {
        std::vector<std::filesystem::path> files;
        for (const auto& [name, request] : m_presets)
            if (request)
                files.push_back(request->preset_file);
        return files;
    }

private:
    const Look& m_look;
    const Library& m_library;
    std::map<std::string, Result<OpenRequest>> m_presets;
};

Result<CueAction> action_of(const Cue& cue, const Look& look, CuePresets& presets) {
    switch (cue.command) {
        case Cue::Command::preset:
            return preset_action(cue, look, presets.find(cue.name));
        case Cue::Command::parameter:
            return parameter_action(cue, look);
        case Cue::Command::restart:
            return CueAction{.seconds = cue.seconds, .kind = CueAction::Kind::restart};
        case Cue::Command::blackout:
            break;
    }
    return CueAction{.seconds = cue.seconds, .kind = CueAction::Kind::blackout, .is_on = cue.is_on};
}
}  // namespace

Result<CuePlan> plan_cues(const CueSheet& sheet, const std::filesystem::path& file,
                          const Look& look, const Library& library,
                          std::vector<std::filesystem::path>& presets) {
    CuePresets read(look, library);
    std::vector<CueAction> actions;
    Diagnostics problems;
    int number = 0;
    for (const CueLine& line : sheet.lines()) {
        ++number;
        if (!line.cue)
            continue;
        auto action = action_of(*line.cue, look, read);
        if (action)
            actions.push_back(std::move(*action));
        else
            for (const Diagnostic& problem : action.error())  // of the cue, or of its preset's file
                problems.push_back(
                    {file, number, problem.file.empty() ? problem.message : to_string(problem)});
    }
    presets = read.files();
    if (!problems.empty())
        return fail(std::move(problems));
    return CuePlan(std::move(actions));
}

Result<CuePlan> load_cue_plan(const std::filesystem::path& file, const Look& look,
                              const Library& library) {
    const auto text = read_text(file);
    if (!text)
        return fail(text.error());
    const auto sheet = parse_cue_sheet(*text, file);
    std::vector<std::filesystem::path> presets;
    return sheet ? plan_cues(*sheet, file, look, library, presets) : fail(sheet.error());
}

Result<void> check_cue(const Cue& cue, const Look& look, const Library& library) {
    CuePresets read(look, library);
    const auto action = action_of(cue, look, read);
    return action ? Result<void>{} : fail(action.error());
}
