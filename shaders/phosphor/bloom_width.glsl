// The bloom's width and its kind of blur.
#ifndef PHOSPHOR_BLOOM_WIDTH
#define PHOSPHOR_BLOOM_WIDTH

#include "as_written.glsl"
#include "reference_height.glsl"

uniform int bloom_kind = 1;  // @items "Taps" "Pyramid"  @label "Blur"  @group "Bloom"  @when bloom_intensity > 0
                             // @help "Pyramid blurs through a chain of half-size pictures and is equally fast at any width. Taps gives about the same glow: a Gaussian read tap by tap. It gets slower with the width and ends at the outermost tap. With the original article's formulas, it has the article's gaps."
uniform float bloom_radius = 3.0;  // @range 0.5 12  @limit 0.05 64  @label "Radius"  @unit "half-size px at 512 lines"  @group "Bloom"  @when bloom_intensity > 0  @photo amount
                                   // @help "How far the light spreads: the distance between two taps of the blur, in pixels of the half-size picture."
uniform float bloom_sigma = 1.64;  // @range 0.5 4  @limit 0.1 16  @label "Sigma"  @unit "taps"  @group "Bloom"  @when bloom_intensity > 0 && !as_written
                                   // @help "Standard deviation of the blur, in taps. The bloom's standard deviation is sigma × radius × 2 pixels of a picture 512 pixels high."

bool has_pyramid() {
    return bloom_kind == 1;
}

// Distance between taps, in texels of a bloom of this height.
float tap_texels(float height) {
    return bloom_radius * height / (0.5 * reference_height);
}

// Variance along one axis, in squared texels. That of the article's table is 2.6795 squared tap
// distances. Its taps are the same number of texels apart at every size.
float bloom_variance(float height) {
    const float variance_as_written = 2.6795;
    return as_written ? variance_as_written * bloom_radius * bloom_radius
                      : pow(bloom_sigma * tap_texels(height), 2.0);
}

#endif
