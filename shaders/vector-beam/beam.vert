#version 410 core
// The beam: a quad around each segment, large enough for its light.
#include "beam_segment.glsl"
#include "reference_height.glsl"
#include "tint.glsl"

uniform vec2 u_resolution;
uniform float intensity = 1.0;      // @range 0.05 10  @limit 0 1000  @scale log  @label "Beam intensity"  @group "Beam"
                                    // @help "Beam current. A higher current is brighter and, with Spot growth, also wider."
uniform float spot_sigma = 1.2;     // @range 0.3 6  @limit 0.05 100  @scale log  @label "Spot size"  @unit "px at 512 lines"  @group "Beam"  @photo amount
                                    // @help "Standard deviation of the spot, in pixels of a picture 512 pixels high. The line looks about 2.4 times as wide. The total light stays the same, so a wider spot is dimmer."
uniform float spot_growth = 0.4;    // @range 0 1.5  @limit 0 20  @label "Spot growth"  @group "Beam"  @identity 0  @when !as_written
                                    // @help "How much a stronger current widens the spot, as electrons repel each other. At full current, the spot is 1 + growth times as large. 0 turns it off."
uniform float growth_power = 0.5;   // @range 0.3 1  @limit 0.05 4  @label "Growth exponent"  @group "Beam"  @when !as_written && spot_growth > 0
                                    // @help "How the spot grows from no current to full current (1 × intensity). 1 is linear. 0.5 is the square root, so most of the growth comes early."
uniform float gun_gamma = 1.0;      // @range 1 3  @limit 0.2 6  @label "Gun gamma"  @group "Beam"  @identity 1  @when !as_written
                                    // @help "How the current follows the intensity of the signal: current = intensity ^ gamma. A real gun has 2 to 3, so an overdriven line is much brighter and wider. 1 is linear."
uniform float phosphor_saturation = 0.0;  // @range 0 2  @limit 0 100  @label "Phosphor saturation"  @group "Beam"  @identity 0  @when !as_written
                                          // @help "How much efficiency the phosphor loses with the current: light = current / (1 + saturation x current). At 1, full current gives half the light. 0 turns it off."
uniform float quad_sigmas = 5.0;    // @range 2 8  @limit 1 16  @label "Beam cutoff"  @unit "σ"  @group "Beam"
                                    // @help "Distance from the beam at which its light is cut off. The article's 5 shows no edge. Below 4, bright lines end visibly."
uniform float dwell = 1.0;          // @range 0 8  @limit 0 1000  @label "Dwell dots"  @group "Beam"  @identity 1  @when !as_written
                                    // @help "Brightness of the dots where the beam stops or slows down. 1 is physically correct, more emphasises corners and ends, 0 hides them."
uniform float dwell_speed = 20.0;   // @range 1 1000  @limit 0.001 1000000  @scale log  @label "Dwell speed"  @unit "screen heights/s"  @group "Beam"  @when !as_written && dwell != 1
                                    // @help "Beam speed below which the beam counts as stopped, for Dwell dots."
// Included here, because the panel lists parameters in declaration order and the beam's come first.
#include "decay.glsl"
uniform int fit = 0;                // @items "Keep circles round" "Fill the picture"  @label "Fit"  @group "Screen"
                                    // @help "Keep circles round draws both axes at the same scale. A wide picture then has margins. Fill the picture stretches the signal over the whole picture."
uniform float screen_size = 0.9;    // @range 0.5 1  @limit 0.05 4  @label "Size"  @unit "× picture size"  @group "Screen"
                                    // @help "How much of the picture the signal's range of -1 to 1 covers. 1 is all of it, less leaves a margin."
#include "as_written.glsl"

in vec4 segment;        // -1..1, y up: start, end
in vec2 intensities;    // 1: full current for 1/4096 of 1/60 s
in vec2 ages_seconds;   // time before the end of the frame: start, end
in vec3 tint;           // colour of the beam, white if its signal has none

flat out vec4 ends;     // px
flat out vec2 charges;  // light at start and end, px^2 of the picture
flat out vec2 ages;     // in decay times
flat out float sigma;   // px
flat out float seconds; // duration from start to end
flat out vec2 hue;      // see tint.glsl

const float full_current = 4096.0 * 60.0;  // intensity per second

float spot_at(float current) {
    float px = spot_sigma * u_resolution.y / reference_height;
    return as_written ? px : px * (1.0 + spot_growth * pow(current, growth_power));
}

// Light of the phosphor relative to the drive, for a beam of this current.
float overdrive(float drive, float beam) {
    return beam / max(drive, 1e-9) / (1.0 + phosphor_saturation * beam);
}

// Factor for the light of a beam that is slower than dwell_speed.
float dwell_gain(float way_px) {
    float speed = way_px / max(seconds * dwell_speed * u_resolution.y, 1e-12);
    return mix(1.0, dwell, exp(-speed * speed));
}

void main() {
    vec2 shape = fit == 1 ? vec2(1.0) : min(u_resolution.x, u_resolution.y) / u_resolution;
    ends = (0.5 + 0.5 * screen_size * shape.xyxy * segment) * u_resolution.xyxy;
    seconds = max(ages_seconds.x - ages_seconds.y, 0.0);
    ages = ages_seconds / decay_seconds();
    float current = 0.5 * abs(intensities.x + intensities.y) / max(seconds * full_current, 1e-9);
    float drive = intensity * current;
    float beam = as_written ? drive : pow(max(drive, 1e-9), gun_gamma);  // full current is 1
    sigma = spot_at(min(beam, 16.0));
    float unit = u_resolution.y / reference_height;
    hue = hue_of(tint);
    charges = intensity * unit * unit * strength_of(tint) * intensities;
    if (!as_written)
        charges *= dwell_gain(distance(ends.xy, ends.zw)) * overdrive(drive, beam);

    float reach = quad_sigmas * sigma + 0.71;
    vec2 corner = beam_segment_corner(ends.xy, ends.zw, reach, gl_VertexID);
    gl_Position = vec4(2.0 * corner / u_resolution - 1.0, 0.0, 1.0);
}
