#include "lab/commands/remote_commands.h"

#include "lab/commands/preset_commands.h"
#include "lab/document/opened_preset.h"
#include "lab/frame/frame_loop.h"
#include "lab/remote/osc_parameters.h"
#include "lab/remote/remote_control.h"
#include "lab/window/window_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace {
template <class Part>
Part* part(const RemoteCall& call) {
    return std::get<Part*>(call.parts);
}

tl::unexpected<Diagnostics> reject(std::string reason) {
    return fail({{}, 0, std::move(reason)});
}

Result<OscMessages> done_or(const Result<void>& done) {
    if (!done)
        return fail(done.error());
    return OscMessages{};
}

/// Runs `change` when the button of the call is pressed.
template <class Part>
Result<OscMessages> on_press(const RemoteCall& call, void (*change)(Part&)) {
    const auto is_pressed = press_of(call.arguments);
    if (!is_pressed)
        return fail(is_pressed.error());
    if (*is_pressed)
        change(*part<Part>(call));
    return OscMessages{};
}

Result<OscMessages> open_preset(const RemoteCall& call) {
    constexpr double longest = 3600.0;  // s
    const OscArguments& arguments = call.arguments;
    const auto* name = arguments.empty() ? nullptr : std::get_if<std::string>(&arguments.front());
    if (!name || arguments.size() > 2)
        return reject("expected NAME and optional SECONDS");
    std::optional<double> seconds;
    if (arguments.size() == 2) {
        const auto number = number_at(arguments, 1, "SECONDS");
        if (!number)
            return fail(number.error());
        seconds = std::clamp(*number, 0.0, longest);
    }
    return done_or(part<PresetCommands>(call)->navigation().open_named(*name, seconds));
}

Result<OscMessages> press_preset(const RemoteCall& call) {
    const auto is_pressed = press_of(call.arguments);
    if (!is_pressed)
        return fail(is_pressed.error());
    if (!*is_pressed)
        return OscMessages{};
    return done_or(part<PresetCommands>(call)->navigation().open_named(call.name));
}

bool only_starred(const RemoteCall& call) {
    const auto* window = part<WindowState>(call);
    return window && window->presets.only_starred;
}

template <int by>
Result<OscMessages> step_preset(const RemoteCall& call) {
    const auto is_pressed = press_of(call.arguments);
    if (!is_pressed)
        return fail(is_pressed.error());
    if (*is_pressed)
        part<PresetCommands>(call)->navigation().step(by, only_starred(call));
    return OscMessages{};
}

Result<OscMessages> run_morph(const RemoteCall& call) {
    const auto is_pressed = press_of(call.arguments);
    if (!is_pressed)
        return fail(is_pressed.error());
    const auto* window = part<WindowState>(call);
    const double seconds = (window ? *window : WindowState()).presets.morph_seconds;
    if (*is_pressed)
        part<PresetCommands>(call)->navigation().morph_by(1, seconds, only_starred(call));
    return OscMessages{};
}

Result<OscMessages> run_play(const RemoteCall& call) {
    return on_press<Player>(call, [](Player& player) { player.play(); });
}

Result<OscMessages> run_pause(const RemoteCall& call) {
    return on_press<Player>(call, [](Player& player) { player.pause(); });
}

Result<OscMessages> run_restart(const RemoteCall& call) {
    return on_press<FrameLoop>(call, [](FrameLoop& frames) { frames.restart(); });
}

Result<OscMessages> run_seek(const RemoteCall& call) {
    constexpr double longest = 24 * 3600.0;  // s
    const auto seconds = number_at(call.arguments, 0, "SECONDS");
    if (!seconds || call.arguments.size() > 1)
        return reject("expected SECONDS");
    if (*seconds < 0.0 || *seconds > longest)
        return reject("SECONDS must be from 0 to 86400");
    part<Player>(call)->seek(*seconds);
    return OscMessages{};
}

Result<OscMessages> black_out(const RemoteCall& call) {
    if (call.arguments.size() != 1)
        return reject("expected 1 (black) or 0 (picture)");
    const auto is_black = press_of(call.arguments);
    if (!is_black)
        return fail(is_black.error());
    auto* window = part<WindowState>(call);
    if (!window || !window->output.is_on())
        return reject(
            "the output window and the virtual camera are off. Send "
            "/afterglow/command/action/output_window or /afterglow/command/action/virtual_camera "
            "first.");
    window->output.is_black = *is_black;
    return OscMessages{};
}

template <bool stores>
Result<OscMessages> use_slot(const RemoteCall& call) {
    constexpr std::array<std::string_view, 3> letters{"a", "b", "c"};
    const auto letter = std::ranges::find(letters, call.name);
    if (letter == letters.end())
        return reject(fmt::format("the slots are a, b and c, got '{}'", call.name));
    const auto is_pressed = press_of(call.arguments);
    if (!is_pressed)
        return fail(is_pressed.error());
    if (!*is_pressed)
        return OscMessages{};
    if (!part<Document>(call))
        return reject("no look is open");
    auto& comparison = *part<ComparisonView>(call);
    const auto slot = static_cast<std::size_t>(letter - letters.begin());
    if (!stores && !comparison.slots()[slot])
        return reject(fmt::format("slot {} is empty", slot_name(slot)));
    stores ? comparison.store(slot) : comparison.recall(slot);
    return OscMessages{};
}

// The window runs it, because its actions are in a higher layer.
Result<OscMessages> run_action(const RemoteCall& call) {
    const auto is_pressed = press_of(call.arguments);
    if (!is_pressed)
        return fail(is_pressed.error());
    if (!part<WindowState>(call))
        return reject("actions need the window");
    part<RemoteControl>(call)->request_action({call.name, *is_pressed});
    return OscMessages{};
}

Result<OscMessages> reply(const RemoteCall& call, OscMessage::Argument value) {
    return OscMessages{{call.address, {std::move(value)}}};
}

Result<OscMessages> reply_look(const RemoteCall& call) {
    const auto* document = part<Document>(call);
    return reply(call, document ? document->look().id : std::string());
}

Result<OscMessages> reply_preset(const RemoteCall& call) {
    const auto* document = part<Document>(call);
    return reply(call, document ? preset_name(*document) : std::string());
}

Result<OscMessages> reply_presets(const RemoteCall& call) {
    OscMessages replies;
    for (std::string& name : part<PresetCommands>(call)->navigation().names())
        replies.push_back({call.address, {std::move(name)}});
    return replies;
}

Result<OscMessages> reply_parameters(const RemoteCall& call) {
    OscMessages replies;
    if (const auto* document = part<Document>(call))
        for (const Parameter& parameter : document->look().parameters)
            replies.push_back({fmt::format("{}parameter/{}", osc_prefix, parameter.name),
                               arguments_of(document->value(parameter))});
    return replies;
}

Result<OscMessages> reply_playing(const RemoteCall& call) {
    return reply(call, part<Player>(call)->transport().is_playing() ? 1.0 : 0.0);
}

Result<OscMessages> reply_time(const RemoteCall& call) {
    return reply(call, part<Player>(call)->transport().time());
}

Result<OscMessages> reply_blackout(const RemoteCall& call) {
    const auto* window = part<WindowState>(call);
    return reply(call, window && window->output.is_on() && window->output.is_black ? 1.0 : 0.0);
}

constexpr const char* press_argument = "[1 or 0]";

constexpr std::array command_rows{
    RemoteCommand{"command/preset", "NAME [SECONDS]",
                  "open a preset of the open look, or morph to it in SECONDS", open_preset},
    RemoteCommand{"command/preset/NAME", press_argument, "open a preset", press_preset},
    RemoteCommand{"command/next", press_argument, "open the next preset", step_preset<1>},
    RemoteCommand{"command/previous", press_argument, "open the previous preset", step_preset<-1>},
    RemoteCommand{"command/morph", press_argument,
                  "morph to the next preset, in the time set in the preset browser", run_morph},
    RemoteCommand{"command/play", press_argument, "play", run_play},
    RemoteCommand{"command/pause", press_argument, "pause", run_pause},
    RemoteCommand{"command/seek", "SECONDS", "go to a time", run_seek},
    RemoteCommand{"command/restart", press_argument, "start again at time 0 without history",
                  run_restart},
    RemoteCommand{
        "command/blackout", "1 or 0",
        "black out the output window and the virtual camera, or show the picture again. Both "
        "are immediate",
        black_out},
    RemoteCommand{"command/slot/NAME/recall", press_argument, "recall slot a, b or c",
                  use_slot<false>},
    RemoteCommand{"command/slot/NAME/store", press_argument, "store the values in slot a, b or c",
                  use_slot<true>},
    RemoteCommand{"command/action/NAME", press_argument,
                  "run an action of the menus and the palette", run_action},
    RemoteCommand{"query/look", "", "reply with the name of the open look", reply_look},
    RemoteCommand{"query/preset", "", "reply with the name of the open preset", reply_preset},
    RemoteCommand{"query/presets", "", "reply with one message per preset of the open look",
                  reply_presets},
    RemoteCommand{"query/parameters", "", "reply with one message per parameter", reply_parameters},
    RemoteCommand{"query/playing", "", "reply with 1 while playing, otherwise 0", reply_playing},
    RemoteCommand{"query/time", "", "reply with the time in seconds", reply_time},
    RemoteCommand{"query/blackout", "", "reply with 1 while the output is blacked out",
                  reply_blackout},
};
}  // namespace

std::span<const RemoteCommand> remote_commands() {
    return command_rows;
}
