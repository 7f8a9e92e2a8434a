#include "lab/corpus.h"

#include "base/text.h"
#include "gpu/draw.h"
#include "gpu/error_log.h"
#include "lab/offline.h"

#include <algorithm>
#include <chrono>

namespace fs = std::filesystem;

namespace {
class Stopwatch {
public:
    /// Since it was made or last asked.
    double milliseconds() {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double, std::milli> gone = now - m_start;
        m_start = now;
        return gone.count();
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

// Shaders alone are pieces of presets more often than looks.
bool is_of_corpus(const fs::path& file) {
    return is_foreign_look(file) && to_lower(file.extension().string()) != ".slang";
}

void draw(Prepared prepared, const CorpusTask& task, CorpusTrial& trial) {
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
        trial.why = "the driver reports " + errors.front();
}
}  // namespace

CorpusTrial try_look(const fs::path& file, const CorpusTask& task, const Library& library) {
    CorpusTrial trial;
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

std::vector<fs::path> corpus_files(const fs::path& folder, const std::string& only) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error);
         entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        if (error)
            break;
        const fs::path& path = entry->path();
        if (path.filename().string().starts_with('.')) {
            if (entry->is_directory(error))
                entry.disable_recursion_pending();
        } else if (is_of_corpus(path) && path.string().find(only) != std::string::npos) {
            files.push_back(path);
        }
    }
    std::ranges::sort(files);
    return files;
}
