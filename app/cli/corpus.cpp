#include "lab/corpus.h"

#include "cli/common.h"
#include "cli/progress.h"
#include "io/child_process.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <iostream>
#include <mutex>
#include <thread>

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {
struct CorpusArguments {
    std::string place;
    CorpusChoice choice;
    std::string size = "320x240";
    int frames = 4;
    double seconds = 60.0;
    int jobs = 1;
    bool as_json = false;
};

Json json_of_trial(const CorpusTrial& trial) {
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
    CorpusTrial lost;
    lost.file = file;
    lost.why = why;
    return json_of_trial(lost);
}

// A process a file: what a driver does with some shaders ends in no time, or ends the process.
Json tried_alone(const fs::path& file, const CorpusArguments& arguments, const DataFolders& data) {
    constexpr std::size_t most_bytes = 1 << 22;
    std::vector<std::string> command{
        "/proc/self/exe", "corpus",       file.string(), "--json",
        "--size",         arguments.size, "--frames",    std::to_string(arguments.frames)};
    if (!data.data.empty())
        command.insert(command.end(), {"--data", data.data});
    for (const std::string& folder : data.includes)
        command.insert(command.end(), {"--include", folder});
    for (const std::string& limit : data.limit_texts)
        command.insert(command.end(), {"--limit", limit});
    auto child = ChildProcess::start(command);
    if (!child)
        return json_of_lost(file, to_string(child.error()));
    const auto text = child->read_all_within(arguments.seconds, most_bytes);
    if (!text)
        return json_of_lost(file, fmt::format("took longer than {} s", arguments.seconds));
    const Json document = Json::parse(*text, nullptr, false);
    if (document.is_discarded() || !document.contains("files") || document["files"].size() != 1)
        return json_of_lost(file, "its process ended: " + child->complaint());
    return document["files"][0];
}

std::vector<Json> tried_all(const std::vector<fs::path>& files, const CorpusArguments& arguments,
                            const DataFolders& data) {
    std::vector<Json> trials(files.size());
    Progress progress("trying", static_cast<int>(files.size()), "files");
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
    std::cout << fmt::format("{} files: {} parsed, {} compiled, {} linked, {} drew\n",
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
    if (!fs::is_directory(arguments.place, error)) {
        if (!fs::exists(arguments.place, error))
            return report({{arguments.place, 0, "there is no such file or folder"}});
        const CorpusTrial trial = try_look(arguments.place, task, *library);
        print_trials({json_of_trial(trial)}, arguments.as_json);
        return trial.why.empty() ? exit_done : exit_not_good;
    }
    const std::vector<fs::path> files = corpus_files(arguments.place, arguments.choice);
    if (files.empty())
        return report({{arguments.place, 0, "there is no look of another program in it"}});
    const std::vector<Json> trials = tried_all(files, arguments, data);
    print_trials(trials, arguments.as_json);
    const bool is_good = std::ranges::all_of(
        trials, [](const Json& trial) { return trial["why"].template get<std::string>().empty(); });
    return is_good ? exit_done : exit_not_good;
}
}  // namespace

/// afterglow corpus DIR --json
Command add_corpus(CommandLine& program) {
    Options options = program.add_verb("corpus", "Try every look of another program in a folder");
    auto arguments = std::make_shared<CorpusArguments>();
    options.add("DIR", arguments->place, "A folder, or one file").required();
    options.add("--only", arguments->choice.only, "Part of the paths to be tried");
    options.add("--sample", arguments->choice.sample, "So many of the files, by chance; 0: all")
        .show_default()
        .between(0, 10'000'000);
    options.add("--seed", arguments->choice.seed, "Of that chance: the same files each time")
        .show_default()
        .between(0, 1'000'000);
    options.add("--size", arguments->size, "Of the picture, px").show_default();
    options.add("--frames", arguments->frames, "Drawn of each; 0: shaders are only checked")
        .show_default()
        .between(0, 10000);
    options.add("--seconds", arguments->seconds, "After which a file is given up")
        .show_default()
        .between(0.1, 86400.0);
    options.add("--jobs", arguments->jobs, "Files that are tried at once")
        .show_default()
        .between(1, 256);
    options.add_flag("--json", arguments->as_json, "One JSON document");
    return [arguments](const DataFolders& data) { return run_corpus(*arguments, data); };
}
