#version 410 core
in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D before;
uniform sampler2D picture;
uniform float decay = 0.9;  // @range 0 1 @label "Decay" @unit "per frame" @group "Light" @was fade
uniform int subframes = 1;  // @range 1 4 @label "Sub-frames" @group "Light"
uniform int u_subframe;
void main() { color = u_subframe < subframes ? max(texture(picture, uv), decay * texture(before, uv)) : vec4(0.0); }
