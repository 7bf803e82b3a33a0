#version 150
// The urethra from outside, for the overview. CUT: its inner side where the near half is cut away; otherwise
// the near half as glass.
in vec3 eye;
in vec3 normal;
in vec2 spot;

uniform vec4 tint;  // rgb, opacity of glass seen straight on
uniform float rule; // number of lines across it per picture of the wall; 0: none

out vec4 colour;

void main()
{
    float facing = dot(normalize(normal), normalize(-eye));
#ifdef CUT
    if (facing < 0.0)
        discard;
    float line = rule > 0.0 ? smoothstep(0.03, 0.06, abs(fract(spot.y * rule) - 0.5) - 0.44) : 0.0;
    colour = vec4(tint.rgb * (0.38 + 0.62 * facing) * (1.0 - 0.35 * line), 1.0);
#else
    if (facing > 0.0)
        discard;
    float edge = 1.0 + facing;
    colour = vec4(tint.rgb * (0.75 + 0.25 * edge), tint.a + 0.65 * edge * edge * edge);
#endif
}
