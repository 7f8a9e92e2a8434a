#include "lab/impulse.h"

#include "cli/common.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <iostream>
#include <sstream>

namespace {
constexpr std::array channels{"red", "green", "blue"};

struct ImpulseArguments {
    LookOptions look{"640x360"};
    std::string place = "0.5,0.5";
    double seconds = 2.0;
    bool as_json = false;
};

// Two shares of the picture's width and height.
Pin parse_place(const std::string& text) {
    std::istringstream words(text);
    Pin place;
    char comma = 0;
    char rest = 0;
    const auto is_share = [](double number) { return number >= 0.0 && number <= 1.0; };
    if (!(words >> place.x >> comma >> place.y) || comma != ',' || words >> rest ||
        !is_share(place.x) || !is_share(place.y))
        throw UsageError("--at takes two numbers from 0 to 1, such as 0.5,0.25; '" + text +
                         "' is none");
    return place;
}

nlohmann::ordered_json json_of(const std::optional<double>& number) {
    return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

void print_json(const ImpulseResponse& response) {
    nlohmann::ordered_json passes = nlohmann::ordered_json::array();
    for (const PassImpulse& pass : response.passes)
        passes.push_back({{"name", pass.pass},
                          {"channel", channels[static_cast<std::size_t>(pass.channel)]},
                          {"peak", pass.fall.peak},
                          {"peak_seconds", pass.fall.peak_seconds},
                          {"seconds_to_10_percent", json_of(pass.fall.to_tenth)},
                          {"seconds_to_1_percent", json_of(pass.fall.to_hundredth)},
                          {"seconds_to_0.1_percent", json_of(pass.fall.to_thousandth)},
                          {"half_life_seconds", json_of(pass.fall.half_life)},
                          {"light", pass.light}});
    const nlohmann::ordered_json document{
        {"at", {response.question.place.x, response.question.place.y}},
        {"fps", response.question.fps},
        {"seconds", response.seconds},
        {"passes", std::move(passes)}};
    std::cout << document.dump(2) << '\n';
}

std::string milliseconds(const std::optional<double>& seconds) {
    return seconds ? fmt::format("{:.1f}", *seconds * 1000.0) : std::string("-");
}

void print_table(const ImpulseResponse& response) {
    std::cout << fmt::format("{:<20} {:>10} {:>8} {:>9} {:>9} {:>9} {:>9}\n", "pass", "peak",
                             "channel", "10 % ms", "1 % ms", "0.1 % ms", "half ms");
    for (const PassImpulse& pass : response.passes)
        std::cout << fmt::format(
            "{:<20} {:>10.4g} {:>8} {:>9} {:>9} {:>9} {:>9}\n", pass.pass, pass.fall.peak,
            channels[static_cast<std::size_t>(pass.channel)], milliseconds(pass.fall.to_tenth),
            milliseconds(pass.fall.to_hundredth), milliseconds(pass.fall.to_thousandth),
            milliseconds(pass.fall.half_life));
}

int impulse(const ImpulseArguments& arguments, const DataFolders& data) {
    const RenderRequest request = arguments.look.request();
    const ImpulseQuestion question{parse_place(arguments.place), request.fps, arguments.seconds};
    const auto work = [&](Offline& offline, const Library&) -> Result<void> {
        Work progress;
        const auto response = fire_impulse(offline, request.size, question, progress);
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
    Options options =
        program.add_verb("impulse", "Fire one flash and tell how it falls in every pass");
    auto arguments = std::make_shared<ImpulseArguments>();
    arguments->look.add_to(options, LookOptions::Take::drawing);
    options
        .add("--at", arguments->place,
             "Where, as shares of the picture's width and height from its top left corner")
        .show_default();
    options.add("--seconds", arguments->seconds, "How long it is watched")
        .show_default()
        .between(0.05, 60.0);
    options.add_flag("--json", arguments->as_json,
                     "One JSON document, with the light of each frame");
    return [arguments](const DataFolders& data) { return impulse(*arguments, data); };
}
