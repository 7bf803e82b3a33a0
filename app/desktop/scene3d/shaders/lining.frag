#version 150
// Wet mucosa in the light of the endoscope's own lamp, seen by its camera in a round picture that is darker
// towards its edge.
in vec3 normal;
in vec3 across;
in vec3 along;
in vec3 toLamp;
in vec3 halfway;
in vec3 reach;
in vec2 spot;

uniform sampler2D skin;   // r, g: slope across and along, b: blood in vessels, a: mottling
uniform vec4 disc;        // gl_FragCoord.xy * xy + zw = −1..1 over the picture
uniform vec3 pale;
uniform vec3 red;
uniform vec3 blood;
uniform float wet;        // strength of the highlight
#ifdef FOCUS
uniform sampler2D blurred; // the same picture, smaller, each pixel blurred over its circle of confusion
#endif

out vec4 colour;          // a: 1 = sharp, 0 = the largest circle of confusion

void main()
{
    vec4 film = texture(skin, spot);
    vec3 n = normalize(normal + (film.r - 0.5) * across + (film.g - 0.5) * along);
    float lit = max(0.0, 0.82 * dot(n, toLamp) + 0.18) * reach.x;
    float glint = max(0.0, dot(n, halfway));
    glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint; glint *= glint; // to the 64th
    vec3 base = mix(mix(pale, red, film.a), blood, film.b);
    // Light that enters beside a point leaves at it, and it is red.
    vec3 light = base * lit + vec3(0.30, 0.045, 0.035) * reach.y + wet * glint * min(1.3, reach.x);
    light = light * 1.06 / (light * 0.80 + 0.42); // the camera's response curve
    vec2 q = gl_FragCoord.xy * disc.xy + disc.zw;
    float r2 = dot(q, q);
    float edge = clamp((0.992 - r2) * 83.0, 0.0, 1.0);
    light *= (1.0 - 0.30 * r2 * r2) * edge;
#ifdef FOCUS
    light = mix(light, texture(blurred, 0.5 * q + 0.5).rgb, clamp((1.0 - reach.z) * 7.0 - 0.4, 0.0, 1.0));
    colour = vec4(light * edge, 1.0);
#else
    colour = vec4(light, reach.z);
#endif
}
