#include "lab/offline/corpus.h"

#include "base/text.h"
#include "formats/foreign_format.h"
#include "formats/shadertoy/shadertoy_files.h"
#include "gpu/error_log.h"
#include "gpu/objects/draw.h"
#include "lab/offline/offline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

namespace fs = std::filesystem;

namespace {
class Stopwatch {
public:
    /// Since construction or the last call.
    double milliseconds() {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double, std::milli> gone = now - m_start;
        m_start = now;
        return gone.count();
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

// By file name only, so that a sample does not have to read all files.
bool may_be_of_corpus(const fs::path& file) {
    const std::vector<std::string> extensions = foreign_extensions();
    return std::ranges::find(extensions, to_lower(file.extension().string())) != extensions.end() &&
           file.filename() != "look.json";
}

// Of a shader with several files, only its main file counts.
bool is_of_corpus(const fs::path& file) {
    return is_foreign_look(file) && !is_shown_by_another(file);
}

bool is_of_libretro(const fs::path& file, std::string_view ending) {
    return to_lower(file.extension().string()) == ending;
}

// If the folder contains presets, .slang files are only parts of them.
void drop_pieces(std::vector<fs::path>& files) {
    const bool has_presets = std::ranges::any_of(
        files, [](const fs::path& file) { return is_of_libretro(file, ".slangp"); });
    if (has_presets)
        std::erase_if(files, [](const fs::path& file) { return is_of_libretro(file, ".slang"); });
}

// Sorts by a hash of the seed and the relative path. The sample is therefore independent of the
// location of the folder.
void order_by_chance(std::vector<fs::path>& files, const fs::path& folder, int seed) {
    std::ranges::sort(files, {}, [&](const fs::path& file) {
        const std::string path = file.lexically_relative(folder).generic_string();
        return std::pair(digest_of(fmt::format("{} {}", seed, path)), file);
    });
}

void draw(PreparedLook prepared, const CorpusTask& task, CorpusResult& trial) {
    Stopwatch watch;
    auto offline = Offline::create(std::move(prepared), task.size, 60.0);
    trial.link_ms = watch.milliseconds();
    if (!offline) {
        trial.why = to_string(offline.error());
        return;
    }
    trial.is_linked = true;
    gpu::ErrorLog log;
    for (int frame = 0; frame < task.frames; ++frame) {
        watch.milliseconds();
        offline->advance();
        gpu::finish();
        trial.frame_ms = watch.milliseconds();
        if (frame == 0)
            trial.first_ms = trial.frame_ms;
    }
    const Diagnostics problems = offline->take_problems();
    trial.warnings.insert(trial.warnings.end(), problems.begin(), problems.end());
    const std::vector<std::string> errors = log.take();
    trial.has_drawn = errors.empty();
    if (!errors.empty())
        trial.why = fmt::format("driver error: {}", errors.front());
}
}  // namespace

CorpusResult try_look(const fs::path& file, const CorpusTask& task, const Library& library) {
    CorpusResult trial;
    trial.file = file;
    Stopwatch watch;
    LoadedLook loaded = load_requested({file, {}, {}}, library);
    trial.read_ms = watch.milliseconds();
    trial.is_parsed = loaded.is_parsed;
    trial.warnings = std::move(loaded.warnings);
    if (!loaded.look) {
        trial.why = to_string(loaded.look.error());
        return trial;
    }
    trial.is_compiled = true;
    trial.passes = loaded.look->passes.size();
    trial.parameters = loaded.look->parameters.size();
    trial.images = loaded.look->images.size();
    if (task.frames > 0)
        draw({Document(std::move(*loaded.look)), {}}, task, trial);
    return trial;
}

std::vector<fs::path> corpus_files(const fs::path& folder, const CorpusChoice& choice) {
    std::vector<fs::path> named;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error);
         entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        if (error)
            break;
        const fs::path& path = entry->path();
        std::error_code ignored;
        if (path.filename().string().starts_with('.')) {
            if (entry->is_directory(ignored))
                entry.disable_recursion_pending();
        } else if (may_be_of_corpus(path) && entry->is_regular_file(ignored) &&
                   path.string().find(choice.only) != std::string::npos) {
            named.push_back(path);
        }
    }
    drop_pieces(named);
    if (choice.sample > 0)
        order_by_chance(named, folder, choice.seed);
    std::vector<fs::path> files;
    for (const fs::path& file : named) {
        if (choice.sample > 0 && files.size() == static_cast<std::size_t>(choice.sample))
            break;
        if (is_of_corpus(file))
            files.push_back(file);
    }
    std::ranges::sort(files);
    return files;
}
