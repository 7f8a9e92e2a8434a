#include "lab/offline/prepared_look.h"

#include "formats/look/describe.h"
#include "formats/preset/modulation_format.h"
#include "formats/preset/preset_format.h"
#include "formats/stack/stack_format.h"
#include "glsl/cache/check_cache.h"
#include "graph/programs/specialized_look.h"
#include "lab/document/automation_file.h"
#include "lab/document/content_edits.h"
#include "lab/document/naming.h"
#include "lab/document/opened_preset.h"
#include "lab/document/users_content.h"
#include "lab/library/cue_plans.h"
#include "lab/offline/output_precision.h"
#include "lab/playback/joined_sound.h"
#include "lab/storage/media.h"
#include "lab/storage/shader_cache.h"
#include "model/plan/plan_memory.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;

namespace {
Result<void> apply_values(const RenderRequest& request, Document& document) {
    Diagnostics problems;
    for (const auto& [name, text] : request.values) {
        const auto parameter = resolve_parameter(name, document.look());
        auto value = parameter ? parse_value(**parameter, text) : fail(parameter.error());
        if (value)
            document.set_value((*parameter)->name, std::move(*value));
        else
            problems.insert(problems.end(), value.error().begin(), value.error().end());
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return {};
}

// Whether a signal or a source picture can drive the look.
bool has_driver(const Look& look, Driver driver) {
    return look.driven_by == driver || look.has_other_driver;
}

Result<void> apply_drive(const RenderRequest& request, Document& document) {
    if (document.look().has_other_driver && !request.signal.empty() && !request.source.empty())
        return fail({{},
                     0,
                     fmt::format("a signal or a picture drives '{}', but not both. Use --signal or "
                                 "--source.",
                                 document.look().id)});
    if (!request.signal.empty()) {
        if (!has_driver(document.look(), Driver::signal))
            return fail({{}, 0, fmt::format("'{}' doesn't use a signal", document.look().id)});
        auto signal = parse_signal(request.signal);
        if (!signal)
            return fail(signal.error());
        set_signal(document, with_round_circles(std::move(*signal)));
    }
    if (!request.source.empty()) {
        if (!has_driver(document.look(), Driver::picture))
            return fail({{}, 0, fmt::format("'{}' doesn't use a picture", document.look().id)});
        set_source(document, with_users_defaults(request.source, document.look()));
    }
    return {};
}
}  // namespace

Result<void> apply_constants(Document& document, const LoadOptions& help) {
    const DocumentState& state = document.state();
    if (!document.has_pending_stack() &&
        constants_of(document.look(), state.values) == document.look().constants)
        return {};
    LoadedLook loaded =
        load_again(document.look(), state.stack, {help.cache, help.progress, &state.values});
    if (!loaded.look)
        return fail(std::move(loaded.look.error()));
    document.replace_look(std::move(*loaded.look));
    return {};
}

Diagnostics check_other_driver(const Look& look) {
    if (!look.has_other_driver)
        return {};
    const bool is_picture_driven = look.driven_by == Driver::picture;
    const LoadedLook other =
        load_again(look, with_picture_driven(look.stack, !is_picture_driven), {});
    return other.look ? Diagnostics{} : other.look.error();
}

Result<void> open_preset(OpenRequest request, const Library& library, PreparedLook& prepared) {
    Preset& preset = *request.preset;
    const fs::path& file = request.preset_file;
    const Look& look = prepared.document.look();
    if (preset.look != look.id)
        return fail(
            {file, 0, fmt::format("this preset is for '{}', not for '{}'", preset.look, look.id)});
    const auto odd = compare_with_look(preset, look, file);
    prepared.warnings.insert(prepared.warnings.end(), odd.begin(), odd.end());
    auto values = fitted_values(look, preset, file);
    if (!values)
        return fail(values.error());
    preset.values = std::move(*values);
    auto modulations = fitted_modulations(look, preset, file);
    if (!modulations)
        return fail(modulations.error());
    preset.modulations = std::move(*modulations);
    CheckedPreset checked =
        with_checked_media(preset, look, media_folder(file), RecentMedia(library.roots()));
    preset = std::move(checked.preset);
    prepared.outside = std::move(checked.outside);
    const auto notes = compare_with_media(preset);
    prepared.warnings.insert(prepared.warnings.end(), notes.begin(), notes.end());
    open_preset(prepared.document, preset, file);
    return {};
}

namespace {
// The request, including the preset to apply. The preset also sets the bypassed looks of a stack.
Result<OpenRequest> requested(const RenderRequest& request, const Library& library) {
    auto found = resolve(request.look, library);
    if (found && request.preset.empty() && !(request.signal.empty() && request.source.empty()))
        found->stack = with_driver(stack_of(*found), !request.source.empty());
    if (!found || request.preset.empty())
        return found;
    found->stack = stack_of(*found);
    std::vector<LookEntry> looks;  // they may be outside the library
    for (StackPart& part : found->stack) {
        if (part.look.empty())
            part.look = look_id_at(part.path);
        looks.push_back({part.look, part.path});
    }
    auto named = resolve_preset(request.preset, stack_id(found->stack), library.with(looks));
    if (!named)
        return named;
    found->preset = std::move(named->preset);
    found->preset_file = std::move(named->preset_file);
    found->stack = with_bypass(std::move(found->stack), found->preset->bypass);
    const bool has_picture = request.signal.empty() && !found->preset->source.empty();
    found->stack = with_driver(std::move(found->stack), has_picture || !request.source.empty());
    return found;
}
}  // namespace

namespace {
// Refuses outside content of a preset, unless options of the user replace it.
std::optional<Diagnostic> problem_with_outside(const PreparedLook& prepared,
                                               const RenderRequest& request,
                                               const fs::path& preset_file) {
    if (!prepared.outside)
        return std::nullopt;
    OutsideContent unnamed = *prepared.outside;
    if (!request.signal.empty() || !request.source.empty())
        unnamed = {.files = std::move(unnamed.files)};
    for (const auto& [name, text] : request.values)
        if (const auto parameter = resolve_parameter(name, prepared.document.look()))
            unnamed.files.erase((*parameter)->name);
    if (unnamed.count() == 0)
        return std::nullopt;
    return Diagnostic{preset_file, 0, unnamed.refusal()};
}
}  // namespace

namespace {
// The settings of the first sound are those of all.
Result<void> join_sounds(const RenderRequest& request, PreparedLook& prepared) {
    if (request.joined.empty())
        return {};
    std::vector<fs::path> files{file_of(prepared.document.state().signal)};
    for (const std::string& text : request.joined) {
        const auto signal = parse_signal(text);
        if (!signal)
            return fail(signal.error());
        if (signal->kind != "audio" || signal->settings.size() != 1)
            return fail({{},
                         0,
                         fmt::format("can't join '{}': expected audio:FILE. Give settings with the "
                                     "first sound only.",
                                     text)});
        files.emplace_back(file_of(*signal));
    }
    auto sound = load_joined_sound(files, &prepared.warnings);
    if (!sound)
        return fail(sound.error());
    prepared.joined = std::make_shared<const Sound>(std::move(*sound));
    return {};
}
}  // namespace

std::set<std::string> moving_parameters(const PreparedLook& prepared) {
    std::set<std::string> moving;
    for (const AutomationPoint& point : prepared.automation)
        moving.insert(point.name);
    for (const auto& [name, modulation] : prepared.document.state().modulations)
        moving.insert(name);
    for (const Parameter& parameter : prepared.document.look().parameters)
        if (prepared.cues.changes(parameter.name))
            moving.insert(parameter.name);
    return moving;
}

Result<PreparedLook> prepare(const RenderRequest& request, const Library& library) {
    auto preset = requested(request, library);
    if (!preset)
        return fail(preset.error());
    auto cache = shader_cache(library.roots());
    CheckCache checks(cache.get(), library.roots().shader_limits);
    LoadedLook loaded = load_requested(*preset, library, {&checks, request.progress});
    if (!loaded.look)
        return fail(std::move(loaded.look.error()));
    PreparedLook prepared{.document = Document(std::move(*loaded.look)),
                          .warnings = std::move(loaded.warnings),
                          .shader_cache = std::move(cache),
                          .progress = request.progress,
                          .sender_seconds = request.sender_seconds};
    const fs::path preset_file = preset->preset_file;
    if (preset->preset)
        if (auto done = open_preset(std::move(*preset), library, prepared); !done)
            return fail(done.error());
    if (auto problem = problem_with_outside(prepared, request, preset_file))
        return fail(std::move(*problem));
    if (auto done = apply_values(request, prepared.document); !done)
        return fail(done.error());
    if (auto done = apply_constants(prepared.document, {&checks, request.progress}); !done)
        return fail(done.error());
    if (auto done = apply_drive(request, prepared.document); !done)
        return fail(done.error());
    if (auto done = join_sounds(request, prepared); !done)
        return fail(done.error());
    if (request.bpm > 0.0)
        prepared.document.amend([&](DocumentState& state) { state.tempo.bpm = request.bpm; });
    if (!request.automation.empty()) {
        auto automation = load_automation(request.automation, prepared.document.look());
        if (!automation)
            return fail(automation.error());
        prepared.automation = std::move(*automation);
    }
    if (!request.cues.empty()) {
        auto cues = load_cue_plan(request.cues, prepared.document.look(), library);
        if (!cues)
            return fail(cues.error());
        prepared.cues = std::move(*cues);
    }
    if (request.raises_precision)
        raise_precision(prepared.document);
    prepared.draws_subframes = request.draws_subframes;
    prepared.start_frame = request.start_frame;
    prepared.hdr = request.hdr;
    return prepared;
}

Result<Plan> plan_of(const PreparedLook& prepared, Extent size) {
    return plan_targets(prepared.document.drawn_look(), size, size, prepared.document.values());
}

Result<void> check_memory(const PreparedLook& prepared, Extent size, std::uint64_t memory) {
    const auto plan = plan_of(prepared, size);
    if (!plan)
        return fail(plan.error());
    constexpr double gigabyte = 1e9;
    const std::uint64_t bytes = estimated_bytes(*plan, size);
    if (bytes <= memory / 4)
        return {};
    return fail(
        {{},
         0,
         fmt::format("'{}' at {}x{} needs about {:.1f} GB of memory, more than a quarter of the "
                     "{:.1f} GB of this machine. Choose a smaller --size.",
                     prepared.document.look().id, size.width, size.height,
                     static_cast<double>(bytes) / gigabyte,
                     static_cast<double>(memory) / gigabyte)});
}

Result<std::string> describe(const PreparedLook& prepared, Extent size) {
    const auto plan = plan_of(prepared, size);
    if (!plan)
        return fail(plan.error());
    const Document& document = prepared.document;
    return describe_json(document.drawn_look(), *plan, document.values(),
                         document.state().modulations);
}
