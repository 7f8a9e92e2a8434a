// The spot that the beam makes on the phosphor: two Gaussians around one middle, a sharp core and a
// wider glow. Sharpness counts lengths in widths of the spot. Linear light.
#ifndef PHOSPHOR_SPOT
#define PHOSPHOR_SPOT

uniform vec3 beam_color = vec3(0.2, 1.0, 0.3);  // @color  @label "Colour"  @group "Beam"
                                                // @help "The colour in which the phosphor glows. A measured tube has a colour of its own unless Tube colour says otherwise."
uniform float beam_gain = 0.7;                  // @range 0.01 4  @limit 0 1000  @scale log  @label "Beam strength"  @group "Beam"
                                                // @help "How much light the beam leaves behind. More makes crowded and slow parts of the trace brighter, up to the ceiling."
uniform float beam_width = 2.0;  // @range 0.5 12  @limit 0.05 64  @scale log  @label "Beam width"  @unit "px at 512 lines"  @group "Beam"
                                 // @help "How wide the spot is that the beam makes, in pixels of a picture 512 pixels high; larger pictures scale it, so that every size looks the same."
uniform float core_sharpness = 28.0;  // @range 4 80  @limit 0.5 1000  @scale log  @label "Core sharpness"  @group "Beam"
                                      // @help "How narrow the bright middle of the spot is: the core is exp(-sharpness r r), r in beam widths. 28 has a standard deviation of 0.13 widths."
uniform float glow_sharpness = 8.0;   // @range 1 40  @limit 0.25 1000  @scale log  @label "Glow sharpness"  @group "Beam"
                                      // @help "How narrow the soft light around the core is. Smaller is wider; 8 has a standard deviation of 0.25 widths."
uniform float glow_weight = 0.3;      // @range 0 2  @limit 0 100  @label "Glow weight"  @group "Beam"  @identity 0
                                      // @help "How bright the soft light around the core is, next to the core. 0 leaves the core alone."

// Half the side of a square that holds more than 99.9 % of the spot: erf(2.7)^2 = 0.9997 of the wider
// Gaussian, which has fallen to 7e-4 of its peak where the square ends.
float spot_reach() {
    float widest = glow_weight > 0.0 ? min(core_sharpness, glow_sharpness) : core_sharpness;
    return 2.7 / sqrt(widest);
}

#endif
