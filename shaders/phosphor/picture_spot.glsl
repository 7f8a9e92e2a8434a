// The spot with which the tube draws a source picture: a Gaussian.
#ifndef PHOSPHOR_PICTURE_SPOT
#define PHOSPHOR_PICTURE_SPOT

#include "blur.glsl"
#include "reference_height.glsl"

uniform float spot_size = 0.7;  // @range 0 4  @limit 0 32  @label "Spot size"  @unit "px at 512 lines"  @group "Beam"  @identity 0
                                // @help "Standard deviation of the spot that draws the picture, in pixels of a picture 512 pixels high. It scales with the picture height. 0 keeps the picture's pixels sharp."

// `texel` is a pixel of a picture of this height, in texture coordinates of the image.
vec3 drawn_by_spot(sampler2D image, vec2 at, vec2 texel, float height) {
    float sigma = spot_size * height / reference_height;
    if (sigma < 0.1)
        return texture(image, at).rgb;
    return gaussian_blur(image, at, texel, sigma, int(ceil(3.0 * sigma)), 0.0);
}

#endif
