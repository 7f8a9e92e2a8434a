#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <string_view>

/// x' = a x + c y + e, y' = b x + d y + f, as in SVG's matrix(a b c d e f).
struct SvgTransform {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    SvgTransform operator*(const SvgTransform& inner) const;
    ScenePoint operator()(const ScenePoint& point) const;
};

/// Parses a `transform` attribute: a sequence of matrix, translate, scale, rotate, skewX and skewY.
Result<SvgTransform> parse_svg_transform(std::string_view text);
