#version 150
// The tissue in high contrast: flat light, vessels, and height lines every 5 mm, at 2.5, 7.5, ...
in vec3 place;
in vec3 normal;
in vec2 along;
in vec2 press;
in vec2 light;

uniform sampler2D skin;
uniform mat4 tips;

out vec4 colour;

void main()
{
    vec4 film = texture(skin, along);
    vec3 base = mix(vec3(0.92, 0.56, 0.52), vec3(0.50, 0.10, 0.12), film.b);
    base = mix(base, vec3(0.98, 0.86, 0.80), 0.75 * press.x);
    float up = max(0.0, normal.z);
    float wide = 0.20 + 0.4 * up * up * up; // equally wide in the picture where the surface is flat
    float line = abs(fract(place.z / 5.0) - 0.5) * 5.0;
    colour = vec4(mix(vec3(0.05), base * light.y * shadowOf(place, tips), smoothstep(0.5 * wide, wide, line)), 1.0);
}
