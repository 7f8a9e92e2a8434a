#include "io/video/hdr_frame.h"

#include "model/look/color.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace {
constexpr std::size_t halves = 65536;

double stored_light(double number, Encoding encoding) {
    if (!(number > 0.0))  // NaN too
        return 0.0;
    return encoding == Encoding::display ? srgb_decode(number) : number;
}

std::size_t half_bits(double number) {
    return glm::packHalf1x16(static_cast<float>(number));
}

std::uint16_t word_of(double signal) {
    return static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(signal, 0.0, 1.0)));
}

double number_of_half(std::size_t bits) {
    const auto number = static_cast<double>(number_of(static_cast<std::uint16_t>(bits)));
    return std::isnan(number) ? 0.0 : number;
}
}  // namespace

HdrFrames::HdrFrames(const FilmHdr& hdr, const StoredLight& stored)
    : m_nits(halves), m_signals(halves) {
    const double peak = hdr.light.peak;
    for (std::size_t bits = 0; bits < halves; ++bits) {
        const double number = number_of_half(bits);
        m_nits[bits] = std::min(stored.unit * stored_light(number, stored.encoding), peak);
        m_signals[bits] =
            word_of(hdr.transfer == HdrTransfer::pq ? pq_encode(number) : hlg_oetf(number));
    }
    if (hdr.transfer == HdrTransfer::pq)
        return;
    m_gains.resize(halves);
    for (std::size_t bits = 0; bits < halves; ++bits)
        m_gains[bits] = hlg_scene_gain(number_of_half(bits), peak);
}

HdrFrames::Signals HdrFrames::signals_of(const Rgb& nits) const {
    const Rgb light = bt2020_of_bt709(nits);
    const double gain = m_gains.empty() ? 1.0 : m_gains[half_bits(bt2020_luminance(light))];
    Signals signals{};
    for (std::size_t i = 0; i < signals.size(); ++i)
        signals[i] = m_signals[half_bits(light[i] * gain)];
    return signals;
}

std::string HdrFrames::bytes(const RawPicture& picture) const {
    const auto channels = static_cast<std::size_t>(picture.channels);
    const std::size_t green = channels < 3 ? 0 : 1;
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(picture.extent.width) *
                  static_cast<std::size_t>(picture.extent.height) * 6);
    const auto put = [&](const auto* from) {
        const auto nits = [&](std::size_t channel) {
            return m_nits[half_bits(static_cast<double>(number_of(from[channel])))];
        };
        for (const std::uint16_t signal : signals_of({nits(0), nits(green), nits(2 * green)})) {
            bytes += static_cast<char>(signal & 255u);
            bytes += static_cast<char>(signal >> 8u);
        }
    };
    std::visit(
        [&](const auto& numbers) {
            for (int y = picture.extent.height - 1; y >= 0; --y)
                for (int x = 0; x < picture.extent.width; ++x)
                    put(&numbers[static_cast<std::size_t>(y) * picture.row_length() +
                                 static_cast<std::size_t>(x) * channels]);
        },
        picture.pixels);
    return bytes;
}
