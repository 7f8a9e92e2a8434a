// Decay of the two phosphor layers. Passes that include this file share its sliders.
uniform float flash_decay = 0.6;       // @range 0.05 0.99  @limit 0.001 0.9999  @label "Flash decay"  @unit "per 1/60 s"  @group "Phosphor"
                                       // @help "Part of the flash that is left after 1/60 s."
uniform float afterglow_decay = 0.97;  // @range 0.5 0.999  @limit 0.001 0.9999  @label "Afterglow decay"  @unit "per 1/60 s"  @group "Phosphor"
                                       // @help "Part of the afterglow that is left after 1/60 s. The unit makes the slider logarithmic and lets you type a time."

// The part of a light of 1 that is left after some seconds, for both layers. It does not depend on
// the frame rate.
vec2 left_after(float seconds) {
    return pow(vec2(flash_decay, afterglow_decay), vec2(60.0 * seconds));
}

// How much of the stored light a layer emits in 1/60 s. A slow layer glows longer but dimmer.
vec2 emitted_share() {
    return -log(vec2(flash_decay, afterglow_decay));
}
