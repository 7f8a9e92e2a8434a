#include "match/trial.h"

#include "io/pictures/picture_file.h"
#include "lab/offline/prepared_look.h"
#include "model/look/color.h"

#include <fmt/format.h>

#include <chrono>
#include <random>

namespace fs = std::filesystem;

namespace {
// The tube is finer than what the camera resolves.
struct Sizes {
    Extent tube;
    Extent photo;
    Extent fitted;
};

Sizes sizes_of(const Trial& trial) {
    return trial.is_small ? Sizes{{512, 384}, {400, 304}, {320, 240}}
                          : Sizes{{1280, 960}, {1000, 760}, {800, 600}};
}
constexpr double fitted_scale = 0.625;  // of lengths in px

struct Truth {
    Values values;  // for the fitted size
    SyntheticCamera camera;
};

Truth truth_of(const Trial& trial) {
    std::mt19937 random(static_cast<std::uint32_t>(trial.seed * 16 + trial.mask));
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Truth truth;
    truth.values = {{"mask_type", Value(static_cast<double>(trial.mask))},
                    {"mask_size", Value(between(5.0, trial.is_small ? 7.0 : 12.0))},
                    {"mask_strength", Value(between(0.5, 0.95))},
                    {"scanline_strength", Value(between(0.3, 0.8))},
                    {"scanline_period", Value(between(4.0, trial.is_small ? 6.0 : 8.0))},
                    {"bloom_radius", Value(between(3.0, 10.0))},
                    {"bloom_intensity", Value(between(0.15, 0.6))},
                    {"curvature", Value(between(0.0, 0.12))}};
    if (trial.is_small)
        truth.values["bloom_intensity"] = Value(0.0);
    if (trial.mask_size > 0.0)
        truth.values["mask_size"] = Value(trial.mask_size);
    SyntheticCamera& camera = truth.camera;
    camera.corners = {glm::dvec2(90, 70), glm::dvec2(905, 60), glm::dvec2(915, 690),
                      glm::dvec2(80, 700)};
    for (glm::dvec2& corner : camera.corners)
        corner += glm::dvec2(between(-25.0, 25.0), between(-25.0, 25.0));
    if (trial.is_small)
        for (glm::dvec2& corner : camera.corners)
            corner *= 0.4;
    camera.lens = between(-0.03, 0.03);
    camera.blur = between(0.7, 1.3);
    camera.noise = between(0.003, 0.012);
    camera.vignette = between(0.0, 0.3);
    camera.gain = between(0.6, 0.85);
    camera.gamma = between(2.0, 2.4);
    const double cross = between(0.0, 0.06);
    camera.colour = glm::dmat3(1.0 - cross);
    for (glm::length_t column = 0; column < 3; ++column)
        for (glm::length_t row = 0; row < 3; ++row)
            camera.colour[column][row] += cross / 3.0;
    camera.seed = static_cast<std::uint32_t>(trial.seed);
    return truth;
}

RenderRequest request_of(Extent size, const std::string& source) {
    RenderRequest request{.look = "shadow-mask", .source = source, .size = size};
    request.values = {{"vignette_depth", "0"},    {"pulse_intensity", "0"},
                      {"red_offset", "0,0"},      {"green_offset", "0,0"},
                      {"blue_offset", "0,0"},     {"exposure", "0.5"},
                      {"sampling", "Continuous"}, {"scanline_strength", "0.4"}};
    return request;
}

Result<PreparedLook> prepared_for(Extent size, const std::string& source) {
    auto roots = find_roots(fs::path(AFTERGLOW_SOURCE_DIR));
    if (!roots)
        return fail(roots.error());
    return prepare(request_of(size, source), Library(std::move(*roots)));
}

Result<Picture> photo_of(const Truth& truth, const Sizes& sizes, const fs::path& file) {
    auto prepared = prepared_for(sizes.tube, "pattern:harbour");
    if (!prepared)
        return fail(prepared.error());
    auto tube = ScreenRenderer::create(std::move(*prepared), sizes.tube);
    if (!tube)
        return fail(tube.error());
    Values values = truth.values;
    for (const char* name : {"mask_size", "scanline_period"})
        values[name] = Value(values[name].number() / fitted_scale);
    auto screen = tube->picture(values);
    if (!screen)
        return screen;
    for (float& value : screen->pixels)
        value = static_cast<float>(srgb_decode(static_cast<double>(value)));
    if (!save_jpeg(photograph(*screen, truth.camera, sizes.photo), file, 90))
        return fail({file, 0, "not written"});
    return load_picture(file);
}

Corners user_corners(const Truth& truth, const Trial& trial) {
    std::mt19937 random(static_cast<std::uint32_t>(trial.seed + 1000));
    std::normal_distribution<double> error(0.0, 1.0);
    Corners corners = truth.camera.corners;
    for (glm::dvec2& corner : corners)
        corner += trial.corner_error * glm::dvec2(error(random), error(random));
    return corners;
}

Camera true_camera(const SyntheticCamera& camera) {
    return {.corners = camera.corners,
            .lens = camera.lens,
            .blur = camera.blur,
            .vignette = camera.vignette,
            .gamma = camera.gamma,
            .colour = camera.gain * camera.colour};
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Each number found so far next to the true one.
void print_progress(const MatchProgress& progress, const Truth& truth, int pictures,
                    double seconds) {
    fmt::print(stderr, "  {:16} residual {:.4f}, {} pictures, {:.1f} s:", progress.stage,
               progress.residual, pictures, seconds);
    for (const auto& [name, value] : truth.values)
        fmt::print(stderr, " {} {:.4f}/{:.4f}", name, progress.state.values.at(name).number(),
                   value.number());
    const Camera& camera = progress.state.camera;
    fmt::print(stderr,
               "; lens {:.4f}/{:.4f} blur {:.2f}/{:.2f} sharpening {:.2f} mosaic {:.2f} vignette "
               "{:.3f}/{:.3f}",
               camera.lens, truth.camera.lens, camera.blur, truth.camera.blur, camera.sharpening,
               camera.mosaic, camera.vignette, truth.camera.vignette);
    fmt::print(stderr, " gamma {:.3f}/{:.3f} gain {:.3f}/{:.3f} corners", camera.gamma,
               truth.camera.gamma, camera.colour[0][0],
               truth.camera.gain * truth.camera.colour[0][0]);
    for (std::size_t i = 0; i < 4; ++i)
        fmt::print(stderr, " {:.2f},{:.2f}", camera.corners[i].x - truth.camera.corners[i].x,
                   camera.corners[i].y - truth.camera.corners[i].y);
    fmt::print(stderr, "\n");
}

// The true values with the camera that fits them best, and their mean square.
Result<double> fit_camera(PhotoFit& fit, MatchState& truth) {
    std::vector<Unknown> camera = exposure_unknowns();
    for (const Unknown& unknown : blur_unknowns())
        camera.push_back(unknown);
    return fit.minimise(truth, camera, {}, 10);
}
}  // namespace

namespace {
MatchChoice choice_of(const Trial& trial) {
    return trial.is_small ? MatchChoice{{"bloom_radius", "bloom_intensity", "curvature"}, {}}
                          : MatchChoice{};
}
}  // namespace

std::array<glm::dvec2, 4> true_corners(const Trial& trial) {
    return truth_of(trial).camera.corners;
}

Result<Picture> take_photo(const Trial& trial, const fs::path& folder) {
    return photo_of(truth_of(trial), sizes_of(trial), folder / "photo.jpg");
}

Result<TrialResult> run_trial(const Trial& trial, const fs::path& folder) {
    const Truth truth = truth_of(trial);
    auto picture = take_photo(trial, folder);
    if (!picture)
        return fail(picture.error());
    const Photo photo(*picture);
    const Extent size = sizes_of(trial).fitted;
    auto prepared = prepared_for(size, trial.source);
    if (!prepared)
        return fail(prepared.error());
    if (trial.is_small)  // what is not to be found
        for (const std::string& name : choice_of(trial).locked)
            prepared->document.set_value(name, truth.values.at(name));
    const Document document = prepared->document;
    const auto parameters = matched_parameters(document, choice_of(trial));
    if (!parameters)
        return fail(parameters.error());
    auto renderer =
        ScreenRenderer::create(std::move(*prepared), size, names_of_numbers(*parameters));
    if (!renderer)
        return fail(renderer.error());
    const auto start_time = std::chrono::steady_clock::now();
    JobProgress work;
    PhotoFit fit(*renderer, photo, work);
    MatchRequest request{
        *parameters,
        {starting_values(document, *parameters), {.corners = user_corners(truth, trial)}}};
    if (std::getenv("AFTERGLOW_MATCH_LOUD"))
        request.on_progress = [&](const MatchProgress& progress) {
            print_progress(progress, truth, renderer->count(), seconds_since(start_time));
        };
    auto matched = match_photo(fit, request);
    if (!matched)
        return fail(matched.error());
    TrialResult result{{}, *matched, 0.0, 0.0};
    result.seconds = seconds_since(start_time);
    for (const auto& [name, value] : truth.values)
        result.truth[name] = value.number();
    MatchState best{starting_values(document, *parameters), true_camera(truth.camera)};
    for (const auto& [name, value] : truth.values)
        best.values[name] = value;
    const auto square = fit_camera(fit, best);
    if (!square)
        return fail(square.error());
    const auto explained = fit.explained_share(best, {true, false});
    if (!explained)
        return fail(explained.error());
    result.residual_of_truth = std::sqrt(*square);
    result.explained_by_truth = *explained;
    return result;
}
