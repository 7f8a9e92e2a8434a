#include "cli/common.h"
#include "cli/progress.h"
#include "lab/golden/golden_check.h"
#include "lab/golden/golden_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iostream>

using Json = nlohmann::ordered_json;

namespace {
constexpr std::array golden_examples{
    "afterglow golden my-looks --update",
    "afterglow golden my-looks",
    "afterglow golden my-looks --max 3/255 --share '0.5 %' --json",
    "afterglow golden my-looks --update glow glow--warm",
};

struct GoldenArguments {
    std::string folder;
    std::string directory = "golden";
    std::string size;
    int frames = 0;  // 0: not given
    std::string levels;
    std::string percent;
    std::vector<std::string> update;  // names; `all_pictures` without names; empty: not given
    bool as_json = false;
};

// Can't be a name, which has no spaces.
constexpr const char* all_pictures = "all pictures";

std::string shell_word(const std::string& text) {
    const bool is_plain = !text.empty() && std::ranges::all_of(text, [](char letter) {
        const auto byte = static_cast<unsigned char>(letter);
        return byte >= 0x80 || std::isalnum(byte) ||
               std::string_view("_./+:=@%,-").find(letter) != std::string_view::npos;
    });
    if (is_plain)
        return text;
    std::string quoted = "'";
    for (const char letter : text)
        quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return quoted + "'";
}

// The same command with --update, without a name.
std::string update_command(const GoldenArguments& arguments, const DataFolders& data) {
    std::string command = "afterglow golden " + shell_word(arguments.folder);
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty())
            command += fmt::format(" {} {}", option, shell_word(value));
    };
    add("--dir", arguments.directory == "golden" ? "" : arguments.directory);
    add("--size", arguments.size);
    add("--frames", arguments.frames > 0 ? std::to_string(arguments.frames) : "");
    add("--max", arguments.levels);
    add("--share", arguments.percent);
    add("--data", data.data);
    for (const std::string& folder : data.includes)
        add("--include", folder);
    for (const std::string& limit : data.limit_texts)
        add("--limit", limit);
    return command + " --update";
}

template <class T>
std::optional<double> parse_bound(const char* option, const std::string& text, const char* expected,
                                  const T& parse) {
    if (text.empty())
        return std::nullopt;
    const auto number = parse(text);
    if (!number)
        throw UsageError(fmt::format("{}: expected {}, got '{}'", option, expected, text));
    return number;
}

GoldenRequest request_of(const GoldenArguments& arguments, const DataFolders& data) {
    GoldenRequest request{.folder = arguments.folder, .directory = arguments.directory};
    if (!arguments.size.empty())
        request.size = parse_size(arguments.size);
    if (arguments.frames > 0)
        request.frames = arguments.frames;
    request.levels =
        parse_bound("--max", arguments.levels, "a difference from 0/255 to 255/255", parse_levels);
    request.percent =
        parse_bound("--share", arguments.percent, "a share from 0 % to 100 %", parse_percent);
    request.updates = !arguments.update.empty();
    request.names = arguments.update;
    std::erase(request.names, all_pictures);
    if (std::ranges::find(request.names, "") != request.names.end())
        throw UsageError("--update: the value is empty");
    request.update_command = update_command(arguments, data);
    return request;
}

Json json_of(const GoldenResult& result) {
    Json json{{"name", result.item.name},
              {"status", name_of(result.status)},
              {"look", result.item.look},
              {"preset", result.item.preset},
              {"file", result.item.file.string()},
              {"size", dimensions_text(result.size)},
              {"frames", result.frames}};
    if (result.difference)
        json.update({{"mean", result.difference->mean},
                     {"max", result.difference->largest},
                     {"share", 100.0 * result.difference->share_beyond}});
    if (!result.note.empty())
        json["note"] = result.note;
    if (!result.command.empty())
        json["command"] = result.command;
    Json problems = Json::array();
    for (const Diagnostic& problem : result.problems)
        problems.push_back(to_string(problem));
    json["problems"] = std::move(problems);
    return json;
}

void print_json(const GoldenRequest& request, const GoldenOutcome& outcome) {
    Json pictures = Json::array();
    for (const GoldenResult& result : outcome.results)
        pictures.push_back(json_of(result));
    Json warnings = Json::array();
    for (const Diagnostic& warning : outcome.warnings)
        warnings.push_back(to_string(warning));
    const Json json{{"passed", !outcome.has_failed()},
                    {"max", outcome.bounds.levels},
                    {"share", outcome.bounds.percent},
                    {"driver",
                     {{"vendor", outcome.driver.vendor},
                      {"renderer", outcome.driver.renderer},
                      {"version", outcome.driver.version}}},
                    {"report", golden_report_file(request).string()},
                    {"warnings", std::move(warnings)},
                    {"pictures", std::move(pictures)}};
    std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

const char* advice(GoldenStatus status) {
    switch (status) {
        case GoldenStatus::missing:
            return "Create it";
        case GoldenStatus::orphaned:
            return "Remove it";
        default:
            return "Accept it";
    }
}

void print_list(const GoldenRequest& request, const GoldenOutcome& outcome) {
    for (const GoldenResult& result : outcome.results) {
        if (result.status == GoldenStatus::equal)
            continue;
        std::string line = fmt::format("{}: {}", name_of(result.status), result.item.name);
        const std::string why =
            result.note.empty() ? difference_text(result, outcome.bounds) : result.note;
        if (!why.empty())
            line += ": " + why;
        std::cout << line << '\n';
        if (!result.command.empty())
            std::cout << fmt::format("  {}: {}\n", advice(result.status), result.command);
    }
    std::cout << fmt::format("Pictures: {} ({})\nReport: {}\n", outcome.results.size(),
                             counts_text(outcome), golden_report_file(request).string());
}

int run_golden(const GoldenArguments& arguments, const DataFolders& data) {
    const GoldenRequest request = request_of(arguments, data);
    const auto library = open_library(data);
    if (!library)
        return report(library.error());
    std::optional<Progress> progress;
    const auto outcome = check_golden(request, *library, [&](int done, int all) {
        if (!progress)
            progress.emplace(Progress::Kind::rendering_pictures, all);
        progress->show(done);
    });
    progress.reset();
    if (!outcome)
        return report(outcome.error());
    for (const GoldenResult& result : outcome->results)
        warn(result.problems);
    warn(outcome->warnings);
    if (const auto saved = save_golden_report(request, *outcome); !saved)
        return report(saved.error());
    arguments.as_json ? print_json(request, *outcome) : print_list(request, *outcome);
    return outcome->has_failed() ? exit_failure : exit_done;
}
}  // namespace

/// afterglow golden FOLDER
Command add_golden(CommandLine& program) {
    Options options = program.add_verb(
        "golden",
        "Compare looks and presets with golden pictures\n\n"
        "Draws all looks and presets in FOLDER, compares them with the pictures in golden/, and "
        "writes the report golden/report.html. Looks of other programs count, too.",
        golden_examples);
    auto arguments = std::make_shared<GoldenArguments>();
    options.add("FOLDER", arguments->folder, "Folder of looks and presets").required();
    options.add("--dir FOLDER", arguments->directory, "Folder of the golden pictures")
        .show_default();
    options
        .add("--update [NAME...]", arguments->update,
             "Write these golden pictures, or without a NAME all of them")
        .or_alone(all_pictures);
    options.add("--size WxH", arguments->size,
                "Render size in pixels (default: that of golden.json, else 320x180)");
    options
        .add("--frames N", arguments->frames,
             "Frames to render for each picture (default: those of golden.json, else until the "
             "look has settled, at most 60)")
        .between(1, max_settle_frames);
    options.add("--max LEVELS", arguments->levels,
                "Difference that counts, such as 2/255 (default: that of golden.json, else 2/255)");
    options.add("--share PERCENT", arguments->percent,
                "Share of the pixels that may differ by more than --max (default: that of "
                "golden.json, else 0.1 %)");
    options.add_flag("--json", arguments->as_json, "Print one JSON document");
    return [arguments](const DataFolders& data) { return run_golden(*arguments, data); };
}
