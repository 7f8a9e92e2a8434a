#include "lab/match/match_job.h"

#include "formats/photo/camera_json.h"
#include "io/system/machine_memory.h"
#include "lab/match/photo_check.h"
#include "model/photo/screen_corners.h"

#include <algorithm>

namespace {
constexpr double corner_error = 0.001;  // of the screen's width: how well users place corners

double size_in_photo(const Corners& corners) {
    return glm::length(corners[1] - corners[0]);
}

Result<void> check_look(const PreparedLook& prepared, Extent size) {
    if (prepared.document.look().driven_by != Driver::picture)
        return fail({{},
                     0,
                     "This look draws a signal. Choose a look that shows a picture, such as "
                     "shadow-mask."});
    return check_memory(prepared, size, machine_memory());
}

std::vector<std::pair<std::string, std::string>> type_labels(const Matched& matched,
                                                             const MatchedParameters& parameters) {
    std::vector<std::pair<std::string, std::string>> labels;
    for (const Parameter* type : parameters.types)
        for (const Item& item : type->items)
            if (item.value == matched.state.values.at(type->name).number())
                labels.emplace_back(type->name, item.label);
    return labels;
}

Values found_values(const Matched& matched, const MatchedParameters& parameters) {
    Values values;
    const auto take = [&](const std::string& name) {
        values[name] = matched.state.values.at(name);
    };
    for (const auto* list : {&parameters.types, &parameters.starts})
        for (const Parameter* parameter : *list)
            take(parameter->name);
    for (const FoundNumber& number : matched.numbers)
        take(number.parameter);
    return values;
}
}  // namespace

Result<MatchJobResult> match(MatchJob job, JobProgress& work) {
    const Extent size = job.size.is_empty() ? screen_size(job.corners) : job.size;
    if (auto good = check_look(job.prepared, size); !good)
        return fail(good.error());
    const Document document = job.prepared.document;
    const auto parameters = matched_parameters(document, job.choice);
    if (!parameters)
        return fail(parameters.error());
    auto renderer = ScreenRenderer::create(std::move(job.prepared), size);
    if (!renderer)
        return fail(renderer.error());
    const Extent extent = job.photo->extent;
    const Photo photo(*job.photo);
    PhotoFit fit(*renderer, photo, work);
    auto matched = match_photo(
        fit, {.parameters = *parameters,
              .start = {starting_values(document, *parameters), {.corners = job.corners}},
              .corner_deviation = std::max(1.0, corner_error * size_in_photo(job.corners)),
              .on_progress = std::move(job.on_progress),
              .draws_pictures = job.draws_pictures,
              .on_better_corners = std::move(job.on_better_corners),
              .photo = job.file});
    if (!matched)
        return fail(matched.error());
    MatchJobResult result{found_values(*matched, *parameters),
                          *matched,
                          type_labels(*matched, *parameters),
                          {},
                          extent,
                          size};
    if (matched->is_complete) {
        auto pictures = match_pictures(fit, matched->state);
        if (!pictures)
            return fail(pictures.error());
        result.pictures = std::move(*pictures);
    }
    return result;
}

Result<MatchedFile> match_file(const MatchFileRequest& request, const Library& library,
                               JobProgress& work) {
    auto read = load_photo(request.photo);
    if (!read)
        return fail(read.error());
    const auto photo = std::make_shared<const Picture>(std::move(*read));
    const Corners corners = request.corners
                                ? *request.corners
                                : guess_corners(*photo).value_or(corners_of(photo->extent));
    if (auto good = check_photo(*photo, corners, request.photo); !good)
        return fail(good.error());
    RenderRequest render = request.render;
    if (render.size.is_empty())
        render.size = screen_size(corners);
    auto prepared = prepare(render, library);
    if (!prepared)
        return fail(prepared.error());
    MatchedFile matched{prepared->document, {}, prepared->warnings};
    auto result = match({.prepared = std::move(*prepared),
                         .photo = photo,
                         .file = request.photo,
                         .corners = corners,
                         .choice = request.choice,
                         .size = render.size,
                         .on_progress = request.on_progress},
                        work);
    if (!result)
        return fail(result.error());
    matched.result = std::move(*result);
    set_found(matched.document, matched.result.values);
    return matched;
}

void set_found(Document& document, const Values& values) {
    DocumentState next = document.state();
    for (const Parameter& parameter : document.look().parameters)
        if (const auto found = values.find(parameter.name); found != values.end())
            next.values[parameter.name] = found->second;
    document.change(std::move(next), "Match a photo");
}

std::string camera_json(const MatchJobResult& result) {
    return camera_json(result.matched.state.camera, result.photo);
}
