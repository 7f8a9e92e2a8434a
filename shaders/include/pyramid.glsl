// A bloom whose cost does not depend on its width. Light goes down a pyramid of pictures, each half
// the size of the previous one, and back up. Linear light. A look has a pass for each step:
//   down: color = vec4(pyramid_reduced(larger, gl_FragCoord.xy), 1.0);
//   up:   color = vec4(pyramid_widened(own, smaller, gl_FragCoord.xy, share), 1.0);
// with share = pyramid_share(level, variance), and level 0 for the largest picture. Each picture
// has half the size of the larger one, rounded up. Inputs have linear filtering and the wrap
// "border". Both steps use the B-spline of degree 2 (1 3 3 1): P. J. Burt, "Fast filter transforms
// for image processing", 1981, and G. M. Chaikin, "An algorithm for high speed curve generation",
// 1974. It keeps the energy and the middle of a spot, for any position between the texels. The
// result has no dips.
#ifndef AFTERGLOW_PYRAMID
#define AFTERGLOW_PYRAMID

// Reads two texels in each direction with four samples. Each sample is between two texels, which
// get the weights 1 : 3.
vec3 pyramid_reduced(sampler2D larger, vec2 fragment) {
    vec2 texel = 1.0 / vec2(textureSize(larger, 0));
    vec2 at = 2.0 * fragment * texel;
    vec2 away = 0.75 * texel;
    return 0.25 * (texture(larger, at + vec2(-away.x, -away.y)).rgb +
                   texture(larger, at + vec2(away.x, -away.y)).rgb +
                   texture(larger, at + vec2(-away.x, away.y)).rgb +
                   texture(larger, at + vec2(away.x, away.y)).rgb);
}

// `share` of the light is from the smaller picture, the rest from this level on the way down.
vec3 pyramid_widened(sampler2D own, sampler2D smaller, vec2 fragment, float share) {
    vec3 wide = texture(smaller, 0.5 * fragment / vec2(textureSize(smaller, 0))).rgb;
    return mix(texelFetch(own, ivec2(fragment), 0).rgb, wide, share);
}

// Variance that a spot gains on the way down to a level and back, along one axis, in squared texels
// of level 0. Each step adds 3/4 of the square of a texel of the larger picture.
float pyramid_variance(int level) {
    return 0.5 * (exp2(2.0 * float(level)) - 1.0);
}

// The share that gives level 0 the wanted width: 1 for narrower levels, 0 for wider ones. In
// between, it is the fraction that gives the exact variance.
float pyramid_share(int level, float variance) {
    float here = pyramid_variance(level);
    return clamp((variance - here) / (pyramid_variance(level + 1) - here), 0.0, 1.0);
}

#endif
