#version 150
// A mark of one colour. Round marks may be drawn up to a share of a turn.
in vec2 at;

uniform vec4 tint;
uniform float share;

out vec4 colour;

void main()
{
    if (at.x > share)
        discard;
    colour = vec4(tint.rgb, 1.0); // 1: sharp, whatever the depth of field
}
