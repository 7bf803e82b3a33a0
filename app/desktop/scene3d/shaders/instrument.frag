#version 150
// Brushed steel and a black coat, lit by a ceiling of soft lamps that exists only as a formula.
in vec3 place;
in vec3 normal;
in float steel;

uniform vec3 eyePosition;
uniform vec3 lamp;
uniform float outlined; // 1: high contrast, with a bright edge
uniform vec4 tint; // rgb and opacity: a = 1 is the solid instrument, less is a ghost of this colour

out vec4 colour;

void main()
{
    vec3 n = normalize(normal);
    vec3 toEye = normalize(eyePosition - place);
    vec3 mirrored = reflect(-toEye, n);
    float head = max(0.0, dot(n, toEye));
    float ceiling = smoothstep(-0.1, 0.9, dot(mirrored, lamp));
    float glint = smoothstep(0.86, 0.99, dot(mirrored, normalize(lamp + toEye)));
    float edge = 1.0 - head;
    vec3 metal = vec3(0.40, 0.41, 0.43) + vec3(0.46, 0.48, 0.50) * ceiling + 0.35 * glint + 0.10 * edge;
    vec3 coat = vec3(0.085, 0.09, 0.10) + vec3(0.16, 0.17, 0.18) * ceiling + 0.22 * glint + 0.10 * edge * edge;
    vec3 own = mix(coat, metal, steel) * (0.55 + 0.45 * head);
    own = mix(own, vec3(0.95), outlined * smoothstep(0.35, 0.62, edge));
    vec3 ghost = tint.rgb * (0.55 + 0.45 * head) + 0.25 * edge;
    colour = vec4(mix(ghost, own, step(0.999, tint.a)), min(1.0, tint.a + 0.45 * edge * edge));
}
