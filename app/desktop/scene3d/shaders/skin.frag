#version 150
// Silicone, mucosa over a gland, or skin with an areola, under a lamp beside the camera. Inserted before it:
// TOOLS, shadowOf(); MAP (the map lies on it), LUMPS (the number of balls seen through it), OUTLINED (high
// contrast: flat light and height lines at a fixed distance in mm).
in vec3 place;
in vec3 normal;
in vec3 halfway;
in vec2 along;
in vec2 press;
in vec2 light;

uniform sampler2D skin;  // r, g: slope of the film, b: blood in vessels, a: mottling
uniform mat4 tips;
uniform vec4 pale;       // rgb; a: how visible its vessels are
uniform vec4 deep;       // rgb; a: how wet it is
uniform vec4 areola;     // x, y: centre, z: radius (1e-3: none), w: grain of the film, 0..1
#ifdef MAP
uniform sampler2D surfaceMap;
uniform vec2 mapScale;   // 1 / size of the search area, 1/mm
#endif
#ifdef LUMPS
uniform mat4 lumpsNear;  // xyz: centre, w: radius; below 0: not found
uniform mat4 lumpsFar;
uniform vec3 eyePosition;

// Colour and opacity of a ball seen through the surface along the line of sight.
vec4 throughTo(vec4 lump, vec3 way, vec4 over)
{
    vec3 to = lump.xyz - place;
    float ahead = dot(to, way);
    float size = max(0.01, lump.w * lump.w);
    float inside = 1.0 - (dot(to, to) - ahead * ahead) / size;
    float body = smoothstep(0.0, 0.10, inside) * step(0.0001, abs(lump.w));
    float rim = 1.0 - smoothstep(0.10, 0.30, inside);
    float stripe = step(lump.w, 0.0) * step(0.5, fract((to.x - to.y) * 0.30));
    vec3 ball = mix(vec3(0.34, 0.10, 0.16), vec3(0.66, 0.30, 0.36), sqrt(max(0.0, inside)));
    ball = mix(mix(ball, vec3(0.98, 0.94, 0.88), 0.75 * stripe), vec3(0.16, 0.03, 0.06), rim);
    float share = body * mix(0.62, 0.92, rim);
    return mix(over, vec4(ball, 1.0), share);
}
#endif

out vec4 colour;

void main()
{
    vec4 film = texture(skin, along);
    vec3 base = mix(pale.rgb, deep.rgb, film.a);
    base = mix(base, vec3(0.50, 0.12, 0.14), film.b * pale.a);
    vec2 off = place.xy - areola.xy;
    float away = dot(off, off) / (areola.z * areola.z);
    base = mix(base, vec3(0.62, 0.36, 0.31) + 0.10 * film.a, 0.85 * (1.0 - smoothstep(0.70, 1.06, away + 0.25 * (film.a - 0.5))));
    base *= 1.0 - vec3(0.16, 0.30, 0.28) * press.y;
    base = mix(base, vec3(0.97, 0.87, 0.80), 0.65 * press.x);
#ifdef MAP
    vec2 at = place.xy * mapScale;
    vec4 map = texture(surfaceMap, vec2(at.x + 0.5, 0.5 - at.y));
    map.a *= step(abs(at.x), 0.5) * step(abs(at.y), 0.5);
    base = mix(base, map.rgb, map.a);
#endif
#ifdef LUMPS
    vec3 way = normalize(place - eyePosition);
    vec4 seen = vec4(base, 1.0);
    for (int i = 0; i < 3; ++i)
        seen = throughTo(lumpsNear[i], way, seen);
#if LUMPS > 3
    for (int i = 0; i < 3; ++i)
        seen = throughTo(lumpsFar[i], way, seen);
#endif
    base = seen.rgb;
#endif
    float shadow = shadowOf(place, tips);
#ifdef OUTLINED
    float pixel = max(1e-4, fwidth(place.z)); // keeps the line equally wide in the picture on every slope
    float line = abs(fract(place.z / OUTLINED) - 0.5) * OUTLINED / pixel;
    float level = smoothstep(0.9996, 0.9985, normal.z); // no line on flat surfaces
    colour = vec4(mix(base * light.y * shadow, vec3(0.05), level * (1.0 - smoothstep(0.7, 1.5, line))), 1.0);
#else
    vec3 n = normalize(normal + areola.w * vec3(film.rg - 0.5, 0.0));
    float wet = max(0.0, dot(n, halfway));
    wet *= wet; wet *= wet; wet *= wet; wet *= wet; wet *= wet; // to the 32nd
    colour = vec4(base * (light.y * shadow) + deep.a * light.x * wet * (0.16 + 0.55 * wet * shadow), 1.0);
#endif
}
