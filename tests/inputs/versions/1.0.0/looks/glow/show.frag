#version 410 core
in vec2 uv;
layout(location = 0) out vec4 color;
uniform sampler2D light;
uniform vec3 tint = vec3(1.0);  // @color @label "Tint" @group "Picture"
void main() { color = vec4(tint, 1.0) * texture(light, uv); }
