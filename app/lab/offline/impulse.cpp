#include "lab/offline/impulse.h"

#include "gpu/objects/readback.h"
#include "lab/document/users_content.h"
#include "lab/drawing/beam_mapping.h"
#include "lab/offline/offline.h"
#include "lab/offline/rate_comparison.h"
#include "model/look/color.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace {
constexpr int dark_frames = 4;  // before the impulse, to measure the background

// A charge well above the steps of an 8-bit picture and below the ceiling. The beam moves in a
// circle smaller than a pixel, because only a moving beam draws segments.
Beam flash_at(const BeamMapping& placing, const PicturePixel& pixel, double frame_seconds) {
    constexpr int points = 16;
    constexpr double charge = 16.0;  // a frame of 1/60 s has 4096
    const BeamPosition middle = placing.position_of(pixel);
    const double radius = placing.pixel_size() / 4.0;
    Beam beam;
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / points;
        beam.push_back({static_cast<float>(middle[0] + radius * std::cos(angle)),
                        static_cast<float>(middle[1] + radius * std::sin(angle)),
                        static_cast<float>(charge / points),
                        static_cast<float>(frame_seconds * (1.0 - (i + 0.5) / points))});
    }
    return beam;
}

Picture even(Extent extent, float light) {
    return {extent, 3, Encoding::linear,
            std::vector<float>(static_cast<std::size_t>(extent.width) *
                                   static_cast<std::size_t>(extent.height) * 3,
                               light)};
}

Result<void> drive(Offline& offline, Extent size, const ImpulseRequest& request) {
    const Look& look = offline.executor().look();
    if (look.driven_by == Driver::nothing)
        return fail({look.manifest, 0,
                     fmt::format("'{}' uses neither a signal nor a picture, so it has no impulse "
                                 "response",
                                 look.id)});
    if (look.driven_by == Driver::picture)
        return offline.override_source(even(size, 0.0f));
    const BeamMapping placing(look, offline.document().values(), size,
                              beam_fit_of(offline.document().state().signal));
    const PicturePixel pixel{request.pin.x * size.width, request.pin.y * size.height};
    const Beam flash = flash_at(placing, pixel, 1.0 / request.fps);
    offline.override_beam([flash](const PlayedFrame& frame) {
        return frame.number == dark_frames + 1 ? flash : Beam();
    });
    return {};
}

using Numbers = std::array<double, 3>;

Numbers light_at(const Offline& offline, std::size_t pass, const Pin& pin) {
    const int index = static_cast<int>(pass);
    const gpu::Texture& target = offline.executor().target(index);
    const auto [x, y] = pin.texel(target.extent());
    const auto stored = gpu::read_pixel(target, x, y);
    const bool is_display = encoding_of(offline.executor().look(), index) == Encoding::display;
    Numbers light{};
    for (std::size_t i = 0; i < light.size(); ++i) {
        const auto number = static_cast<double>(stored[i]);
        light[i] = is_display ? srgb_decode(std::clamp(number, 0.0, 1.0)) : number;
    }
    return light;
}

PassImpulse impulse_of(std::string pass, const std::vector<Numbers>& frames,
                       const std::vector<double>& seconds) {
    const Numbers& dark = frames[dark_frames - 1];
    PassImpulse impulse{std::move(pass), 0, {}, {}, {}};
    double brightest = 0.0;
    for (int channel = 0; channel < 3; ++channel)
        for (const Numbers& light : frames) {
            const auto i = static_cast<std::size_t>(channel);
            if (light[i] - dark[i] > brightest) {
                brightest = light[i] - dark[i];
                impulse.channel = channel;
            }
        }
    const auto channel = static_cast<std::size_t>(impulse.channel);
    for (std::size_t i = dark_frames; i < frames.size(); ++i) {
        const Numbers& light = frames[i];
        impulse.light.push_back(light[channel] - dark[channel]);
        impulse.colors.push_back({light[0] - dark[0], light[1] - dark[1], light[2] - dark[2]});
    }
    impulse.decay = decay_curve(seconds, impulse.light);
    return impulse;
}
std::vector<std::size_t> measured_passes(const Look& look, const ImpulseRequest& request) {
    if (request.pass)
        return {*request.pass};
    std::vector<std::size_t> all(look.passes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}
}  // namespace

Result<ImpulseResponse> fire_impulse(Offline& offline, Extent size, const ImpulseRequest& request,
                                     JobProgress& work) {
    if (auto driven = drive(offline, size, request); !driven)
        return fail(driven.error());
    const Look& look = offline.executor().look();
    const bool has_source = look.driven_by == Driver::picture;
    ImpulseResponse response{size, request, {}, {}};
    const int watched = std::max(1, static_cast<int>(std::lround(request.seconds * request.fps)));
    const std::vector<std::size_t> measured = measured_passes(look, request);
    std::vector<std::vector<Numbers>> lights(measured.size());
    const int all = dark_frames + 1 + watched;
    for (int frame = 1; frame <= all; ++frame) {
        if (work.is_cancelled)
            return fail({{}, 0, "the impulse response was cancelled"});
        if (has_source && (frame == dark_frames + 1 || frame == dark_frames + 2))
            if (auto held =
                    offline.override_source(even(size, frame == dark_frames + 1 ? 1.0f : 0.0f));
                !held)
                return fail(held.error());
        request.pass ? offline.advance_unseen() : offline.advance();
        for (std::size_t i = 0; i < measured.size(); ++i)
            lights[i].push_back(light_at(offline, measured[i], request.pin));
        if (frame > dark_frames)
            response.seconds.push_back((frame - dark_frames - 1) / request.fps);
        work.share = static_cast<double>(frame) / all;
    }
    for (std::size_t i = 0; i < measured.size(); ++i)
        response.passes.push_back(
            impulse_of(look.passes[measured[i]].name, lights[i], response.seconds));
    return response;
}

Result<ImpulseResponse> fire_impulse(Document document, Extent picture,
                                     const ImpulseRequest& request, JobProgress& work) {
    const Extent size = size_to_compare(picture);
    auto offline = Offline::create({std::move(document), {}}, size, request.fps);
    if (!offline)
        return fail(offline.error());
    return fire_impulse(*offline, size, request, work);
}
