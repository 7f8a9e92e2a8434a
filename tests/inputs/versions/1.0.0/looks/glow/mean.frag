#version 410 core
layout(location = 0) out vec4 color;
uniform sampler2D picture;
void main() { color = vec4(100.0 * textureLod(picture, vec2(0.5), 16.0).g); }
