#include "lab/media/chosen_images.h"

#include "io/pictures/picture_file.h"
#include "lab/media/look_media.h"
#include "lab/rendering/sanitize.h"
#include "model/picture/solid_picture.h"
#include "signals/patterns/generated_picture.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

namespace fs = std::filesystem;

namespace {
using SetImage = std::function<Result<void>(const Picture&)>;

Result<void> show_black(const SetImage& set_image) {
    return set_image({{1, 1}, 4, Encoding::linear, {0.0f, 0.0f, 0.0f, 1.0f}});
}

PictureShape shape_of(const Look& look, const Parameter& parameter) {
    const auto image = std::ranges::find(look.images, parameter.name, &Image::name);
    return image == look.images.end() ? PictureShape::flat : image->shape;
}

// Reads a picture and converts it to the shape that its samplers need, such as panorama to cube.
// This happens on the reading thread.
Result<Picture> read_chosen(const fs::path& file, PictureShape shape) {
    auto picture = made_name(file.string()) ? made_picture(file.string()) : load_picture(file);
    if (!picture || picture->shape == shape)
        return picture;
    auto solid = solid_of(*picture, shape);
    if (solid) {
        solid->note = picture->note;
        return solid;
    }
    Diagnostics problems = std::move(solid.error());
    for (Diagnostic& problem : problems)
        problem.file = file;
    return fail(std::move(problems));
}

Result<void> show_read(const Result<Picture>& picture, const fs::path& file,
                       const SetImage& set_image) {
    auto done = picture ? set_image(*picture) : fail(picture.error());
    if (done)
        return done;
    if (auto cleared = show_black(set_image); !cleared)
        return cleared;
    Diagnostics problems = done.error();
    for (Diagnostic& problem : problems)
        if (problem.file.empty())  // of an image, such as its GPU size
            problem.file = file;
    return fail(std::move(problems));
}

std::optional<fs::file_time_type> written_time(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    return error ? std::nullopt : std::optional(time);
}

Diagnostics warnings(Diagnostics problems, const Parameter& parameter) {
    for (Diagnostic& problem : problems)
        problem = warning_of_black(std::move(problem), parameter.label);
    return problems;
}
// The problems to report for a displayed picture.
Diagnostics amiss_with(const Result<Picture>& picture, const Result<void>& shown,
                       const fs::path& file, const Parameter& parameter) {
    if (!shown)
        return warnings(shown.error(), parameter);
    const auto note = picture ? note_about(*picture, file) : std::nullopt;
    return note ? Diagnostics{*note} : Diagnostics{};
}
}  // namespace

Result<void> ChosenImages::show(const Look& look, const Values& values, Executor& executor,
                                Reading reading) {
    const bool reads_in_background =
        reading == Reading::in_background && std::exchange(m_has_shown, true);
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
        drop_reading(parameter.name);
        if (reads_in_background && written) {
            read_async(look, parameter, file);
            shown[parameter.name] = {file, written, {}};
            continue;
        }
        const auto set_image = [&](const Picture& picture) {
            return executor.set_image(parameter.name, picture);
        };
        if (file.empty()) {
            if (auto done = show_black(set_image); !done)
                return done;
            shown[parameter.name] = {file, written, {}};
            continue;
        }
        const Result<Picture> picture = read_chosen(file, shape_of(look, parameter));
        const auto done = show_read(picture, file, set_image);
        if (!done)
            problems.insert(problems.end(), done.error().begin(), done.error().end());
        shown[parameter.name] = {file, written, amiss_with(picture, done, file, parameter)};
    }
    m_shown = std::move(shown);
    if (!problems.empty())
        return fail(std::move(problems));
    return {};
}

void ChosenImages::read_async(const Look& look, const Parameter& parameter, const fs::path& file) {
    m_reading.push_back(
        {parameter.name, file,
         std::async(std::launch::async, read_chosen, file, shape_of(look, parameter))});
}

// The reading thread finishes in the background, because waiting for it would block the caller.
void ChosenImages::drop_reading(const std::string& parameter) {
    for (Read& read : m_reading)
        if (read.parameter == parameter)
            read.parameter.clear();
}

std::vector<std::string> ChosenImages::take_read(const Look& look, Executor& executor,
                                                 Diagnostics& problems) {
    std::vector<std::string> names;
    std::erase_if(m_reading, [&](Read& read) {
        if (read.picture.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return false;
        const Parameter* parameter = find_parameter(look, read.parameter);
        const auto shown = m_shown.find(read.parameter);
        if (!parameter || shown == m_shown.end())
            return true;
        const Result<Picture> picture = read.picture.get();
        const auto done = show_read(picture, read.file, [&](const Picture& whole) {
            return executor.set_image(parameter->name, whole);
        });
        names.push_back(parameter->name);
        if (!done)
            problems.insert(problems.end(), done.error().begin(), done.error().end());
        shown->second.problems = amiss_with(picture, done, read.file, *parameter);
        return true;
    });
    return names;
}

void ChosenImages::choose(const Look& look, const ChosenFile& chosen) {
    const Parameter* parameter = find_parameter(look, chosen.parameter);
    if (!parameter)
        return;
    if (m_chosen)
        m_reading.push_back({{}, {}, std::move(m_chosen->picture)});
    m_chosen =
        Read{chosen.parameter, chosen.file,
             std::async(std::launch::async, read_chosen, chosen.file, shape_of(look, *parameter))};
}

std::optional<Result<ChosenImages::ChosenFile>> ChosenImages::take_chosen() {
    if (!m_chosen ||
        m_chosen->picture.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    Read read = std::move(*std::exchange(m_chosen, std::nullopt));
    if (const auto picture = read.picture.get(); !picture)
        return fail(picture.error());
    return ChosenFile{std::move(read.parameter), std::move(read.file)};
}

bool ChosenImages::is_reading() const {
    return m_chosen ||
           std::ranges::any_of(m_reading, [](const Read& read) { return !read.parameter.empty(); });
}

void ChosenImages::forget() {
    m_shown.clear();
    m_has_shown = false;
    for (Read& read : m_reading)
        read.parameter.clear();
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
