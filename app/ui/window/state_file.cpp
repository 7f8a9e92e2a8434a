#include "ui/window/state_file.h"

#include "base/text.h"
#include "gpu/objects/live_objects.h"
#include "lab/commands/preset_commands.h"
#include "lab/document/content_edits.h"
#include "lab/document/morphing.h"
#include "lab/document/opened_preset.h"
#include "lab/document/parameter_edits.h"
#include "lab/previews/previews.h"
#include "lab/reload/look_loader.h"
#include "lab/remote/remote_control.h"
#include "lab/window/preset_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <fstream>

namespace {
std::string json_string(std::string_view text) {
    std::string json = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            json += '\\';
        if (static_cast<unsigned char>(c) < 0x20)
            json += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            json += c;
    }
    return json + '"';
}

std::string values_text(const Document& document) {
    std::vector<std::string> values;
    for (const Parameter& parameter : document.look().parameters) {
        std::vector<std::string> numbers;
        for (const double number : document.value(parameter).numbers)
            numbers.push_back(format_number(number));
        values.push_back(
            fmt::format("{}:[{}]", json_string(parameter.name), fmt::join(numbers, ",")));
    }
    return fmt::format("{{{}}}", fmt::join(values, ","));
}

// The first component of each modulated parameter, as drawn.
std::string moving_text(const LabParts& lab) {
    std::vector<std::string> moving;
    for (const Parameter& parameter : lab.document->look().parameters)
        if (modulation_of(*lab.document, parameter) && lab.renderer)
            moving.push_back(fmt::format(
                "{}:{}", json_string(parameter.name),
                format_number(
                    value_of(parameter, lab.renderer->executor().graph().values()).number())));
    return fmt::format("{{{}}}", fmt::join(moving, ","));
}

std::string marked_text(const ParameterSettings& settings, bool ParameterSetting::*mark) {
    std::vector<std::string> names;
    for (const auto& [name, setting] : settings)
        if (setting.*mark)
            names.push_back(json_string(name));
    return fmt::format("[{}]", fmt::join(names, ","));
}

std::string problems_json(const Messages& messages) {
    std::vector<std::string> problems;
    for (const Problem& problem : messages.problems())
        problems.push_back(fmt::format(
            R"({{"file":{},"line":{},"message":{},"source":{}}})",
            json_string(problem.diagnostic.file.string()), problem.diagnostic.line,
            json_string(problem.diagnostic.message), json_string(problem.excerpt.line())));
    return fmt::format("[{}]", fmt::join(problems, ","));
}

std::string widget_rects_text(const Edits& edits) {
    std::vector<std::string> rects;
    for (const auto& [name, rect] : edits.widget_rects())
        rects.push_back(fmt::format("{}:[{:.0f},{:.0f},{:.0f},{:.0f}]", json_string(name),
                                    rect.left, rect.top, rect.right, rect.bottom));
    return fmt::format("{{{}}}", fmt::join(rects, ","));
}

const char* output_text(const OutputState& output) {
    if (!output.is_on())
        return "off";
    if (output.is_black)
        return "black";
    if (!output.is_open)
        return "camera";
    return output.is_overlay ? "overlay" : "on";
}

std::string probe_text(const Scene& scene) {
    const auto& probe = scene.window.probes.pointer;
    const auto& rgba = scene.views.probed();
    if (!probe || !rgba)
        return "null";
    return fmt::format(R"({{"pass":{},"x":{},"y":{},"rgba":["{}","{}","{}","{}"]}})",
                       json_string(probe->pass), probe->x, probe->y, (*rgba)[0], (*rgba)[1],
                       (*rgba)[2],
                       (*rgba)[3]);  // as text: it can be infinite or NaN
}

// The target, levels and statistics of the inspector.
std::string inspection_text(const Scene& scene) {
    const PassView& view = scene.window.views.inspected;
    const auto all = scene.views.inspector().statistics();
    const std::string measured =
        all ? fmt::format(R"({{"minimum":{},"maximum":{},"mean":{},"finite":{},"flaws":{}}})",
                          all->minimum, all->maximum, all->mean, all->finite,
                          all->not_a_number + all->infinite)
            : "null";
    return fmt::format(R"(,"looks_into":{},"levels":[{},{}],"measured":{})",
                       json_string(view.label()), view.levels.black, view.levels.white, measured);
}

// The number of displayed texel values, in picture, inspector and waveform.
std::string texels_text(const Scene& scene) {
    const TexelInspector& texels = scene.views.texels();
    const auto count = [](const TexelValues& cells) {
        return cells.block() ? cells.block()->numbers.size() : 0;
    };
    const ScanLine& line = scene.window.probes.scan_line;
    return fmt::format(
        R"(,"cells":[{},{}],"scan_line":[{:.3f},{:.3f},{:.3f},{:.3f}],"waveform":{})",
        count(texels.picture()), count(texels.inspected()), line.start.x, line.start.y, line.end.x,
        line.end.y, texels.waveform().numbers().size());
}

// The red value of each pin in every pass; null: still pending.
std::string pins_text(const Scene& scene) {
    std::vector<std::string> pins;
    const std::size_t passes =
        scene.lab.renderer ? scene.lab.renderer->executor().look().passes.size() : 0;
    for (std::size_t pin = 0; pin < scene.window.probes.pins.size(); ++pin) {
        std::vector<std::string> values;
        for (std::size_t pass = 0; pass < passes; ++pass) {
            const auto* value = scene.views.pins().value(pin, pass);
            values.push_back(value ? fmt::format(R"("{}")", (*value)[0]) : "null");
        }
        pins.push_back(fmt::format("[{}]", fmt::join(values, ",")));
    }
    return fmt::format(R"(,"pins":[{}])", fmt::join(pins, ","));
}

// The peak and clipped share of each pass; null: still pending.
std::string gains_text(const Scene& scene) {
    std::vector<std::string> gains;
    const std::size_t passes =
        scene.lab.renderer ? scene.lab.renderer->executor().look().passes.size() : 0;
    for (std::size_t pass = 0; pass < passes; ++pass) {
        const TargetLevel* gain = scene.views.strip().gain(pass);
        gains.push_back(gain ? fmt::format("[{},{}]", gain->peak, gain->clipped) : "null");
    }
    return fmt::format(R"(,"gains":[{}])", fmt::join(gains, ","));
}

// The mode, reference and results of the comparison.
std::string comparison_text(const Scene& scene) {
    static constexpr std::array modes{"off", "wipe", "side by side", "difference"};
    const LabParts& lab = scene.lab;
    std::vector<std::string> slots;
    for (std::size_t i = 0; i < lab.frames.comparison().slots().size(); ++i)
        slots.push_back(lab.frames.comparison().slots()[i]
                            ? fmt::format("{}", lab.frames.comparison().is_in_slot(i))
                            : "null");
    const auto& compared = scene.views.main().compared();
    const auto sides = lab.frames.comparison().sides();
    return fmt::format(
        R"(,"compare":{{"mode":{},"other":{},"is_flashing":{},"stops":{},"mean":{},"gain":{},"measure":{}}},"slots":[{}])",
        json_string(modes[static_cast<std::size_t>(lab.frames.comparison().mode())]),
        json_string(sides ? sides->other : std::string()),
        lab.frames.comparison().selection().is_reference_shown(),
        compared.stops() ? fmt::format("{:.4f}", *compared.stops()) : "null",
        compared.distances() ? fmt::format("\"{}\"", compared.distances()->mean) : "null",
        lab.frames.comparison().selection().chosen().gain_stops,
        static_cast<int>(lab.frames.comparison().selection().chosen().measure),
        fmt::join(slots, ","));
}

// The non-finite pixel that stopped the clock.
std::string non_finite_text(const NanGuard& guard) {
    const auto& trip = guard.found();
    return trip ? fmt::format(R"(,"trip":[{},{},{},{}])", trip->pass, trip->x, trip->y, trip->frame)
                : R"(,"trip":null)";
}

// The number of flashes, and whether the flash limiter is on.
std::string flashes_text(const Scene& scene) {
    const Flashes flashes = scene.views.main().flashes();
    const auto hdr = scene.window.hdr.drawn();
    return fmt::format(R"(,"flashes":[{},{}],"comfort":{},"hdr":[{},{}])", flashes.general,
                       flashes.red, scene.window.flashes.limit.is_on, hdr ? hdr->paper_white : 0.0,
                       hdr ? hdr->peak : 0.0);
}

std::string switches_text(const PassSwitches& switches) {
    std::vector<std::string> bypassed;
    for (const std::string& name : switches.bypassed)
        bypassed.push_back(json_string(name));
    std::vector<std::string> frozen;
    for (const std::string& name : switches.frozen)
        frozen.push_back(json_string(name));
    return fmt::format(R"(,"switches":{{"bypassed":[{}],"frozen":[{}],"solo":{},"last":{}}})",
                       fmt::join(bypassed, ","), fmt::join(frozen, ","), json_string(switches.solo),
                       json_string(switches.last));
}

// The effect of a step on each pass (null: still pending), and the progress of sheet and morph.
std::string tryouts_text(const Scene& scene) {
    const LabParts& lab = scene.lab;
    const StepProbe& probe = lab.frames.previews().probe();
    const VariantSheet& sheet = lab.frames.previews().sheet();
    std::vector<std::string> changes;
    for (const auto& change : probe.changes())
        changes.push_back(change ? fmt::format("\"{}\"", change_share(*change)) : "null");
    const auto current = lab.document ? sheet.current(*lab.document) : std::nullopt;
    return fmt::format(
        R"(,"pointed":{},"step":{{"words":{},"is_busy":{},"changes":[{}]}},"sheet":{{"cells":{},"drawn":{},"columns":{},"present":{}}},"morph":{})",
        json_string(scene.window.parameters.pointed ? scene.window.parameters.pointed->parameter
                                                    : std::string()),
        json_string(probe.text()), probe.is_busy(), fmt::join(changes, ","), sheet.cells().size(),
        sheet.drawn(), sheet.columns(), current ? fmt::format("{}", *current) : "null",
        lab.presets.navigation().morphing()
            ? fmt::format("{:.3f}", lab.presets.navigation().morphing()->share())
            : "null");
}

// The listed presets, the number with pictures, the errors and the filter.
std::string presets_text(const Scene& scene) {
    const LabParts& lab = scene.lab;
    if (!lab.document)
        return {};
    std::vector<std::string> names;
    std::vector<std::string> problems;
    int pictures = 0;
    for (const ListedPreset& preset :
         listed_presets(*lab.document, scene.library_view.looks(), lab.presets.navigation().stars(),
                        scene.window.presets)) {
        const auto shown = scene.pictures.presets.of(preset.preset.entry.file);
        names.push_back(json_string(preset.preset.entry.id));
        pictures += shown.image.handle != 0 ? 1 : 0;
        if (!shown.problem.empty())
            problems.push_back(json_string(shown.problem));
    }
    return fmt::format(
        R"(,"presets":{{"listed":[{}],"pictures":{},"drawn":{},"problems":[{}],"only_starred":{}}})",
        fmt::join(names, ","), pictures, scene.pictures.presets.drawn(), fmt::join(problems, ","),
        scene.window.presets.only_starred);
}

std::string gl_objects_text() {
    std::vector<std::string> counts;
    for (const auto& [kind, count] : gpu::live_objects())
        counts.push_back(fmt::format("{}:{}", json_string(kind), count));
    return fmt::format(R"(,"gl_objects":{{{}}})", fmt::join(counts, ","));
}

// Accepted and rejected messages, the last reason, and the mapped commands.
std::string remote_text(const RemoteControl& remote) {
    const RemoteLog& log = remote.log();
    std::vector<std::string> commands;
    for (const MidiCommand& command : remote.settings().midi_commands)
        commands.push_back(json_string(command.command));
    return fmt::format(
        R"({{"accepted":{},"rejected":{},"listed":{},"reason":{},"from_network":{},"learning":{},"commands":[{}]}})",
        log.accepted(), log.rejected(), log.messages().size(),
        json_string(log.messages().empty() ? std::string() : log.messages().front().reason),
        remote.osc().is_listening() && remote.osc().reach() == NetworkReach::local_network,
        json_string(remote.learning_name()), fmt::join(commands, ","));
}

// The typed text of the open dialog, and the highlighted row of the file dialog.
std::string dialog_text(const Scene& scene) {
    const Dialog& dialog = scene.window.dialog;
    const FileDialogKind* kind = file_dialog_kind(dialog.kind);
    if (!kind)
        return fmt::format(R"(,"typed":{},"highlighted":"")", json_string(dialog.text));
    return fmt::format(
        R"(,"typed":{},"highlighted":{})", json_string(dialog.browser.text),
        json_string(highlighted(dialog.browser, rules_of(*kind), scene.folders.rows())));
}

std::string undo_name(const LabParts& lab) {
    const std::string removal = lab.presets.undo_name();
    return removal.empty() ? lab.document->history().undo_name() : removal;
}

std::string document_text(const LabParts& lab) {
    const Document& document = *lab.document;
    return fmt::format(
        R"("look":{},"bypass":{},"preset":{},"is_modified":{},"undo":{},"redo":{},"signal":{},"driving_source":{},"is_content_locked":{},"values":{},"favourites":{},"locked":{},"moving":{},)",
        json_string(document.look().id),
        json_string(fmt::format("{}", fmt::join(bypassed_keys(document.look().stack), ","))),
        json_string(preset_name(document)), is_modified(document), json_string(undo_name(lab)),
        json_string(document.history().redo_name()),
        json_string(to_string(document.state().signal)), json_string(document.state().source),
        is_content_locked(document), values_text(document),
        marked_text(document.parameter_settings(), &ParameterSetting::is_favourite),
        marked_text(document.parameter_settings(), &ParameterSetting::is_locked), moving_text(lab));
}
}  // namespace

std::string state_text(const Scene& scene, const Edits& edits) {
    const LabParts& lab = scene.lab;
    const Transport& transport = lab.player.transport();
    const Extent picture = lab.size.extent();
    return fmt::format(
        R"({{{}"turn":{},"panel_ms":{:.3f},"is_behind":{},"is_loading":{},"opening":{},"reading":{},"is_playing":{},"has_picture":{},"frame":{},"samples":{},"osc":{},"remote":{},"midi":[{},{},{}],"has_converged":{},"time":{:.4f},"shown_share":{:.3f},"picture":[{},{}],"fixed_size":[{},{}],"notice":{},"dialog":{},"inspected":{},"channels":{},"wipe":{},"output":{},"probe":{},"problems":{},"widgets":{}}})",
        lab.document ? document_text(lab) : std::string(), scene.frame.number,
        scene.frame.panel_milliseconds, scene.frame.is_behind, lab.loader.is_loading(),
        json_string(lab.loader.opening() ? to_string(lab.loader.opening()->progress)
                                         : std::string()),
        json_string(lab.media.loading()), transport.is_playing(),
        lab.renderer && lab.renderer->has_drawn(), transport.frame_number(),
        lab.frames.samples().value_or(Samples{}).held, lab.remote.osc().port(),
        remote_text(lab.remote), lab.remote.midi().is_listening(),
        json_string(lab.remote.midi().learning() ? lab.remote.midi().learning()->parameter
                                                 : std::string()),
        lab.remote.settings().midi.size(), lab.frames.has_converged(), transport.time(),
        transport.shown_share(), picture.width, picture.height, lab.size.chosen().fixed.width,
        lab.size.chosen().fixed.height,
        json_string(lab.messages.notice() ? lab.messages.notice()->text : std::string()),
        static_cast<int>(scene.window.dialog.kind), json_string(scene.window.views.inspected.pass),
        static_cast<int>(scene.window.views.inspected.channels),
        lab.frames.comparison().mode() == CompareMode::wipe
            ? fmt::format("{:.3f}", scene.window.views.wipe_share)
            : "null",
        json_string(output_text(scene.window.output)),
        probe_text(scene) + inspection_text(scene) + texels_text(scene) + pins_text(scene) +
            gains_text(scene) + comparison_text(scene) + non_finite_text(lab.frames.nan_guard()) +
            flashes_text(scene) + switches_text(lab.frames.passes().switches()) +
            tryouts_text(scene) + presets_text(scene) + dialog_text(scene) + gl_objects_text(),
        problems_json(lab.messages), widget_rects_text(edits));
}

void write_state(const std::filesystem::path& file, const std::string& text) {
    const std::filesystem::path temporary = file.string() + ".new";
    std::ofstream(temporary, std::ios::binary) << text;
    std::error_code ignored;
    std::filesystem::rename(temporary, file, ignored);
}
