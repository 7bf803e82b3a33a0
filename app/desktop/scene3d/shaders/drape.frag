#version 150
in vec3 shade;
in vec2 weave;

uniform vec4 lens;

out vec4 colour;

void main()
{
    vec2 thread = abs(fract(weave * 0.55) - 0.5);
    vec2 off = gl_FragCoord.xy * lens.xy - 1.0;
    colour = vec4(shade * (0.985 + 0.03 * (thread.x + thread.y)) * (1.0 - lens.z * dot(off, off)), 1.0);
}
