#pragma once

/// The displayed channels of a texture: all as a colour, or one as grey.
enum class Channels { color, red, green, blue, alpha, luminance };
