#include "model/picture/encoding_curve.h"

#include "model/look/color.h"

#include <algorithm>

EncodingCurve::EncodingCurve(double (*formula)(double)) : m_formula(formula), m_table(steps + 2) {
    for (int i = 0; i < steps + 2; ++i)
        m_table[static_cast<std::size_t>(i)] =
            static_cast<float>(formula(static_cast<double>(i) / steps));
}

const EncodingCurve* curve_between(Encoding from, Encoding to) {
    static const EncodingCurve encode(srgb_encode);
    static const EncodingCurve decode(srgb_decode);
    if (from == to)
        return nullptr;
    return to == Encoding::display ? &encode : &decode;
}

void recode(Picture& picture, Encoding wanted) {
    const EncodingCurve* curve = curve_between(picture.encoding, wanted);
    picture.encoding = wanted;
    if (!curve)
        return;
    const auto channels = static_cast<std::size_t>(picture.channels);
    const std::size_t colors = std::min<std::size_t>(channels, 3);
    for (std::size_t pixel = 0; pixel < picture.pixels.size(); pixel += channels)
        for (std::size_t c = 0; c < colors; ++c)
            picture.pixels[pixel + c] = (*curve)(picture.pixels[pixel + c]);
}
