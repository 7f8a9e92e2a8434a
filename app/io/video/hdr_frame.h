#pragma once

#include "io/video/film_codec.h"
#include "model/picture/raw_picture.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// How the numbers of a picture give light.
struct StoredLight {
    Encoding encoding = Encoding::display;
    double unit = 203.0;  // cd/m2 of a light of 1
};

/// Makes the frames of an HDR film. Thread-safe.
class HdrFrames {
public:
    HdrFrames(const FilmHdr& hdr, const StoredLight& stored);

    /// RGB signals of BT.2020 with 16 bits (65535 is 1, low byte first), row 0 at the top. Light
    /// above the peak is clipped in each channel. Transparency is ignored.
    std::string bytes(const RawPicture& picture) const;

private:
    using Signals = std::array<std::uint16_t, 3>;
    Signals signals_of(const Rgb& nits) const;

    // By the bits of a half float, whose 11 bits of precision are finer than any signal.
    std::vector<double> m_nits;            // of a stored number, at most the peak
    std::vector<std::uint16_t> m_signals;  // PQ: of light in cd/m2. HLG: of scene light
    std::vector<double> m_gains;           // HLG: from display to scene light, by luminance
};
