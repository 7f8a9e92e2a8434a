#pragma once

#include "model/look/look.h"

#include <string>

/// The size of a picture in GLSL.
struct HostSize {
    std::string pixels;       // a vec2
    std::string extent = {};  // width, height, 1/width, 1/height; "": from `pixels`
};

/// The values that a program gives to one pass, as expressions in GLSL.
class HostValues {
public:
    virtual ~HostValues() = default;

    virtual HostSize target() = 0;  // of the pass
    virtual HostSize output() = 0;  // of the whole picture
    virtual HostSize source() = 0;  // of what its look reads as the source
    virtual HostSize raster() = 0;  // columns and lines of the source
    virtual std::string aspect();   // width / height of the source as it is shown
    virtual HostSize input(const Input& input) = 0;
    virtual std::string frames_before() = 0;  // an int, 0 in the first frame
    virtual std::string time() = 0;           // at the end of the frame, s
    virtual std::string time_before() = 0;    // at its start, s
    virtual std::string time_delta() = 0;     // s
    virtual std::string date() = 0;           // year, month from 1, day, seconds: a vec4; "": none
    virtual std::string subframe_number() { return "1"; }  // an int, from 1
    virtual std::string subframes() { return "1"; }        // an int, per source frame
    virtual std::string press() { return {}; }  // see Press::numbers: a vec4; "": no mouse
};

/// The expression for a built-in value of a pass, as a `type`. What a program does not give, such
/// as the date, is 0.
std::string built_in_value(const BuiltInUniform& uniform, const NumberType& type, const Pass& pass,
                           HostValues& host);
