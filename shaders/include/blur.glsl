// A Gaussian blur along one direction. The weights add up to 1: light inside the picture stays as much.
#ifndef AFTERGLOW_BLUR
#define AFTERGLOW_BLUR

// `texel` is one texel of the image's `level` along the direction, `sigma` in texels. Two neighbours
// are read at once, between them where linear filtering weighs them right: D. Rakos, "Efficient
// Gaussian blur with linear sampling", 2010. In a finer level it would weigh what lies elsewhere.
vec3 gaussian_blur(sampler2D image, vec2 at, vec2 texel, float sigma, float level) {
    int reach = int(ceil(3.5 * sigma));
    vec3 sum = textureLod(image, at, level).rgb;
    float total = 1.0;
    for (int i = 1; i <= reach; i += 2) {
        float near = exp(-0.5 * float(i * i) / (sigma * sigma));
        float far = exp(-0.5 * float((i + 1) * (i + 1)) / (sigma * sigma));
        vec2 offset = (float(i) + far / (near + far)) * texel;
        sum += (near + far) * (textureLod(image, at + offset, level).rgb +
                               textureLod(image, at - offset, level).rgb);
        total += 2.0 * (near + far);
    }
    return sum / total;
}

#endif
