#include "lab/offline/corpus.h"

#include "cli/common.h"
#include "cli/progress.h"
#include "io/system/child_process.h"
#include "io/system/process.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <atomic>
#include <iostream>
#include <mutex>
#include <thread>

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {
constexpr std::array corpus_examples{
    "afterglow corpus slang-shaders",
    "afterglow corpus slang-shaders --only crt/ --jobs 4",
    "afterglow corpus shadertoy --sample 100 --seed 11 --json > report.json",
};

struct CorpusArguments {
    std::string folder;
    CorpusChoice choice;
    std::string size = "320x240";
    int frames = 4;
    double seconds = 60.0;
    int jobs = 1;
    bool as_json = false;
};

Json json_of_trial(const CorpusResult& trial) {
    Json warnings = Json::array();
    for (const Diagnostic& warning : trial.warnings)
        warnings.push_back(to_string(warning));
    return {{"file", trial.file.string()},
            {"parsed", trial.is_parsed},
            {"compiled", trial.is_compiled},
            {"linked", trial.is_linked},
            {"drew", trial.has_drawn},
            {"passes", trial.passes},
            {"parameters", trial.parameters},
            {"images", trial.images},
            {"ms",
             {{"read", trial.read_ms},
              {"link", trial.link_ms},
              {"first_frame", trial.first_ms},
              {"frame", trial.frame_ms}}},
            {"warnings", std::move(warnings)},
            {"why", trial.why}};
}

Json json_of_lost(const fs::path& file, const std::string& why) {
    CorpusResult lost;
    lost.file = file;
    lost.why = why;
    return json_of_trial(lost);
}

// One process per file, because some shaders make a driver hang or crash.
Json tried_alone(const fs::path& file, const CorpusArguments& arguments, const DataFolders& data) {
    constexpr std::size_t max_bytes = 1 << 22;
    std::vector<std::string> command{
        program_command(), "corpus",       file.string(), "--json",
        "--size",          arguments.size, "--frames",    std::to_string(arguments.frames)};
    if (!data.data.empty())
        command.insert(command.end(), {"--data", data.data});
    for (const std::string& folder : data.includes)
        command.insert(command.end(), {"--include", folder});
    for (const std::string& limit : data.limit_texts)
        command.insert(command.end(), {"--limit", limit});
    auto child = ChildProcess::start(command);
    if (!child)
        return json_of_lost(file, to_string(child.error()));
    const auto text = child->read_all_within(arguments.seconds, max_bytes);
    if (!text)
        return json_of_lost(file, fmt::format("timed out after {} s", arguments.seconds));
    const Json document = Json::parse(*text, nullptr, false);
    if (document.is_discarded() || !document.contains("files") || document["files"].size() != 1)
        return json_of_lost(
            file, fmt::format("the process ended without a result: {}", child->complaint()));
    return document["files"][0];
}

std::vector<Json> tried_all(const std::vector<fs::path>& files, const CorpusArguments& arguments,
                            const DataFolders& data) {
    std::vector<Json> trials(files.size());
    Progress progress(Progress::Kind::checking_files, static_cast<int>(files.size()));
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    int done = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < files.size(); i = next++) {
            trials[i] = tried_alone(files[i], arguments, data);
            const std::scoped_lock lock(mutex);
            progress.show(++done);
        }
    };
    std::vector<std::jthread> workers;
    for (int i = 0; i < arguments.jobs; ++i)
        workers.emplace_back(work);
    workers.clear();
    return trials;
}

Json sums_of(const std::vector<Json>& trials) {
    Json sums{{"files", trials.size()}};
    for (const char* stage : {"parsed", "compiled", "linked", "drew"})
        sums[stage] = std::ranges::count_if(
            trials, [&](const Json& trial) { return trial[stage].template get<bool>(); });
    return sums;
}

void print_trials(const std::vector<Json>& trials, bool as_json) {
    const Json sums = sums_of(trials);
    if (as_json) {
        std::cout << Json{{"sum", sums}, {"files", trials}}.dump(2) << '\n';
        return;
    }
    for (const Json& trial : trials)
        if (const auto why = trial["why"].get<std::string>(); !why.empty())
            std::cout << fmt::format("{}: {}\n", trial["file"].get<std::string>(), why);
    std::cout << fmt::format("Files: {}, parsed: {}, compiled: {}, linked: {}, drawn: {}\n",
                             sums["files"].get<int>(), sums["parsed"].get<int>(),
                             sums["compiled"].get<int>(), sums["linked"].get<int>(),
                             sums["drew"].get<int>());
}

int run_corpus(const CorpusArguments& arguments, const DataFolders& data) {
    const CorpusTask task{parse_size(arguments.size), arguments.frames};
    const auto library = open_library(data);
    if (!library)
        return report(library.error());
    std::error_code error;
    if (!fs::is_directory(arguments.folder, error)) {
        if (!fs::exists(arguments.folder, error))
            return report({{arguments.folder, 0, "file or folder not found"}});
        const CorpusResult trial = try_look(arguments.folder, task, *library);
        print_trials({json_of_trial(trial)}, arguments.as_json);
        return trial.why.empty() ? exit_done : exit_failure;
    }
    const std::vector<fs::path> files = corpus_files(arguments.folder, arguments.choice);
    if (files.empty())
        return report({{arguments.folder, 0, "the folder contains no shaders of other programs"}});
    const std::vector<Json> trials = tried_all(files, arguments, data);
    print_trials(trials, arguments.as_json);
    const bool is_good = std::ranges::all_of(
        trials, [](const Json& trial) { return trial["why"].template get<std::string>().empty(); });
    return is_good ? exit_done : exit_failure;
}
}  // namespace

/// afterglow corpus DIR --json
Command add_corpus(CommandLine& program) {
    Options options = program.add_verb("corpus",
                                       "Check all shaders of other programs in a folder\n\n"
                                       "Each file is read, compiled, linked and drawn in its own "
                                       "process.",
                                       corpus_examples);
    auto arguments = std::make_shared<CorpusArguments>();
    options.add("FOLDER", arguments->folder, "Folder, or a single file").required();
    options.add("--only TEXT", arguments->choice.only, "Only files with this text in their path");
    options
        .add("--sample N", arguments->choice.sample,
             "Number of files to sample at random, or 0 for all")
        .show_default()
        .between(0, 10'000'000);
    options.add("--seed N", arguments->choice.seed, "Random seed of --sample")
        .show_default()
        .between(0, 1'000'000);
    options.add("--size WxH", arguments->size, "Render size in pixels").show_default();
    options
        .add("--frames N", arguments->frames,
             "Frames to draw per file, or 0 to only check the shaders")
        .show_default()
        .between(0, 10000);
    options.add("--seconds S", arguments->seconds, "Timeout per file in seconds")
        .show_default()
        .between(0.1, 86400.0);
    options.add("--jobs N", arguments->jobs, "Number of files to check in parallel")
        .show_default()
        .between(1, 256);
    options.add_flag("--json", arguments->as_json, "Print one JSON document");
    return [arguments](const DataFolders& data) { return run_corpus(*arguments, data); };
}
