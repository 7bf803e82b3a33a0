#version 150
// Arrow, lines and pins. Their colour carries information, so light changes it little.
in vec3 place;
in vec3 normal;
in float steel;

uniform vec3 eyePosition;
uniform vec4 tint;

out vec4 colour;

void main()
{
    float head = max(0.0, dot(normalize(normal), normalize(eyePosition - place)));
    vec3 own = tint.rgb * (0.62 + 0.38 * head);
    // A light edge, visible on any background.
    colour = vec4(mix(own, vec3(1.0), 0.65 * smoothstep(0.58, 0.85, 1.0 - head)), tint.a);
}
