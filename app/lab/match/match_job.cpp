#include "lab/match/match_job.h"

#include "formats/photo/camera_json.h"
#include "io/system/machine_memory.h"
#include "lab/match/beam_match.h"
#include "lab/match/photo_check.h"
#include "model/photo/screen_corners.h"

#include <algorithm>

namespace {
constexpr int beam_lines = 512;         // enough for its smooth profile
constexpr double corner_error = 0.001;  // of the screen's width: how well users place corners

double size_in_photo(const Corners& corners) {
    return glm::length(corners[1] - corners[0]);
}

Result<void> check_look(const PreparedLook& prepared, Extent size) {
    const Look& look = prepared.document.look();
    if (look.driven_by == Driver::nothing)
        return fail({{}, 0, "This look shows neither a picture nor a signal. Choose another one."});
    if (look.driven_by == Driver::picture && look.has_other_driver)
        return fail({{}, 0, "A photo of this look is matched by its beam. Open it with a signal."});
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

Result<MatchedWithPictures> match_with_beam(PreparedLook prepared, const Picture& photo,
                                            Extent size, const MatchRequest& request,
                                            JobProgress& work) {
    auto renderer = BeamRenderer::create(std::move(prepared), size.height);
    return renderer ? match_beam(*renderer, photo, request, work) : fail(renderer.error());
}

Result<MatchedWithPictures> match_with_picture(PreparedLook prepared, const Picture& picture,
                                               Extent size, const MatchRequest& request,
                                               JobProgress& work) {
    auto renderer =
        ScreenRenderer::create(std::move(prepared), size, names_of_numbers(request.parameters));
    if (!renderer)
        return fail(renderer.error());
    const Photo photo(picture);
    PhotoFit fit(*renderer, photo, work);
    auto matched = match_photo(fit, request);
    if (!matched)
        return fail(matched.error());
    if (!matched->is_complete)
        return MatchedWithPictures{std::move(*matched), {}};
    auto pictures = match_pictures(fit, matched->state);
    if (!pictures)
        return fail(pictures.error());
    return MatchedWithPictures{std::move(*matched), std::move(*pictures)};
}

Corners default_corners(const Picture& photo, const Look& look) {
    const Corners whole = corners_of(photo.extent);
    return has_screen_edges(look) ? guess_corners(photo).value_or(whole) : whole;
}
}  // namespace

bool has_screen_edges(const Look& look) {
    return look.driven_by != Driver::signal;
}

Result<MatchJobResult> match(MatchJob job, JobProgress& work) {
    const bool has_beam = job.prepared.document.look().driven_by == Driver::signal;
    const Extent size =
        has_beam ? BeamRenderer::size_of(job.size.is_empty() ? beam_lines : job.size.height)
        : job.size.is_empty() ? screen_size(job.corners)
                              : job.size;
    if (auto good = check_look(job.prepared, size); !good)
        return fail(good.error());
    const Document document = job.prepared.document;
    const auto parameters = matched_parameters(document, job.choice);
    if (!parameters)
        return fail(parameters.error());
    const MatchState start{starting_values(document, *parameters),
                           {.corners = job.corners, .gamma = job.gamma}};
    const MatchRequest request{
        .parameters = *parameters,
        .start = start,
        .corner_deviation = std::max(1.0, corner_error * size_in_photo(job.corners)),
        .on_progress = std::move(job.on_progress),
        .draws_pictures = job.draws_pictures,
        .on_better_corners = std::move(job.on_better_corners),
        .photo = job.file};
    auto found = has_beam
                     ? match_with_beam(std::move(job.prepared), *job.photo, size, request, work)
                     : match_with_picture(std::move(job.prepared), *job.photo, size, request, work);
    if (!found)
        return fail(found.error());
    return MatchJobResult{document.look().id,
                          found_values(found->matched, *parameters),
                          found->matched,
                          type_labels(found->matched, *parameters),
                          std::move(found->pictures),
                          job.photo->extent,
                          size};
}

Result<MatchedFile> match_file(const MatchFileRequest& request, const Library& library,
                               JobProgress& work) {
    auto read = load_photo(request.photo);
    if (!read)
        return fail(read.error());
    const auto photo = std::make_shared<const Picture>(std::move(*read));
    auto prepared = prepare(request.render, library);
    if (!prepared)
        return fail(prepared.error());
    const Corners corners =
        request.corners ? *request.corners : default_corners(*photo, prepared->document.look());
    if (auto good = check_photo(*photo, corners, request.photo); !good)
        return fail(good.error());
    MatchedFile matched{prepared->document, {}, prepared->warnings};
    auto result = match({.prepared = std::move(*prepared),
                         .photo = photo,
                         .file = request.photo,
                         .corners = corners,
                         .choice = request.choice,
                         .gamma = request.gamma,
                         .size = request.render.size,
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
