#include "lab/offline/impulse.h"

#include "cli/common.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <iostream>
#include <sstream>

namespace {
constexpr std::array impulse_examples{
    "afterglow impulse phosphor",
    "afterglow impulse phosphor --preset radar-p7 --seconds 5",
    "afterglow impulse phosphor+crt --at 0.25,0.5 --json",
};

constexpr std::array channels{"red", "green", "blue"};

struct ImpulseArguments {
    LookOptions look{"640x360"};
    std::string pin = "0.5,0.5";
    double seconds = 2.0;
    bool as_json = false;
};

// Fractions of the picture's width and height.
Pin parse_position(const std::string& text) {
    std::istringstream words(text);
    Pin pin;
    char comma = 0;
    char rest = 0;
    const auto is_share = [](double number) { return number >= 0.0 && number <= 1.0; };
    if (!(words >> pin.x >> comma >> pin.y) || comma != ',' || words >> rest || !is_share(pin.x) ||
        !is_share(pin.y))
        throw UsageError(fmt::format("--at: expected X,Y from 0 to 1, got '{}'", text));
    return pin;
}

nlohmann::ordered_json json_of(const std::optional<double>& number) {
    return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

void print_json(const ImpulseResponse& response) {
    nlohmann::ordered_json passes = nlohmann::ordered_json::array();
    for (const PassImpulse& pass : response.passes)
        passes.push_back({{"name", pass.pass},
                          {"channel", channels[static_cast<std::size_t>(pass.channel)]},
                          {"peak", pass.decay.peak},
                          {"peak_seconds", pass.decay.peak_seconds},
                          {"seconds_to_10_percent", json_of(pass.decay.to_tenth)},
                          {"seconds_to_1_percent", json_of(pass.decay.to_hundredth)},
                          {"seconds_to_0.1_percent", json_of(pass.decay.to_thousandth)},
                          {"half_life_seconds", json_of(pass.decay.half_life)},
                          {"light", pass.light}});
    const nlohmann::ordered_json document{{"at", {response.request.pin.x, response.request.pin.y}},
                                          {"fps", response.request.fps},
                                          {"seconds", response.seconds},
                                          {"passes", std::move(passes)}};
    std::cout << document.dump(2) << '\n';
}

std::string milliseconds(const std::optional<double>& seconds) {
    return seconds ? fmt::format("{:.1f}", *seconds * 1000.0) : std::string("-");
}

void print_table(const ImpulseResponse& response) {
    std::cout << "Time in ms until the light falls to 10 %, 1 % and 0.1 % of its peak\n\n";
    std::cout << fmt::format("{:<24} {:>10} {:>8} {:>9} {:>9} {:>9} {:>9}\n", "Pass", "Peak",
                             "Channel", "10 %", "1 %", "0.1 %", "Half-life");
    for (const PassImpulse& pass : response.passes)
        std::cout << fmt::format(
            "{:<24} {:>10.4g} {:>8} {:>9} {:>9} {:>9} {:>9}\n", pass.pass, pass.decay.peak,
            channels[static_cast<std::size_t>(pass.channel)], milliseconds(pass.decay.to_tenth),
            milliseconds(pass.decay.to_hundredth), milliseconds(pass.decay.to_thousandth),
            milliseconds(pass.decay.half_life));
}

int impulse(const ImpulseArguments& arguments, const DataFolders& data) {
    const RenderRequest request = arguments.look.request();
    const ImpulseRequest impulse_request{parse_position(arguments.pin), request.fps,
                                         arguments.seconds};
    const auto work = [&](Offline& offline, const Library&) -> Result<void> {
        JobProgress progress;
        const auto response = fire_impulse(offline, request.size, impulse_request, progress);
        if (!response)
            return fail(response.error());
        arguments.as_json ? print_json(*response) : print_table(*response);
        return {};
    };
    return run_drawing(request, data, {{}, work});
}
}  // namespace

/// afterglow impulse LOOK [--at X,Y] [--seconds S] [--json]
Command add_impulse(CommandLine& program) {
    Options options = program.add_verb(
        "impulse", "Measure how a flash of light decays in every pass", impulse_examples);
    auto arguments = std::make_shared<ImpulseArguments>();
    arguments->look.add_to(options, LookOptions::Take::drawing);
    options
        .add("--at X,Y", arguments->pin,
             "Position from 0,0 (top left of the picture) to 1,1 (bottom right)")
        .show_default();
    options.add("--seconds S", arguments->seconds, "Time to measure in seconds")
        .show_default()
        .between(0.05, 60.0);
    options.add_flag("--json", arguments->as_json,
                     "Print one JSON document, with the light of each frame");
    return [arguments](const DataFolders& data) { return impulse(*arguments, data); };
}
