#version 150
in vec2 at;

uniform vec4 tint;

out vec4 colour;

void main()
{
    colour = tint;
}
