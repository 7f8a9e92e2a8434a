#include "signals/sent.h"

#include "base/user_folders.h"
#include "signals/sent_beam.h"
#include "signals/settings.h"

namespace {
class SentSignal : public Signal {
public:
    explicit SentSignal(std::shared_ptr<SentBeam> beam) : m_beam(std::move(beam)) {}

    void trace(const TimeSpan& span, Beam& beam) const override { m_beam->trace(span, beam); }

private:
    std::shared_ptr<SentBeam> m_beam;  // shared with the thread that reads
};

Result<std::unique_ptr<Signal>> make_sent(const Settings&, const SignalMedia& media) {
    if (!media.sent)
        return fail({{}, 0, "no other program can send a beam here"});
    return std::make_unique<SentSignal>(media.sent);
}

constexpr ChannelMap usual_map{.x = 1, .y = 2, .intensity = 3, .r = 4, .g = 5, .b = 6};

std::vector<SettingFacts> format_settings() {
    const UsedWhile is_raw{"format", {"f32le"}};
    std::vector<SettingFacts> settings{
        choice_setting("format", "Format",
                       "text: lines of x y intensity [seconds [red green blue]]. f32le: raw 32-bit "
                       "floats, little-endian.",
                       {"text", "f32le"}),
        {.key = "rate",
         .label = "Rate",
         .unit = "points/s",
         .help = "Of raw points, and of lines that say no seconds.",
         .low = 1000,
         .high = 245760,
         .step = 1,
         .initial = 245760,
         .logarithmic = true,
         .limit = {1, 1e6}},
        {.key = "channels",
         .label = "Channels",
         .help =
             "Numbers a point: 2: x and y, always lit; 3: the intensity as well; 6: its colour, "
             "too.",
         .low = 2,
         .high = 8,
         .step = 1,
         .initial = 2,
         .limit = {1, 64},
         .used_while = is_raw}};
    for (SettingFacts& setting : channel_settings(usual_map, is_raw)) {
        setting.help += " One that a point does not have is none.";
        settings.push_back(std::move(setting));
    }
    settings.push_back(fit_setting());
    return settings;
}
}  // namespace

SentFormat sent_format(const Settings& settings) {
    return {.is_raw = settings.is("format", "f32le"),
            .channels = settings.whole("channels"),
            .map = channel_map(settings),
            .seconds = 1.0 / settings.number("rate")};
}

SignalKind stdin_kind() {
    return {.kind = "stdin",
            .label = "Standard input",
            .help = "The beam as another program sends it through a pipe.",
            .settings = format_settings(),
            .is_sent = true,
            .make = make_sent};
}

SignalKind socket_kind() {
    std::vector<SettingFacts> settings = format_settings();
    settings.insert(settings.begin(),
                    {.key = "path",
                     .label = "Socket",
                     .help = "Where other programs find it; Enter opens it.",
                     .type = SettingType::text,
                     .initial_word = (runtime_folder() / "afterglow.sock").string()});
    return {.kind = "socket",
            .label = "Unix socket",
            .help = "The beam as another program sends it; one at a time, again and again.",
            .settings = std::move(settings),
            .bare_setting = "path",
            .is_sent = true,
            .make = make_sent};
}
