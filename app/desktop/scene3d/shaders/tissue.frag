#version 150
// Mucosa with vessels under a lamp beside the camera. A software rasteriser executes both sides of every
// branch, so the cover and the high-contrast look are separate programs. TOOLS is the number of tips.
in vec3 place;
in vec3 normal;
in vec3 halfway;
in vec2 along;
in vec2 press;
in vec2 light;

uniform sampler2D skin;  // r, g: slope of the wet film, b: blood in vessels, a: mottling
uniform mat4 tips;       // xyz: drawn tip, w: 1 = casts a shadow

out vec4 colour;

void main()
{
    vec4 film = texture(skin, along);
    vec3 base = mix(vec3(0.86, 0.46, 0.42), vec3(0.76, 0.33, 0.31), film.a);
    base = mix(base, vec3(0.50, 0.10, 0.12), film.b);
    base *= 1.0 - vec3(0.25, 0.45, 0.43) * press.y;
    base = mix(base, vec3(0.93, 0.76, 0.70), 0.75 * press.x);
    float shadow = shadowOf(place, tips);
    vec3 n = normalize(normal + vec3(film.rg * 0.55 - 0.275, 0.0));
    float wet = max(0.0, dot(n, halfway));
    wet *= wet; wet *= wet; wet *= wet; wet *= wet; wet *= wet; // to the 32nd
    colour = vec4(base * (light.y * shadow) + light.x * wet * (0.16 + 0.55 * wet * shadow), 1.0);
}
