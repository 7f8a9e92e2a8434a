#include "gpu/objects/gl_format.h"

#include <array>
#include <cassert>

namespace gpu {

namespace {
struct NamedFormat {
    Format format;
    GlFormat gl;
};

constexpr auto gl_formats = std::to_array<NamedFormat>({
    {Format::r8, {GL_R8, GL_RED, GL_UNSIGNED_BYTE}},
    {Format::rg8, {GL_RG8, GL_RG, GL_UNSIGNED_BYTE}},
    {Format::rgba8, {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE}},
    {Format::srgb8_alpha8, {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE}},
    {Format::rgb10_a2, {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV}},
    {Format::r11f_g11f_b10f, {GL_R11F_G11F_B10F, GL_RGB, GL_FLOAT}},
    {Format::r16f, {GL_R16F, GL_RED, GL_FLOAT}},
    {Format::rg16f, {GL_RG16F, GL_RG, GL_FLOAT}},
    {Format::rgba16f, {GL_RGBA16F, GL_RGBA, GL_FLOAT}},
    {Format::r32f, {GL_R32F, GL_RED, GL_FLOAT}},
    {Format::rg32f, {GL_RG32F, GL_RG, GL_FLOAT}},
    {Format::rgba32f, {GL_RGBA32F, GL_RGBA, GL_FLOAT}},
    {Format::r32ui, {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT}},
    {Format::r8ui, {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE}},
    {Format::rg8ui, {GL_RG8UI, GL_RG_INTEGER, GL_UNSIGNED_BYTE}},
    {Format::rgba8ui, {GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE}},
    {Format::rgb10_a2ui, {GL_RGB10_A2UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT_2_10_10_10_REV}},
    {Format::r16ui, {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT}},
    {Format::rg16ui, {GL_RG16UI, GL_RG_INTEGER, GL_UNSIGNED_SHORT}},
    {Format::rgba16ui, {GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT}},
    {Format::rg32ui, {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT}},
    {Format::rgba32ui, {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT}},
    {Format::r32i, {GL_R32I, GL_RED_INTEGER, GL_INT}},
    {Format::r8i, {GL_R8I, GL_RED_INTEGER, GL_BYTE}},
    {Format::rg8i, {GL_RG8I, GL_RG_INTEGER, GL_BYTE}},
    {Format::rgba8i, {GL_RGBA8I, GL_RGBA_INTEGER, GL_BYTE}},
    {Format::r16i, {GL_R16I, GL_RED_INTEGER, GL_SHORT}},
    {Format::rg16i, {GL_RG16I, GL_RG_INTEGER, GL_SHORT}},
    {Format::rgba16i, {GL_RGBA16I, GL_RGBA_INTEGER, GL_SHORT}},
    {Format::rg32i, {GL_RG32I, GL_RG_INTEGER, GL_INT}},
    {Format::rgba32i, {GL_RGBA32I, GL_RGBA_INTEGER, GL_INT}},
});
}  // namespace

GlFormat gl_format(Format format) {
    const NamedFormat& found = gl_formats[static_cast<std::size_t>(format)];
    assert(found.format == format);
    return found.gl;
}

}  // namespace gpu
