#version 150
in vec3 normal;
in vec3 halfway;
in vec2 along;
in vec4 light;

uniform sampler2D skin;  // r, g: slope of the wet film, b: blood in vessels, a: mottling
uniform vec4 pale;       // rgb; a: how visible its vessels are
uniform vec4 deep;       // rgb; a: how wet it is
uniform float outlined;  // 1: high contrast, with a dark edge
#ifdef GLASS
uniform float opacity;   // transparent except at its edge
#endif

out vec4 colour;

void main()
{
    vec4 film = texture(skin, along);
    vec3 base = mix(pale.rgb, deep.rgb, film.a);
    base = mix(base, vec3(0.52, 0.10, 0.12), film.b * pale.a);
    base = mix(base, vec3(0.99, 0.91, 0.85), 0.75 * max(0.0, light.z));
    base = mix(base, vec3(0.55, 0.05, 0.06), max(0.0, -light.z));
    vec3 n = normalize(normal + vec3(film.rg * 0.4 - 0.2, 0.0));
    float wet = max(0.0, dot(n, halfway));
    wet *= wet; wet *= wet; wet *= wet; wet *= wet; wet *= wet; // to the 32nd
    vec3 lit = base * light.y + deep.a * light.x * wet * (0.16 + 0.55 * wet);
#ifdef GLASS
    float there = mix(opacity, 1.0, 0.45 * smoothstep(0.55, 0.9, 1.0 - light.w));
#else
    float there = 1.0;
#endif
    colour = vec4(lit * (1.0 - outlined * smoothstep(0.55, 0.78, 1.0 - light.w)), there);
}
