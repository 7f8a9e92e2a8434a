#include "lab/chosen_images.h"

#include "io/picture_file.h"

namespace {
const std::string& chosen(const Parameter& parameter, const Values& values) {
    return value_of(parameter, values).path;
}

Result<void> show(const Parameter& parameter, const std::string& file, Renderer& renderer) {
    const Picture black{{1, 1}, 4, Encoding::linear, {0.0f, 0.0f, 0.0f, 1.0f}};
    if (file.empty())
        return renderer.set_image(parameter.name, black);
    const auto picture = load_picture(file);
    if (picture)
        return renderer.set_image(parameter.name, *picture);
    if (auto cleared = renderer.set_image(parameter.name, black); !cleared)
        return cleared;
    return fail(picture.error());
}
}  // namespace

Result<void> show_chosen_images(const Look& look, const Values& before, const Values& now,
                                Renderer& renderer) {
    Diagnostics problems;
    for (const Parameter& parameter : look.parameters) {
        if (parameter.control != Control::image ||
            chosen(parameter, before) == chosen(parameter, now))
            continue;
        if (const auto shown = show(parameter, chosen(parameter, now), renderer); !shown)
            problems.insert(problems.end(), shown.error().begin(), shown.error().end());
    }
    if (!problems.empty())
        return fail(std::move(problems));
    return {};
}

Diagnostics missing_images(const Look& look, const Values& values) {
    Diagnostics missing;
    std::error_code error;
    for (const Parameter& parameter : look.parameters)
        if (parameter.control == Control::image && !chosen(parameter, values).empty() &&
            !std::filesystem::exists(chosen(parameter, values), error))
            missing.push_back({chosen(parameter, values), 0,
                               "there is no such file; '" + parameter.label + "' reads black",
                               Severity::warning});
    return missing;
}
