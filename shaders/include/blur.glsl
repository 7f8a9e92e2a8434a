// A Gaussian blur along one direction. The weights add up to 1, so light inside the picture is
// conserved.
#ifndef AFTERGLOW_BLUR
#define AFTERGLOW_BLUR

// `texel` is one texel of the image's `level` along the direction. `sigma` and `reach` are in
// texels. The blur ends `reach` texels away. One sample between two neighbours reads both, with
// their weights from linear filtering: D. Rakos, "Efficient Gaussian blur with linear sampling",
// 2010. In a finer level, the sample would read other texels. Each weight follows from the previous
// one by multiplication: K. Turkowski, "Incremental Computation of the Gaussian", GPU Gems 3,
// chapter 40.
vec3 gaussian_blur(sampler2D image, vec2 at, vec2 texel, float sigma, int reach, float level) {
    float fall = exp(-0.5 / (sigma * sigma));
    vec3 weight = vec3(1.0, fall, fall * fall);
    vec3 sum = textureLod(image, at, level).rgb;
    float total = 1.0;
    for (int i = 1; i <= reach; i += 2) {
        weight.xy *= weight.yz;
        float near = weight.x;
        weight.xy *= weight.yz;
        float far = i < reach ? weight.x : 0.0;
        float both = max(near + far, 1e-30);
        vec2 offset = (float(i) + far / both) * texel;
        sum += both * (textureLod(image, at + offset, level).rgb +
                       textureLod(image, at - offset, level).rgb);
        total += 2.0 * both;
    }
    return sum / total;
}

#endif
