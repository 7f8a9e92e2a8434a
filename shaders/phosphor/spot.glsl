// The spot of the beam on the phosphor: two concentric Gaussians, a sharp core and a wider glow.
// The unit of length for sharpness is the beam width. Linear light.
#ifndef PHOSPHOR_SPOT
#define PHOSPHOR_SPOT

uniform vec3 beam_color = vec3(0.2, 1.0, 0.3);  // @color  @label "Beam colour"  @group "Beam"  @when as_written || tube == "Custom" || tube_color != "Tube default"
                                                // @help "Colour of the phosphor's light. Measured tubes have their own colour, unless Tube colour selects this one."
#ifndef DRIVEN_BY_PICTURE
uniform float beam_gain = 0.7;                  // @range 0.01 4  @limit 0 1000  @scale log  @label "Beam intensity"  @group "Beam"
                                                // @help "How much light the beam leaves on the phosphor. Slow and crowded parts of the trace get brighter, up to the brightness limit."
uniform float beam_width = 2.0;  // @range 0.5 12  @limit 0.05 64  @scale log  @label "Beam width"  @unit "px at 512 lines"  @group "Beam"  @photo amount
                                 // @help "Width of the beam's spot, in pixels of a picture 512 pixels high. It scales with the picture height, so every render size looks the same."
uniform float core_sharpness = 28.0;  // @range 4 80  @limit 0.5 1000  @scale log  @label "Core sharpness"  @group "Beam"
                                      // @help "Sharpness of the spot's bright core, exp(-sharpness r²) with r in beam widths. Higher is narrower. 28 has a standard deviation of 0.13 widths."
uniform float glow_sharpness = 8.0;   // @range 1 40  @limit 0.25 1000  @scale log  @label "Glow sharpness"  @group "Beam"  @when glow_weight > 0
                                      // @help "Sharpness of the soft glow around the core. Lower is wider. 8 has a standard deviation of 0.25 widths."
uniform float glow_weight = 0.3;      // @range 0 2  @limit 0 100  @label "Glow weight"  @group "Beam"  @identity 0
                                      // @help "Brightness of the glow relative to the core. 0 leaves only the core."

// Half the side of a square that contains more than 99.9 % of the spot: erf(2.7)^2 = 0.9997 of the
// wider Gaussian. At the square's edge it has fallen to 7e-4 of its peak.
float spot_reach() {
    float widest = glow_weight > 0.0 ? min(core_sharpness, glow_sharpness) : core_sharpness;
    return 2.7 / sqrt(widest);
}
#endif

#endif
