#version 410 core
// Screen: the tube and its bloom, tone mapped once, inside the frame of the glass. Display values.
#include "as_written.glsl"
#include "barrel.glsl"
#include "color.glsl"
#include "glass.glsl"
#include "glass_settings.glsl"
#include "noise.glsl"
#include "tonemap.glsl"

uniform sampler2D tube;
uniform sampler2D bloom;
uniform vec2 u_resolution;
uniform int u_frame;
uniform float u_peak;

uniform float bloom_intensity = 0.35;  // @range 0 2  @limit 0 100  @label "Intensity"  @group "Bloom"  @identity 0  @photo amount
                                       // @help "How much of the blurred light is added. It also fills the dark parts of the mask. 0 turns the bloom off."
uniform float exposure = 1.0;          // @range 0.1 16  @limit 0 1000  @scale log  @label "Exposure"  @group "Tone mapping"  @identity 1  @when !as_written
                                       // @help "Brightness before tone mapping. Doubling it doubles the light."
uniform int tone_map = 0;              // @items "Clamp" "Reinhard" "ACES" "Extended Reinhard" "AgX" "Khronos PBR Neutral" "None"  @items_was "" "" "" "" "" "Khronos neutral"  @label "Tone map"  @group "Tone mapping"  @identity 6  @when !as_written
                                       // @help "How light brighter than the display is mapped to its range. With full brightness compensation, mask stripes are five times as bright as the picture. None passes the light on to the next look of a stack."
uniform float white = 4.0;             // @range 0.5 16  @limit 0.001 1000  @scale log  @label "White point"  @group "Tone mapping"  @when !as_written && tone_map == "Extended Reinhard"
                                       // @help "Light that Extended Reinhard maps to full white."
uniform float corner_radius = 0.04;    // @range 0 0.5  @limit 0 1  @label "Corner radius"  @unit "× half height"  @group "Glass"  @identity 0  @when !as_written
                                       // @help "Corner radius of the glass. 0 gives square corners, 1 equals half the picture height."
uniform vec3 border_color = vec3(0.0); // @color  @label "Frame colour"  @group "Glass"  @when !as_written
                                       // @help "Colour of the area outside the glass."
uniform bool dither = true;            // @label "Dither"  @group "Tone mapping"  @identity 0  @when !as_written
                                       // @help "Adds noise of half an 8-bit level, so that soft glows don't show bands."

in vec2 uv;
out vec4 color;

void main() {
    vec3 light = texture(tube, uv).rgb + bloom_intensity * texture(bloom, uv).rgb;
    if (as_written) {
        color = vec4(clamp(light, 0.0, 1.0), 1.0);
        return;
    }
    vec2 place = barrel_radial(2.0 * uv - 1.0, curvature);
    float glass = glass_coverage(place, u_resolution / u_resolution.y, corner_radius);
    float peak = tone_map == tone_map_reinhard_to_white ? white : 0.0;
    vec3 mapped = tone_mapped_to(light * exposure, tone_map, peak, u_peak);
    vec3 shown = mix(border_color, mapped, glass);
    vec3 display = srgb_encode_unbounded(shown);  // beyond 1 only without a tone map
    color = vec4(dither ? dithered(display, uvec2(gl_FragCoord.xy), uint(u_frame)) : display, 1.0);
}
