#include "signals/beam/beam_input_format.h"

#include "base/user_folders.h"
#include "signals/beam/beam_input.h"
#include "signals/signal/settings.h"

namespace {
class BeamInputSignal : public Signal {
public:
    explicit BeamInputSignal(std::shared_ptr<BeamInput> beam) : m_beam(std::move(beam)) {}

    void trace(const TimeSpan& span, Beam& beam) const override { m_beam->trace(span, beam); }

private:
    std::shared_ptr<BeamInput> m_beam;  // shared with the reading thread
};

Result<std::unique_ptr<Signal>> make_beam_input(const Settings&, const SignalMedia& media) {
    if (!media.sent)
        return fail({{}, 0, "can't receive a beam from another program here"});
    return std::make_unique<BeamInputSignal>(media.sent);
}

constexpr ChannelMap usual_map{.x = 1, .y = 2, .intensity = 3, .r = 4, .g = 5, .b = 6};

std::vector<SettingInfo> format_settings() {
    const SettingCondition is_raw{"format", {"f32le"}};
    std::vector<SettingInfo> settings{
        choice_setting("format", "Format",
                       "text: one point per line, x y intensity [seconds [red green blue]]. f32le: "
                       "raw little-endian 32-bit floats.",
                       {"text", "f32le"}),
        {.key = "rate",
         .label = "Rate",
         .unit = "points/s",
         .help = "Point rate of raw data, and of lines without seconds.",
         .low = 1000,
         .high = 245760,
         .step = 1,
         .initial = 245760,
         .logarithmic = true,
         .limit = {1, 1e6}},
        {.key = "channels",
         .label = "Channels",
         .help = "Numbers per point. 2: x and y at full intensity. 3: also intensity. 6: also red, "
                 "green and blue.",
         .low = 2,
         .high = 8,
         .step = 1,
         .initial = 2,
         .limit = {1, 64},
         .condition = is_raw}};
    for (SettingInfo& setting : channel_settings(usual_map, is_raw)) {
        setting.help += " A channel that points don't have counts as none.";
        settings.push_back(std::move(setting));
    }
    settings.push_back(fit_setting());
    return settings;
}
}  // namespace

BeamInputFormat beam_input_format(const Settings& settings) {
    return {.is_raw = settings.is("format", "f32le"),
            .channels = settings.whole("channels"),
            .map = channel_map(settings),
            .seconds = 1.0 / settings.number("rate")};
}

SignalKind stdin_kind() {
    return {.kind = "stdin",
            .label = "Standard input",
            .help = "Beam data from another program through a pipe.",
            .settings = format_settings(),
            .is_sent = true,
            .make = make_beam_input};
}

SignalKind socket_kind() {
    std::vector<SettingInfo> settings = format_settings();
    settings.insert(settings.begin(),
                    {.key = "path",
                     .label = "Socket",
                     .help = "Path that other programs connect to. Press Enter to open it.",
                     .type = SettingType::text,
                     .initial_word = (runtime_folder() / "afterglow.sock").string()});
    return {.kind = "socket",
            .label = "Unix socket",
            .help = "Beam data from other programs, one connection after the other.",
            .settings = std::move(settings),
            .bare_setting = "path",
            .is_sent = true,
            .make = make_beam_input};
}
