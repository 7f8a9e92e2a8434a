#include "lab/chosen_images.h"

#include "io/picture_file.h"
#include "lab/look_media.h"

#include <functional>

namespace fs = std::filesystem;

namespace {
using SetImage = std::function<Result<void>(const Picture&)>;

Result<void> show_black(const SetImage& set_image) {
    return set_image({{1, 1}, 4, Encoding::linear, {0.0f, 0.0f, 0.0f, 1.0f}});
}

Result<void> show_file(const fs::path& file, const SetImage& set_image) {
    const auto picture =
        made_name(file.string()) ? made_picture(file.string()) : load_picture(file);
    auto done = picture ? set_image(*picture) : fail(picture.error());
    if (done)
        return done;
    if (auto cleared = show_black(set_image); !cleared)
        return cleared;
    Diagnostics problems = done.error();
    for (Diagnostic& problem : problems)
        if (problem.file.empty())  // of what it was to be
            problem.file = file;
    return fail(std::move(problems));
}

std::optional<fs::file_time_type> written_time(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    return error ? std::nullopt : std::optional(time);
}

Diagnostics warnings(Diagnostics problems, const Parameter& parameter) {
    for (Diagnostic& problem : problems) {
        problem.message += "; '" + parameter.label + "' reads black";
        problem.severity = Severity::warning;
    }
    return problems;
}
}  // namespace

Result<void> ChosenImages::show(const Look& look, const Values& values, Renderer& renderer,
                                Renderer::Whose whose) {
    Diagnostics problems;
    std::map<std::string, Shown> shown;
    for (const Parameter& parameter : look.parameters) {
        if (parameter.control != Control::image)
            continue;
        const fs::path file = value_of(parameter, values).path;
        const auto before = m_shown.find(parameter.name);
        if (file.empty() && before == m_shown.end())
            continue;
        const auto written = written_time(file);
        if (before != m_shown.end() && before->second.file == file &&
            before->second.written == written) {
            shown.insert(*before);
            continue;
        }
        const auto set_image = [&](const Picture& picture) {
            return renderer.set_image(whose, parameter.name, picture);
        };
        const auto done = file.empty() ? show_black(set_image) : show_file(file, set_image);
        const Diagnostics reasons = done ? Diagnostics() : done.error();
        problems.insert(problems.end(), reasons.begin(), reasons.end());
        shown[parameter.name] = {file, written, warnings(reasons, parameter)};
    }
    m_shown = std::move(shown);
    if (!problems.empty())
        return fail(std::move(problems));
    return {};
}

bool ChosenImages::forget(const fs::path& file) {
    bool is_read = false;
    for (auto& [name, shown] : m_shown)
        if (shown.file == file) {
            shown.file.clear();
            is_read = true;
        }
    return is_read;
}

std::vector<fs::path> ChosenImages::files() const {
    std::vector<fs::path> files;
    for (const auto& [name, shown] : m_shown)
        if (!shown.file.empty() && !made_name(shown.file.string()))
            files.push_back(shown.file);
    return files;
}

Diagnostics ChosenImages::problems() const {
    Diagnostics problems;
    for (const auto& [name, shown] : m_shown)
        problems.insert(problems.end(), shown.problems.begin(), shown.problems.end());
    return problems;
}
