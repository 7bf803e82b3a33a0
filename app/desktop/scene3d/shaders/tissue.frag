#version 150
// Mucosa with vessels under a lamp beside the camera; or the plain cover; or, in high contrast, plain with height lines.
in vec3 place;
in vec3 normal;
in vec2 along;
in float light;

uniform vec3 eyePosition;
uniform vec3 lamp;       // towards the overhead lamp, unit
uniform sampler2D skin;  // r, g: slope of the wet film, b: blood in vessels, a: mottling
uniform vec4 plain;      // rgb of the cover, a: 1 = cover, 0 = tissue
uniform float outlined;  // 1: high contrast
uniform mat4 tips;       // xyz: drawn tip above the ground, w: 1 = throws a shadow
uniform mat4 presses;    // xyz: pressed point, w: 0..1 how hard
uniform int tools;
uniform vec4 lens;       // 2/width, 2/height of the picture, strength of the vignette

out vec4 colour;

void main()
{
    vec4 film = texture(skin, along);
    vec3 n = normalize(normal + (1.0 - plain.a) * vec3((film.rg - 0.5) * 0.55, 0.0));
    vec3 toEye = normalize(eyePosition - place);
    float head = max(0.0, dot(n, toEye));
    float above = 0.5 + 0.5 * dot(n, lamp);

    vec3 skinColour = mix(vec3(0.86, 0.46, 0.42), vec3(0.76, 0.33, 0.31), film.a);
    skinColour = mix(skinColour, vec3(0.50, 0.10, 0.12), film.b);
    vec3 base = mix(skinColour, plain.rgb, plain.a);

    float shadow = 1.0;
    for (int i = 0; i < tools; ++i) {
        vec3 p = presses[i].xyz - place;
        float near = max(0.0, 1.0 - dot(p, p) * 0.012) * presses[i].w;
        float ring = max(0.0, 1.0 - dot(p, p) * 0.0045) * presses[i].w;
        base = mix(base, base * vec3(0.72, 0.50, 0.52), 0.9 * ring * (1.0 - near)); // blood pushed aside
        base = mix(base, vec3(0.93, 0.76, 0.70), 0.75 * near);                     // blanched under the tip
        vec2 beside = tips[i].xy - place.xy;
        float height = max(0.0, tips[i].z - place.z);
        float wide = 3.2 + 0.10 * height;
        float blob = max(0.0, 1.0 - dot(beside, beside) / (wide * wide));
        shadow -= tips[i].w * blob * blob * 0.62 / (1.0 + 0.02 * height) * step(place.z - 2.0, tips[i].z);
    }

    float shade = light * (0.30 + 0.40 * above + 0.42 * head) * max(0.25, shadow);
    vec3 middle = normalize(toEye + lamp);
    float wet = max(0.0, dot(n, middle));
    wet *= wet; wet *= wet; wet *= wet; wet *= wet; wet *= wet; // to the 32nd
    float rim = (1.0 - head) * (1.0 - head);
    colour.rgb = base * shade + (1.0 - plain.a) * light * (0.55 * wet * wet * shadow + 0.16 * wet + rim * vec3(0.10, 0.04, 0.04));

    if (outlined > 0.5) {
        float line = abs(fract(place.z / 5.0 + 0.5) - 0.5) * 5.0;
        float drawn = (1.0 - smoothstep(0.18, 0.42, line)) * step(0.6, place.z);
        colour.rgb = mix(base * (0.55 + 0.45 * head) * max(0.2, shadow), vec3(0.05), drawn * (1.0 - plain.a));
    }
    vec2 off = gl_FragCoord.xy * lens.xy - 1.0;
    colour.rgb *= 1.0 - lens.z * dot(off, off);
    colour.a = 1.0;
}
