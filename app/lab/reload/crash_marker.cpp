#include "lab/reload/crash_marker.h"

#include "base/file.h"
#include "base/text.h"
#include "io/system/process.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
constexpr std::string_view header = "afterglow-opening 1";
constexpr char separator = '\0';  // the only character that paths cannot contain

fs::path folder_of(const Roots& roots) {
    return roots.state / "opening";
}

std::vector<fs::path> left_behind_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        if (is_unlocked(entry->path()))  // its program no longer runs
            files.push_back(entry->path());
    return files;
}

constexpr std::string_view compiled = "compiled";
constexpr std::string_view reset = "reset";

std::string text_of(const OpenRequest& request, std::string_view what, const fs::path& edited) {
    std::string text(header);
    for (const std::string& field : {std::string(what), name_of(request), edited.string()})
        text += separator + field;
    for (const StackPart& part : stack_of(request))
        text += separator + fs::absolute(manifest_of(part.path)).lexically_normal().string();
    return text;
}

std::optional<UnfinishedOpening> parse_mark(std::string_view text) {
    const auto fields = split(text, separator);
    if (fields.size() < 5 || fields[0] != header)
        return std::nullopt;
    UnfinishedOpening opening{std::string(fields[2]), {}, std::string(fields[3])};
    opening.is_reset = fields[1] == reset;
    for (std::size_t i = 4; i < fields.size(); ++i)
        opening.paths.emplace_back(std::string(fields[i]));
    return opening;
}
}  // namespace

bool UnfinishedOpening::has(const fs::path& manifest) const {
    return !manifest.empty() &&
           std::ranges::find(paths, fs::absolute(manifest).lexically_normal()) != paths.end();
}

CrashMarker::CrashMarker(const Roots& roots)
    : m_folder(folder_of(roots)), m_name(m_folder / std::to_string(process_id())) {}

CrashMarker::~CrashMarker() {
    end();
}

void CrashMarker::begin(const OpenRequest& request, const fs::path& edited) {
    std::error_code error;
    m_quiet_updates = 0;
    if (!m_file.is_open()) {
        for (const fs::path& file : left_behind_in(m_folder))
            fs::remove(file, error);
        fs::create_directories(m_folder, error);
        m_file = LockedFile(m_name);
    }
    write(text_of(request, compiled, edited));
}

void CrashMarker::write(const std::string& text) {
    if (!m_file.replace(text))
        end();
}

void CrashMarker::leave(const OpenRequest& request) {
    begin(request, {});
    write(text_of(request, reset, {}));
    m_file = LockedFile();
}

void CrashMarker::end() {
    if (!m_file.is_open())
        return;
    std::error_code error;
    fs::remove(m_name, error);
    m_file = LockedFile();
}

void CrashMarker::note_update(bool is_quiet) {
    constexpr int enough = 3;
    m_quiet_updates += is_quiet ? 1 : 0;
    if (m_quiet_updates > enough)
        end();
}

std::optional<UnfinishedOpening> find_unfinished_opening(const Roots& roots) {
    for (const fs::path& file : left_behind_in(folder_of(roots)))
        if (const auto text = read_bytes(file))
            if (auto opening = parse_mark(*text))
                return opening;
    return std::nullopt;
}
