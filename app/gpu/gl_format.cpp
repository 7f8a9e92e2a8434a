#include "gpu/gl_format.h"

namespace gpu {

GlFormat gl_format(Format format) {
    switch (format) {
        case Format::r8:
            return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
        case Format::rg8:
            return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE};
        case Format::rgba8:
            return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case Format::srgb8_alpha8:
            return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case Format::rgb10_a2:
            return {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV};
        case Format::r11f_g11f_b10f:
            return {GL_R11F_G11F_B10F, GL_RGB, GL_FLOAT};
        case Format::r16f:
            return {GL_R16F, GL_RED, GL_FLOAT};
        case Format::rg16f:
            return {GL_RG16F, GL_RG, GL_FLOAT};
        case Format::rgba16f:
            return {GL_RGBA16F, GL_RGBA, GL_FLOAT};
        case Format::r32f:
            return {GL_R32F, GL_RED, GL_FLOAT};
        case Format::rg32f:
            return {GL_RG32F, GL_RG, GL_FLOAT};
        case Format::rgba32f:
            return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
        case Format::r32ui:
            return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT};
        case Format::r8ui:
            return {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE};
        case Format::rg8ui:
            return {GL_RG8UI, GL_RG_INTEGER, GL_UNSIGNED_BYTE};
        case Format::rgba8ui:
            return {GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE};
        case Format::rgb10_a2ui:
            return {GL_RGB10_A2UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT_2_10_10_10_REV};
        case Format::r16ui:
            return {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT};
        case Format::rg16ui:
            return {GL_RG16UI, GL_RG_INTEGER, GL_UNSIGNED_SHORT};
        case Format::rgba16ui:
            return {GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT};
        case Format::rg32ui:
            return {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT};
        case Format::rgba32ui:
            return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    }
    return {};
}

}  // namespace gpu
