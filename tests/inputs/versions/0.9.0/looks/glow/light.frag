#version 410 core
in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D before;
uniform sampler2D picture;
uniform float decay = 0.9;  // @range 0 1 @label "Decay" @unit "per frame" @was fade
void main() { color = max(texture(picture, uv), decay * texture(before, uv)); }
