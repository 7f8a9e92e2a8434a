#include "base/text.h"
#include "cli/common.h"
#include "io/files/atomic_file.h"
#include "io/system/standard_streams.h"
#include "lab/document/sharing.h"
#include "lab/match/decay_match.h"
#include "lab/match/match_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <iostream>

namespace fs = std::filesystem;

namespace {
constexpr std::array match_examples{
    "afterglow match shadow-mask --photo set.png --source bars.png -o set.json",
    "afterglow match phosphor --video fade.mp4 --fps 240 -o tube.json",
};

struct MatchArguments {
    LookOptions look{""};
    std::string photo;
    std::string corners;
    std::string video;
    std::string place;
    double fps = 0.0;
    double gamma = 2.2;
    std::string locked;
    std::string fitted;
    std::string output;
    std::string name;
    std::string report;
    bool as_json = false;
};

std::vector<std::string> names_in(const std::string& text) {
    std::vector<std::string> names;
    if (!text.empty())
        for (const std::string_view name : split(text, ','))
            names.emplace_back(trim(name));
    return names;
}

std::optional<Corners> parse_corners(const std::string& text) {
    if (text.empty())
        return std::nullopt;
    const auto parts = split(text, ',');
    Corners corners;
    bool is_good = parts.size() == 8;
    for (std::size_t i = 0; is_good && i < parts.size(); ++i) {
        const auto number = parse_number(trim(parts[i]));
        is_good = number.has_value();
        corners[i / 2][static_cast<glm::length_t>(i % 2)] = number.value_or(0.0);
    }
    if (!is_good)
        throw UsageError(
            fmt::format("--corners: expected 8 numbers X,Y,X,Y,X,Y,X,Y, got '{}'", text));
    return corners;
}

// The stage, on one line of stderr.
class StageLine {
public:
    ~StageLine() {
        if (m_is_shown)
            std::cerr << "\r\033[K";
    }
    void show(const MatchProgress& progress) {
        if (!is_terminal(standard_error))
            return;
        m_is_shown = true;
        std::cerr << fmt::format("\rMatching: {}, difference {:.2f} %\033[K", progress.stage,
                                 100.0 * progress.residual);
    }

private:
    bool m_is_shown = false;
};

std::string interval(double low, double high, const std::string& why_not) {
    return fmt::format("{:.4g} to {:.4g}{}", low, high,
                       why_not.empty() ? std::string() : ", not identifiable: " + why_not);
}

void print_table(const MatchedFile& matched) {
    const Look& look = matched.document.look();
    const MatchJobResult& result = matched.result;
    std::cout << fmt::format("Render size {} x {}, {} pictures drawn, difference {:.2f} %\n\n",
                             result.size.width, result.size.height, result.matched.pictures,
                             100.0 * result.matched.residual);
    for (const auto& [parameter, label] : result.types)
        std::cout << fmt::format("{:<24} {}\n", parameter, label);
    std::cout << fmt::format("{:<24} {:>10}   90 % interval\n", "Parameter", "Value");
    for (const FoundNumber& number : result.matched.numbers)
        std::cout << fmt::format("{:<24} {:>10.4g}   {}\n", found_label(number, look), number.value,
                                 interval(number.low, number.high, number.why_not));
    std::cout << '\n' << explained_text(result.matched) << '\n';
}

nlohmann::ordered_json numbers_json(const std::vector<FoundNumber>& numbers) {
    using Json = nlohmann::ordered_json;
    Json parameters = Json::array();
    for (const FoundNumber& number : numbers) {
        Json row{{"name", number.parameter}, {"component", number.component},
                 {"value", number.value},    {"low", number.low},
                 {"high", number.high},      {"identifiable", number.why_not.empty()}};
        if (!number.why_not.empty())
            row["reason"] = number.why_not;
        parameters.push_back(std::move(row));
    }
    return parameters;
}

void print_json(const MatchJobResult& result) {
    using Json = nlohmann::ordered_json;
    Json types = Json::object();
    for (const auto& [parameter, label] : result.types)
        types[parameter] = label;
    const Json document{{"size", {result.size.width, result.size.height}},
                        {"pictures", result.matched.pictures},
                        {"residual", result.matched.residual},
                        {"explained", result.matched.explained},
                        {"types", std::move(types)},
                        {"parameters", numbers_json(result.matched.numbers)},
                        {"camera", Json::parse(camera_json(result))}};
    std::cout << document.dump(2) << '\n';
}

// The preset, and the camera next to it.
Result<void> save(const MatchedFile& matched, const MatchArguments& arguments,
                  const Library& library) {
    if (!arguments.report.empty())
        if (auto written = write_match_report(matched, arguments.photo, arguments.report); !written)
            return written;
    if (arguments.output.empty())
        return {};
    if (auto saved = write_preset(matched.document, arguments.name, arguments.output,
                                  RecentMedia(library.roots()));
        !saved)
        return saved;
    return write_atomically(fs::path(arguments.output).replace_extension(".camera.json"),
                            camera_json(matched.result));
}

std::optional<glm::dvec2> parse_place(const std::string& text) {
    if (text.empty())
        return std::nullopt;
    const auto parts = split(text, ',');
    const auto x = parse_number(trim(parts.front()));
    const auto y = parse_number(trim(parts.back()));
    if (parts.size() != 2 || !x || !y)
        throw UsageError(fmt::format("--at: expected X,Y in px, got '{}'", text));
    return glm::dvec2(*x, *y);
}

void print_table(const DecayMatch& match) {
    std::cout << fmt::format(
        "{:g} frames per second, place {:.0f},{:.0f}, light on for {} frames, then {} frames\n\n",
        match.fps, match.at.x, match.at.y, match.lit_frames, match.frames);
    if (!match.tube.empty())
        std::cout << fmt::format("{:<24} {}\n", match.tube_parameter, match.tube);
    std::cout << fmt::format("{:<24} {:>10}   90 % interval\n", "Parameter", "Value");
    for (const FoundNumber& number : match.numbers)
        std::cout << fmt::format("{:<24} {:>10.4g}   {}\n", number.parameter, number.value,
                                 interval(number.low, number.high, number.why_not));
    for (const TimeConstant& constant : match.constants)
        std::cout << fmt::format(
            "{:<24} {:>10.4g}   {}\n", "Time constant, ms", 1000.0 * constant.seconds,
            interval(1000.0 * constant.low, 1000.0 * constant.high, constant.why_not));
    if (!match.tubes.empty())
        std::cout << "\nProbability of the measured tubes\n";
    for (const TubeProbability& tube : match.tubes)
        std::cout << fmt::format("{:<24} {:>9.1f} %\n", tube.label, 100.0 * tube.probability);
    if (const std::string text = misfit_text(match); !text.empty())
        std::cout << '\n' << text << '\n';
}

void print_json(const DecayMatch& match) {
    using Json = nlohmann::ordered_json;
    Json constants = Json::array();
    for (const TimeConstant& constant : match.constants) {
        Json row{{"seconds", constant.seconds},
                 {"low", constant.low},
                 {"high", constant.high},
                 {"share", constant.share},
                 {"identifiable", constant.why_not.empty()}};
        if (!constant.why_not.empty())
            row["reason"] = constant.why_not;
        constants.push_back(std::move(row));
    }
    Json tubes = Json::array();
    for (const TubeProbability& tube : match.tubes)
        tubes.push_back({{"tube", tube.label}, {"probability", tube.probability}});
    const Json document{
        {"fps", match.fps},
        {"at", {match.at.x, match.at.y}},
        {"lit_frames", match.lit_frames},
        {"frames", match.frames},
        {"misfit", match.misfit},
        {"types", match.tube.empty() ? Json::object() : Json{{match.tube_parameter, match.tube}}},
        {"tubes", std::move(tubes)},
        {"parameters", numbers_json(match.numbers)},
        {"time_constants", std::move(constants)}};
    std::cout << document.dump(2) << '\n';
}

int match_video(const MatchArguments& arguments, const Library& library) {
    if (!arguments.report.empty())
        throw UsageError("--report needs --photo");
    JobProgress work;
    const auto matched = match_decay_file(
        arguments.look.request(),
        {arguments.video, parse_place(arguments.place),
         arguments.fps > 0.0 ? std::optional(arguments.fps) : std::nullopt, arguments.gamma},
        {names_in(arguments.locked), names_in(arguments.fitted)}, library, work);
    if (!matched)
        return report(matched.error());
    warn(matched->warnings);
    if (!arguments.output.empty())
        if (auto saved = write_preset(matched->document, arguments.name, arguments.output,
                                      RecentMedia(library.roots()));
            !saved)
            return report(saved.error());
    arguments.as_json ? print_json(matched->match) : print_table(matched->match);
    return exit_done;
}

int match(const MatchArguments& arguments, const DataFolders& data) {
    if (arguments.photo.empty() == arguments.video.empty())
        throw UsageError("Give --photo FILE or --video FILE");
    if (arguments.output.empty() && arguments.report.empty() && !arguments.as_json)
        throw UsageError("--output FILE, --report FILE or --json is required");
    if (!arguments.output.empty())
        check_ending("--output", arguments.output, {".json"});
    if (!arguments.report.empty())
        check_ending("--report", arguments.report, {".html"});
    const auto library = open_library(data);
    if (!library)
        return report(library.error());
    if (!arguments.video.empty())
        return match_video(arguments, *library);
    JobProgress work;
    StageLine line;
    const auto matched =
        match_file({.render = arguments.look.request(),
                    .photo = arguments.photo,
                    .corners = parse_corners(arguments.corners),
                    .choice = {names_in(arguments.locked), names_in(arguments.fitted)},
                    .gamma = arguments.gamma,
                    .on_progress = [&](const MatchProgress& progress) { line.show(progress); }},
                   *library, work);
    if (!matched)
        return report(matched.error());
    warn(matched->warnings);
    if (auto saved = save(*matched, arguments, *library); !saved)
        return report(saved.error());
    arguments.as_json ? print_json(matched->result) : print_table(*matched);
    return exit_done;
}
}  // namespace

/// afterglow match LOOK --photo PHOTO --source PICTURE [--corners …] -o PRESET.json
/// afterglow match LOOK --video VIDEO [--at X,Y] [--fps N] -o PRESET.json
Command add_match(CommandLine& program) {
    Options options = program.add_verb(
        "match",
        "Find the values of a look in a photo or video of a real tube\n\nThe photo must be sharp, "
        "not overexposed, and show one known picture. A triad of mask stripes must be at least "
        "3 px wide. For a look with a beam, it must show a straight line or an isolated dot. The "
        "video must show light that goes off.",
        match_examples);
    auto arguments = std::make_shared<MatchArguments>();
    arguments->look.add_to(options, LookOptions::Take::values);
    options.add("--photo FILE", arguments->photo, "Photo of the tube");
    options.add("--corners X,Y,...", arguments->corners,
                "The screen's corners in px of the photo, clockwise from the top left (default: "
                "its straight edges, else the photo)");
    options.add("--video FILE", arguments->video,
                "Video of light that goes off, with locked exposure, or numbered pictures as "
                "frame_%04d.png. Finds the tube's phosphor");
    options.add("--at X,Y", arguments->place,
                "Place in the video, px from the top left (default: where the light changes most)");
    options
        .add("--fps N", arguments->fps,
             "Rate at which the video was recorded (default: that of the file)")
        .between(1.0, 10000.0);
    options
        .add("--gamma N", arguments->gamma,
             "Gamma of the camera, for beams and videos. Widths and time constants depend on it")
        .show_default()
        .between(1.0, 4.0);
    options.add("--lock NAME,...", arguments->locked, "Parameters that keep their values");
    options.add("--fit NAME,...", arguments->fitted,
                "Parameters to find that the look does not name itself");
    options.add("-o,--output FILE", arguments->output,
                "Save the preset as a .json file, and the camera next to it as .camera.json");
    options.add("--report FILE", arguments->report,
                "Save both pictures, their difference and all numbers as a .html file");
    options.add("--name NAME", arguments->name, "Name of the preset");
    options.add_flag("--json", arguments->as_json, "Print one JSON document");
    return [arguments](const DataFolders& data) { return match(*arguments, data); };
}
