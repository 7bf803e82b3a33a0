#version 150
// Painted text on the black of a picture that is switched off.
in vec2 at;

uniform sampler2D face;

out vec4 colour;

void main()
{
    colour = vec4(texture(face, vec2(at.x, 1.0 - at.y)).rgb, 1.0);
}
